// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speed against accuracy of filter methods on the stored distribution, as ratios to the reference
// loop within one run: bench_filters [--faces small|large] [rounds] [methods...], e.g.
// bench_filters --faces large 5 probes-2:32. Without --faces, a table for each.
#include "core/filter/filter_method.h"
#include "core/study/test_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>
#include <vector>

using namespace trixel;

namespace {

constexpr std::string_view kReference = "reference-loop";

struct Row
{
    std::string name;
    std::unique_ptr<const FilterMethod> method;
    double nanoseconds = 1e30; ///< a query, the best round, mean of both contents
    double squares = 0;
    std::vector<double> errors;
    double taps = 0;
};

double threadSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Runs until the time can be measured; nanoseconds a query.
double timed(const FilterMethod& method, const TestScene& scene, ResultArrays& results)
{
    const double begin = threadSeconds();
    int runs = 0;
    double spent = 0;
    do {
        method.filter(scene.scene, scene.queries.queries(), results.results());
        ++runs;
        spent = threadSeconds() - begin;
    } while (spent < 0.01);
    return 1e9 * spent / (runs * static_cast<double>(scene.queries.size()));
}

void judge(Row& row, const TestScene& scene, const ResultArrays& results)
{
    for (std::size_t k = 0; k < scene.exact.size(); ++k) {
        const double error = double(results.values[k]) - double(scene.exact[k]);
        row.squares += error * error;
        row.errors.push_back(std::abs(error));
    }
    for (const std::uint32_t taps : results.taps) {
        row.taps += taps;
    }
}

std::vector<Row> rowsOf(std::span<char* const> names)
{
    std::vector<Row> rows;
    const auto add = [&](const MethodChoice& choice) {
        rows.push_back({toText(choice), makeMethod(choice), 1e30, 0, {}, 0});
    };
    if (findMethod(kReference) != nullptr) {
        add({std::string(kReference), std::nullopt});
    }
    for (const char* name : names) {
        const auto choice = parseMethod(name);
        if (!choice) {
            std::fprintf(stderr, "%s\n", choice.error().message.c_str());
            std::exit(2);
        }
        add(*choice);
    }
    if (names.empty()) {
        add({"lattice-linear", std::nullopt});
        for (const char* name : {"probes-1", "probes-2"}) {
            for (const double probes : findMethod(name)->parameter->curve) {
                add({name, probes});
            }
        }
    }
    return rows;
}

std::vector<TestScene> scenesOf(const TestData& data, TestFaces faces)
{
    std::vector<TestScene> scenes;
    NoProgress progress;
    for (const TestContent content : kTestContents) {
        const TestPatch patch(kAllQueriesTiles, faces);
        scenes.push_back(*buildTestScene(data, content, patch, Threads{1}, progress));
        std::printf("%s, %s faces: %zu queries; mips %.1f MB, pyramid %.1f MB\n",
                    std::string(nameOf(content)).c_str(),
                    std::string(nameOf(faces)).c_str(),
                    scenes.back().queries.size(),
                    double(scenes.back().scene.mips().memoryBytes()) / 1e6,
                    double(scenes.back().scene.pyramid().memoryBytes()) / 1e6);
    }
    return scenes;
}

void measure(std::vector<Row>& rows, const std::vector<TestScene>& scenes, int rounds)
{
    std::vector<std::vector<double>> best(rows.size(), std::vector<double>(scenes.size(), 1e30));
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t r = 0; r < rows.size(); ++r) {
            for (std::size_t s = 0; s < scenes.size(); ++s) {
                ResultArrays results(scenes[s].queries.size(), scenes[s].scene.channels());
                best[r][s] = std::min(best[r][s], timed(*rows[r].method, scenes[s], results));
                if (round == 0) {
                    judge(rows[r], scenes[s], results);
                }
            }
        }
    }
    for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r].nanoseconds = 0;
        for (const double each : best[r]) {
            rows[r].nanoseconds += each / double(scenes.size());
        }
    }
}

void print(std::vector<Row>& rows, std::size_t samples)
{
    std::printf("%-18s %9s %8s %8s %8s %8s\n", "method", "ns", "ratio", "rms %", "p99 %", "taps");
    double reference = 0;
    for (Row& row : rows) {
        reference = row.name == kReference ? row.nanoseconds : reference;
        const std::size_t at = row.errors.size() * 99 / 100;
        std::ranges::nth_element(row.errors, row.errors.begin() + std::ptrdiff_t(at));
        std::printf("%-18s %9.1f %8.1f %8.3f %8.2f %8.1f\n",
                    row.name.c_str(),
                    row.nanoseconds,
                    reference / row.nanoseconds,
                    100 * std::sqrt(row.squares / double(row.errors.size())),
                    100 * row.errors[at],
                    row.taps / double(samples));
    }
}

/// The sizes asked for; their words are taken out of the arguments.
std::vector<TestFaces> facesOf(std::vector<char*>& arguments)
{
    if (arguments.empty() || std::string_view(arguments[0]) != "--faces") {
        return {kTestFaces.begin(), kTestFaces.end()};
    }
    for (const TestFaces faces : kTestFaces) {
        if (arguments.size() > 1 && arguments[1] == nameOf(faces)) {
            arguments.erase(arguments.begin(), arguments.begin() + 2);
            return {faces};
        }
    }
    std::fprintf(stderr, "--faces: expected small or large.\n");
    std::exit(2);
}

} // namespace

int main(int count, char** words)
{
    std::vector<char*> arguments(words + 1, words + count);
    const std::vector<TestFaces> sizes = facesOf(arguments);
    const int rounds = arguments.empty() ? 5 : std::max(1, std::atoi(arguments[0]));
    const std::span names = std::span(arguments).subspan(arguments.empty() ? 0 : 1);
    const auto data = parseTestData(storedTestFiles());
    if (!data) {
        std::fprintf(stderr, "%s\n", data.error().message.c_str());
        return 2;
    }
    for (const TestFaces faces : sizes) {
        std::vector<Row> rows = rowsOf(names);
        const std::vector<TestScene> scenes = scenesOf(*data, faces);
        measure(rows, scenes, rounds);
        print(rows, scenes.size() * scenes[0].queries.size());
    }
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A .ptx of 1 GiB: to a coarse picture's data without reading the faces, and reading all of it.
// Writes the file to the temporary folder and removes it; `bench_on_demand [MIB [LOG2]]` takes
// another size of file and faces, `bench_on_demand write PATH [MIB [LOG2]]` only writes the file,
// for trying the window on it.
#include "core/base/parallel.h"
#include "core/io/project.h"
#include "core/texture/value_histogram.h"
#include "tests/bench/large_ptx.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

using namespace trixel;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
constexpr OpenOptions kAtOnce{.wholeBytes = ~std::uint64_t{0}};

fs::path largeFile()
{
    return fs::temp_directory_path() / ("trixel-large-" + std::to_string(::getpid()) + ".ptx");
}

double residentMiB()
{
    std::ifstream status("/proc/self/statm");
    std::uint64_t size = 0;
    std::uint64_t resident = 0;
    status >> size >> resident;
    return static_cast<double>(resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE))) /
           static_cast<double>(kMiB);
}

/// As after a start of the machine: the file's pages are dropped from memory.
void forget(const fs::path& path)
{
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    ::fdatasync(fd);
    ::posix_fadvise(fd, 0, 0, POSIX_FADV_DONTNEED);
    ::close(fd);
}

void openToMeans(benchmark::State& state)
{
    NoProgress silent;
    const bool isCold = state.range(0) != 0;
    for (auto _ : state) {
        if (isCold) {
            state.PauseTiming();
            forget(largeFile());
            state.ResumeTiming();
        }
        const Project project = openPtx(largeFile(), silent).value();
        unsigned sum = 0;
        for (std::uint32_t f = 0; f < project.texels.faceCount(); ++f) {
            sum += static_cast<unsigned>(project.texels.face(faceId(f)).mean()->front());
        }
        benchmark::DoNotOptimize(sum);
        state.counters["RSS_MiB"] = residentMiB();
        state.counters["read_MiB"] =
            static_cast<double>(project.storedFaces->readBytes()) / static_cast<double>(kMiB);
    }
}

/// And every face at a level of 32 by 32 texels, as a view from afar wants it.
void openToCoarseLevel(benchmark::State& state)
{
    NoProgress silent;
    const bool isCold = state.range(0) != 0;
    for (auto _ : state) {
        if (isCold) {
            state.PauseTiming();
            forget(largeFile());
            state.ResumeTiming();
        }
        const Project project = openPtx(largeFile(), silent).value();
        parallelFor(project.texels.faceCount(), 16, Threads::all(), [&](auto begin, auto end) {
            for (std::size_t f = begin; f < end; ++f) {
                const FaceTexels& face = project.texels.face(faceId(f));
                const auto coarse = face.storedLevel(std::min(Level(5), face.level().coarser()));
                benchmark::DoNotOptimize(coarse);
            }
        });
        state.counters["RSS_MiB"] = residentMiB();
    }
}

void loadAllFaces(benchmark::State& state)
{
    NoProgress silent;
    const Project project = openPtx(largeFile(), silent).value();
    for (auto _ : state) {
        parallelFor(project.texels.faceCount(), 1, Threads::all(), [&](auto begin, auto end) {
            for (std::size_t f = begin; f < end; ++f) {
                benchmark::DoNotOptimize(project.texels.face(faceId(f)).pinned().bytes().data());
            }
        });
    }
    state.counters["RSS_MiB"] = residentMiB();
    state.SetBytesProcessed(static_cast<std::int64_t>(project.texels.storedBytes()) *
                            static_cast<std::int64_t>(state.iterations()));
}

void histogramOfAll(benchmark::State& state)
{
    NoProgress silent;
    const Project project = openPtx(largeFile(), silent).value();
    for (auto _ : state) {
        const auto counted =
            countValues(project.texels, std::vector<TexelNumber>(1), Threads::all(), silent);
        benchmark::DoNotOptimize(counted->front().summary().total);
    }
    state.counters["RSS_MiB"] = residentMiB();
}

void openAtOnce(benchmark::State& state)
{
    NoProgress silent;
    for (auto _ : state) {
        const Project project = openPtx(largeFile(), silent, kAtOnce).value();
        state.counters["RSS_MiB"] = residentMiB();
        state.SetBytesProcessed(static_cast<std::int64_t>(project.texels.storedBytes()));
    }
}

} // namespace

BENCHMARK(openToMeans)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("cold")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);
BENCHMARK(openToCoarseLevel)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("cold")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(3);
BENCHMARK(loadAllFaces)->Unit(benchmark::kMillisecond)->Iterations(1)->MeasureProcessCPUTime();
BENCHMARK(histogramOfAll)->Unit(benchmark::kMillisecond)->Iterations(1)->MeasureProcessCPUTime();
BENCHMARK(openAtOnce)->Unit(benchmark::kMillisecond)->Iterations(1)->MeasureProcessCPUTime();

int main(int count, char** arguments)
{
    const bool isWriter = count > 2 && std::string_view(arguments[1]) == "write";
    const int first = isWriter ? 3 : 1;
    const auto number = [&](int k, int otherwise) {
        const int value = first + k < count ? std::atoi(arguments[first + k]) : 0;
        return value > 0 ? value : otherwise;
    };
    const fs::path path = isWriter ? fs::path(arguments[2]) : largeFile();
    const auto bytes = static_cast<std::uint64_t>(number(0, 1024)) * kMiB;
    if (const Status written = writeLargePtx(path, bytes, number(1, 9)); !written) {
        std::fprintf(stderr, "%s\n", written.error().message.c_str());
        return 1;
    }
    std::printf("%s: %.0f MiB\n",
                path.c_str(),
                static_cast<double>(fs::file_size(path)) / static_cast<double>(kMiB));
    if (!isWriter) {
        benchmark::Initialize(&count, arguments);
        benchmark::RunSpecifiedBenchmarks();
        fs::remove(path);
    }
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/filter_input.h"
#include "app/cli/study/studies.h"
#include "core/study/seam_meter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string file;
    std::optional<std::string> mesh;
    std::optional<std::string> method;
    std::string output;
};

/// What one method came to.
struct Row
{
    std::string method;
    SeamSummary summary;
    std::uint64_t samples = 0;
    std::uint64_t refused = 0;
};

Result<std::vector<MethodChoice>> methodsOf(const Arguments& arguments)
{
    if (arguments.method) {
        return parseMethod(*arguments.method).map([](MethodChoice&& choice) {
            return std::vector{std::move(choice)};
        });
    }
    std::vector<MethodChoice> all;
    for (const MethodEntry& entry : filterMethods()) {
        all.push_back({std::string(entry.name), std::nullopt});
    }
    return all;
}

void printRow(const Row& row)
{
    std::cout << std::left << std::setw(24) << row.method << std::right << std::setprecision(3);
    for (const double jump : {row.summary.worst, row.summary.p99, row.summary.median}) {
        std::cout << std::setw(12) << 100 * jump;
    }
    std::cout << std::setw(10) << row.summary.broken << " of " << row.summary.edges;
    if (row.refused > 0) {
        std::cout << "  (" << row.refused << " comparisons refused)";
    }
    std::cout << std::endl; // as soon as it is known
}

std::string csvOf(const std::vector<Row>& rows)
{
    std::ostringstream text;
    text << "method,edges,broken,worst,p99,p90,median,mean,samples,refused\n";
    for (const Row& row : rows) {
        const SeamSummary& s = row.summary;
        text << row.method << ',' << s.edges << ',' << s.broken << ',' << s.worst << ',' << s.p99
             << ',' << s.p90 << ',' << s.median << ',' << s.mean << ',' << row.samples << ','
             << row.refused << '\n';
    }
    return text.str();
}

std::string jsonOf(const std::vector<Row>& rows, const std::string& subject, double range)
{
    nlohmann::json methods = nlohmann::json::array();
    for (const Row& row : rows) {
        const SeamSummary& s = row.summary;
        methods.push_back({{"method", row.method},
                           {"edges", s.edges},
                           {"broken", s.broken},
                           {"worst", s.worst},
                           {"p99", s.p99},
                           {"p90", s.p90},
                           {"median", s.median},
                           {"mean", s.mean},
                           {"samples", row.samples},
                           {"refused", row.refused}});
    }
    return nlohmann::json{{"study", "seams"},
                          {"subject", subject},
                          {"range", range},
                          {"seamless", kSeamless},
                          {"methods", std::move(methods)}}
               .dump(2) +
           '\n';
}

/// A method's name as part of a file's: "probes-1:16" has a sign that some systems refuse.
std::string fileNameOf(const MethodChoice& choice)
{
    std::string name = "seams-" + toText(choice) + ".csv";
    std::ranges::replace(name, ':', '-');
    return name;
}

Result<Outcome> seams(const Arguments& arguments, Progress& progress)
{
    const auto methods = methodsOf(arguments);
    if (!methods) {
        return tl::unexpected(methods.error());
    }
    StageProgress opening(progress, 0, 0.2);
    std::optional<std::filesystem::path> mesh;
    if (arguments.mesh) {
        mesh = *arguments.mesh;
    }
    const auto scene = openFilterScene(arguments.file, mesh, opening);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    const std::string subject = std::filesystem::path(arguments.file).filename().string();
    std::cout << "Jumps across the edges of " << subject << ", % of the value range\n"
              << std::left << std::setw(24) << "" << std::right << std::setw(12) << "worst"
              << std::setw(12) << "p99" << std::setw(12) << "median"
              << "  seams (over " << 100 * kSeamless << " %)" << std::endl;
    std::vector<Row> rows;
    double range = 0;
    Status written;
    for (std::size_t m = 0; m < methods->size() && written; ++m) {
        const double share = 0.8 / static_cast<double>(methods->size());
        StageProgress measuring(progress,
                                0.2 + share * static_cast<double>(m),
                                0.2 + share * static_cast<double>(m + 1));
        const auto method = makeMethod((*methods)[m]);
        const auto report = measureSeams(**scene, *method, {}, Threads::all(), measuring);
        if (!report) {
            return tl::unexpected(report.error());
        }
        range = report->range;
        rows.push_back(
            {toText((*methods)[m]), summarize(report->jumps), report->samples, report->refused});
        printRow(rows.back());
        if (arguments.method) {
            written = writeText(arguments.output, fileNameOf((*methods)[m]), toCsv(*report));
        }
    }
    written = written ? writeText(arguments.output, "seams.csv", csvOf(rows)) : written;
    written =
        written ? writeText(arguments.output, "seams.json", jsonOf(rows, subject, range)) : written;
    return written.map([] { return Outcome::Done; });
}

} // namespace

void addSeams(CLI::App& verb, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* name =
        verb.add_subcommand("seams", "The jump of each filter across every edge of a mesh");
    name->add_option("FILE", arguments->file, "Project, .ptx or mesh")
        ->required()
        ->type_name("FILE");
    name->add_option("-o,--output", arguments->output, "Folder to write into")
        ->required()
        ->type_name("DIR");
    name->add_option("--mesh", arguments->mesh, "Mesh to put a .ptx on")->type_name("FILE");
    name->add_option("--method",
                     arguments->method,
                     "This filter alone, with a table of every edge; without it, all of them")
        ->type_name("NAME");
    name->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return seams(*arguments, progress); };
    });
}

} // namespace trixel::app

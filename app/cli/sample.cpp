// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/file_kind.h"
#include "app/cli/filter_input.h"
#include "app/cli/verb.h"
#include "core/base/read_file.h"
#include "core/filter/filter_method.h"
#include "core/io/query_csv.h"
#include "core/study/speed/auto_method.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <set>

namespace trixel::app {
namespace {

struct Arguments
{
    std::string file;
    std::optional<std::string> mesh;
    std::string queries;
    std::string method;
    std::optional<std::string> tolerance;
    std::string output;
    std::optional<std::string> threads;
};

constexpr std::string_view kAuto = "auto";
constexpr double kUsualTolerance = 0.01;

/// Stands where a query would have taken more taps than its method allows itself.
constexpr std::string_view kAverage = "average";

Outcome listMethods()
{
    for (const MethodEntry& method : filterMethods()) {
        std::cout << std::left << std::setw(22) << method.name << method.about << '\n';
        if (const auto& parameter = method.parameter) {
            std::cout << std::setw(22) << "" << method.name << ":N sets " << parameter->name << ", "
                      << parameter->least << " to " << parameter->most << " (else "
                      << parameter->standard << "): " << parameter->meaning << '\n';
        }
    }
    std::cout << std::setw(22) << kAuto
              << "For each footprint the fastest of these that keeps within --tolerance on its "
                 "kind, as measured on this machine.\n";
    return Outcome::Done;
}

/// What --method help can do without, nothing else can.
Status expectAll(const Arguments& arguments)
{
    const std::pair<std::string_view, const std::string*> needed[] = {
        {"FILE", &arguments.file},
        {"--queries", &arguments.queries},
        {"--output", &arguments.output}};
    for (const auto& [name, value] : needed) {
        if (value->empty()) {
            return contentsError("trixel sample: " + std::string(name) +
                                 " is required ('trixel sample --help' explains).");
        }
    }
    return {};
}

/// A filter and what to call it, query by query.
struct Chosen
{
    std::unique_ptr<const FilterMethod> method;
    std::function<std::string(const FilterScene&, const FilterQueries&, std::size_t)> nameOf;
};

Result<Chosen> chooseAuto(double tolerance, Progress& progress)
{
    auto method = makeAuto(tolerance, progress);
    if (!method) {
        return prefixed("--method auto", method.error());
    }
    const AutoMethod* choices = method->get();
    return Chosen{std::move(*method),
                  [choices](const FilterScene& scene, const FilterQueries& queries, std::size_t i) {
                      return toText(choices->choiceFor(scene, queries, i));
                  }};
}

Result<Chosen> chooseMethod(const Arguments& arguments, Progress& progress)
{
    if (arguments.method == kAuto) {
        const auto tolerance = arguments.tolerance
                                   ? positiveNumber("--tolerance", *arguments.tolerance)
                                   : Result<double>(kUsualTolerance);
        return tolerance ? chooseAuto(*tolerance, progress) : tl::unexpected(tolerance.error());
    }
    if (arguments.tolerance) {
        return contentsError("--tolerance: only the method 'auto' takes one, found '" +
                             arguments.method + "'.");
    }
    const auto choice = parseMethod(arguments.method);
    if (!choice) {
        return prefixed("--method", choice.error());
    }
    return Chosen{makeMethod(*choice),
                  [name = toText(*choice)](const FilterScene&, const FilterQueries&, std::size_t) {
                      return name;
                  }};
}

/// Answers some thousands at a time, so that progress is shown and the work can be stopped.
Status answer(const FilterMethod& method,
              const FilterScene& scene,
              const FilterQueries& queries,
              Threads threads,
              ResultArrays& results,
              Progress& progress)
{
    constexpr std::size_t kAtOnce = 4096;
    const FilterResults all = results.results();
    for (std::size_t begin = 0; begin < queries.size(); begin += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, queries.size() - begin);
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(queries.size()))) {
            return cancelled();
        }
        FilterResults part = all;
        part.values = all.values.subspan(begin);
        part.levels = all.levels.subspan(begin, count);
        part.taps = all.taps.subspan(begin, count);
        filterParallel(method, scene, queries.subspan(begin, count), part, threads);
    }
    return {};
}

Status writeAnswers(const Arguments& arguments,
                    const FilterScene& scene,
                    const Chosen& chosen,
                    const QueryCsv& csv,
                    const ResultArrays& results)
{
    const FilterQueries queries = csv.queries.queries();
    std::set<std::string> names; // keeps what the views see
    std::vector<std::string_view> methods;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        methods.push_back(results.taps[i] == kRefusedTaps
                              ? kAverage
                              : *names.insert(chosen.nameOf(scene, queries, i)).first);
    }
    const auto text = withSamples(
        csv, {results.values, queries.size(), scene.channels(), results.levels, methods});
    if (!text) {
        return prefixed(arguments.queries, text.error());
    }
    return writeCsv(arguments.output, *text);
}

Result<Outcome> sample(const Arguments& arguments, Progress& progress)
{
    if (arguments.method == "help") {
        return listMethods();
    }
    if (const Status complete = expectAll(arguments); !complete) {
        return tl::unexpected(complete.error());
    }
    const auto count = threads("--threads", arguments.threads);
    if (!count) {
        return tl::unexpected(count.error());
    }
    StageProgress choosing(progress, 0, 0.2);
    const auto chosen = chooseMethod(arguments, choosing);
    if (!chosen) {
        return tl::unexpected(chosen.error());
    }
    if (fileKindOf(arguments.file) == FileKind::Mesh) {
        return contentsError(arguments.file +
                             ": a mesh has no texels to sample; expected a .ptx or a .trixel.");
    }
    const auto text = readFile(arguments.queries);
    if (!text) {
        return tl::unexpected(text.error());
    }
    StageProgress opening(progress, 0.2, 0.4);
    const auto scene = openFilterScene(arguments.file, arguments.mesh, opening);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    const auto csv = parseQueryCsv(*text, (*scene)->faceCount());
    if (!csv) {
        return prefixed(arguments.queries, csv.error());
    }
    ResultArrays results(csv->queries.size(), (*scene)->channels());
    StageProgress answering(progress, 0.4, 1);
    const Status answered =
        answer(*chosen->method, **scene, csv->queries.queries(), *count, results, answering);
    if (!answered) {
        return tl::unexpected(answered.error());
    }
    return writeAnswers(arguments, **scene, *chosen, *csv, results).map([] {
        return Outcome::Done;
    });
}

} // namespace

void addSample(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("sample", "Filter at given points");
    verb->add_option("FILE", arguments->file, "Project, or .ptx with or without its mesh")
        ->type_name("FILE");
    verb->add_option("--mesh", arguments->mesh, "Mesh of a .ptx; else the one it carries, if any")
        ->type_name("FILE");
    verb->add_option("--queries",
                     arguments->queries,
                     "Table (CSV) with the columns face, u, v, uw1, vw1, uw2, vw2")
        ->type_name("FILE");
    verb->add_option("--method",
                     arguments->method,
                     "Filter, with its parameter after a colon; 'help' lists all")
        ->required()
        ->type_name("NAME");
    verb->add_option(
            "--tolerance",
            arguments->tolerance,
            "RMS error that 'auto' may make, a fraction of the value range; 0.01 by default")
        ->type_name("E");
    verb->add_option("-o,--output", arguments->output, "Table to write (CSV)")->type_name("FILE");
    verb->add_option("--threads",
                     arguments->threads,
                     "Threads to use, all cores by default; the result is the same")
        ->type_name("N");
    verb->footer("The table is repeated with a column for each channel (c0, c1, ...), then the\n"
                 "method and the level that was read. The method is 'average' where the footprint\n"
                 "would take more texels than the method allows itself: then the face's average\n"
                 "stands there. A .ptx without a mesh is filtered as if its faces were\n"
                 "equilateral.");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return sample(*arguments, progress); };
    });
}

} // namespace trixel::app

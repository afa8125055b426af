// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include "app/cli/file_kind.h"
#include "app/cli/terminal_progress.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <new>

namespace trixel::app {
namespace {

constexpr const char* kDescription =
    "Trixel paints and inspects Ptex triangle textures.\n"
    "Without a verb it opens its window, on FILE if one is given: trixel [FILE]\n"
    "FILE is a mesh (.obj, .ply, .stl, .off), a .ptx or a .trixel project.";

constexpr const char* kFooter =
    "'trixel VERB --help' explains a verb.\n"
    "Exit status: 0 done, 1 faults found (check, diff), 2 unusable contents or arguments,\n"
    "3 a path that cannot be read or written.";

constexpr AddVerb kVerbs[] = {addNew,
                              addInfo,
                              addCheck,
                              addPaint,
                              addLayers,
                              addBake,
                              addBakeOut,
                              addTransfer,
                              addExport,
                              addConvert,
                              addDiff,
                              addMatch,
                              addSample,
                              addStudy,
                              addFit};

/// One line, whatever the message holds: file names may contain line breaks.
std::string onOneLine(std::string text)
{
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
        text.pop_back();
    }
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    return text;
}

std::vector<const CLI::App*> allVerbs(const CLI::App& parser)
{
    return parser.get_subcommands([](const CLI::App*) { return true; });
}

bool knowsVerb(const CLI::App& parser, const std::string& name)
{
    const auto verbs = allVerbs(parser);
    return std::any_of(
        verbs.begin(), verbs.end(), [&](const CLI::App* verb) { return verb->check_name(name); });
}

std::string verbNames(const CLI::App& parser)
{
    std::string names;
    for (const CLI::App* verb : allVerbs(parser)) {
        names += (names.empty() ? "" : ", ") + verb->get_name();
    }
    return names;
}

void setUp(CLI::App& parser, std::span<const AddVerb> furtherVerbs, Work& chosen)
{
    for (const AddVerb add : kVerbs) {
        add(parser, chosen);
    }
    for (const AddVerb add : furtherVerbs) {
        add(parser, chosen);
    }
    for (CLI::App* verb : parser.get_subcommands([](CLI::App*) { return true; })) {
        verb->group("Verbs");
    }
    parser.footer(kFooter); // after the verbs, which would inherit it
    parser.set_version_flag("--version", "trixel " TRIXEL_VERSION, "Print the version and exit");
    parser.get_formatter()->label("SUBCOMMAND", "VERB");
}

using WindowFile = std::optional<std::filesystem::path>;

/// The file that the window is to open; nothing at all where the command line names a verb or an
/// option. Fails for what is neither a verb nor a file that could be opened.
std::optional<Result<WindowFile>>
windowFile(const CLI::App& parser, int argc, const char* const* argv)
{
    if (argc < 2) {
        return WindowFile();
    }
    const std::string name = argv[1];
    if (name.starts_with('-') || knowsVerb(parser, name)) {
        return std::nullopt;
    }
    std::error_code unreadable;
    const bool exists = std::filesystem::exists(name, unreadable);
    if (!exists && !fileKindOf(name)) {
        return contentsError("trixel: '" + name + "' is neither a verb nor a file; the verbs are " +
                             verbNames(parser) + ".");
    }
    if (argc > 2) {
        return contentsError("trixel: expected one file, found '" + std::string(argv[2]) +
                             "' after '" + name + "'.");
    }
    if (!exists) {
        return pathError(name + ": there is no such file.");
    }
    return expectFileKind(name).map([&](FileKind) { return WindowFile(name); });
}

int showWindow(const WindowFile& file, const OpenWindow& openWindow)
{
    if (!openWindow) {
        return reportError({ErrorKind::Contents,
                            "trixel: this build has no window ('trixel --help' lists verbs)."});
    }
    return openWindow(file);
}

/// Says what an unusable command line lacks; the verb's own help is named as the way on.
Error argumentError(const CLI::App& parser, const std::string& complaint)
{
    const auto verbs = parser.get_subcommands(); // those that the command line names
    const std::string verb = verbs.empty() ? "trixel" : "trixel " + verbs.front()->get_name();
    std::string sentence = onOneLine(complaint);
    if (!sentence.empty() && sentence.back() == '.') {
        sentence.pop_back();
    }
    return Error{ErrorKind::Contents,
                 verb + ": " + sentence + " ('" + verb + " --help' explains)."};
}

/// Library code that runs out of memory or throws must still end in a sentence.
Result<Outcome> guarded(const Work& work, Progress& progress)
{
    try {
        return work(progress);
    } catch (const std::bad_alloc&) {
        return contentsError("There is not enough memory for this.");
    } catch (const std::exception& e) {
        return contentsError(std::string("This failed unexpectedly: ") + e.what());
    }
}

int perform(const Work& work)
{
    Result<Outcome> outcome = Outcome::Done;
    {
        TerminalProgress progress;
        outcome = guarded(work, progress);
    }
    if (!outcome) {
        return reportError(outcome.error());
    }
    std::cout.flush();
    if (!std::cout) {
        return reportError({ErrorKind::Path, "Standard output cannot be written."});
    }
    return *outcome == Outcome::Done ? kDone : kFaultsFound;
}

} // namespace

int reportError(const Error& error)
{
    std::cerr << onOneLine(error.message) << '\n';
    switch (error.kind) {
    case ErrorKind::Contents:
        return kUnusable;
    case ErrorKind::Path:
        return kPathTrouble;
    case ErrorKind::Cancelled:
        break;
    }
    return kInterrupted;
}

int runCommandLine(int argc,
                   const char* const* argv,
                   std::span<const AddVerb> furtherVerbs,
                   const OpenWindow& openWindow)
{
    CLI::App parser(kDescription, "trixel");
    Work chosen;
    setUp(parser, furtherVerbs, chosen);
    if (const auto file = windowFile(parser, argc, argv)) {
        return *file ? showWindow(**file, openWindow) : reportError(file->error());
    }
    try {
        parser.parse(argc, argv);
    } catch (const CLI::Success& request) { // --help, --version
        return parser.exit(request, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        return reportError(argumentError(parser, error.what()));
    }
    if (!chosen) {
        return reportError(
            {ErrorKind::Contents, "trixel: expected a verb: " + verbNames(parser) + "."});
    }
    return perform(chosen);
}

} // namespace trixel::app

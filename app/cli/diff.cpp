// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/file_kind.h"
#include "app/cli/output.h"
#include "app/cli/verb.h"
#include "core/io/ptx_diff.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace trixel::app {
namespace {

// People read the first few; programs take --json.
constexpr std::size_t kFacesShown = 20;

struct Arguments
{
    std::string a;
    std::string b;
    bool json = false;
};

/// JSON has no infinity: where a value is NaN on one side only, it says so in a word.
nlohmann::json jsonOf(double value)
{
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json("infinite");
}

nlohmann::json jsonOf(const PtxFaceDifference& face)
{
    return {{"face", indexOf(face.face)},
            {"levelOfA", face.levelOfA.log2()},
            {"levelOfB", face.levelOfB.log2()},
            {"texels", face.texels},
            {"maxAbs", jsonOf(face.maxAbs)},
            {"rms", jsonOf(face.rms)}};
}

nlohmann::json jsonOf(const PtxDiff& diff)
{
    nlohmann::json faces = nlohmann::json::array();
    for (const PtxFaceDifference& face : diff.faces) {
        faces.push_back(jsonOf(face));
    }
    return {{"equal", diff.isEqual()},
            {"incomparable", diff.incomparable},
            {"notes", diff.notes},
            {"levelDifferences", diff.levelDifferences},
            {"texels", diff.texels},
            {"maxAbs", jsonOf(diff.maxAbs)},
            {"rms", jsonOf(diff.rms)},
            {"peak", diff.peak},
            {"psnr", jsonOf(diff.psnr())},
            {"faces", std::move(faces)}};
}

void printFace(const PtxFaceDifference& face)
{
    std::cout << "face " << indexOf(face.face) << ": ";
    if (face.levelOfA != face.levelOfB) {
        std::cout << "level " << face.levelOfA.log2() << " against " << face.levelOfB.log2()
                  << '\n';
        return;
    }
    std::cout << counted(face.texels, "texel") << ", at most " << face.maxAbs << ", rms "
              << face.rms << '\n';
}

void print(const PtxDiff& diff)
{
    if (diff.isEqual()) {
        std::cout << "No differences.\n";
        return;
    }
    if (!diff.incomparable.empty()) {
        std::cout << diff.incomparable << '\n';
        return;
    }
    for (const std::string& note : diff.notes) {
        std::cout << note << '\n';
    }
    if (diff.faces.empty()) {
        return;
    }
    for (std::size_t i = 0; i < std::min(diff.faces.size(), kFacesShown); ++i) {
        printFace(diff.faces[i]);
    }
    if (diff.faces.size() > kFacesShown) {
        std::cout << "... and " << counted(diff.faces.size() - kFacesShown, "more face") << '\n';
    }
    std::cout << "In all " << counted(diff.faces.size(), "face") << " ("
              << grouped(diff.levelDifferences) << " of another level), "
              << counted(diff.texels, "texel") << ", at most " << diff.maxAbs << ", rms "
              << diff.rms << ", psnr " << diff.psnr() << " dB\n";
}

Result<Outcome> diffFiles(const Arguments& arguments, Progress& progress)
{
    for (const std::string& name : {arguments.a, arguments.b}) {
        if (const Status ending = expectEnding(name, FileKind::Ptx); !ending) {
            return tl::unexpected(ending.error());
        }
    }
    const auto diff = diffPtx(arguments.a, arguments.b, progress);
    if (!diff) {
        return tl::unexpected(diff.error());
    }
    if (arguments.json) {
        printJson(jsonOf(*diff));
    } else {
        print(*diff);
    }
    return diff->isEqual() ? Outcome::Done : Outcome::FaultsFound;
}

} // namespace

void addDiff(CLI::App& parser, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* verb = parser.add_subcommand("diff", "Compare two .ptx face by face");
    verb->add_option("A", arguments->a, "A .ptx")->required()->type_name("FILE");
    verb->add_option("B", arguments->b, "Another .ptx")->required()->type_name("FILE");
    verb->add_flag("--json", arguments->json, "Print one JSON object, every face in it");
    verb->footer("Values are compared as numbers: integers stand for [0,1]. Exit status 1 says\n"
                 "that the files differ.");
    verb->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return diffFiles(*arguments, progress); };
    });
}

} // namespace trixel::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/speed_accuracy.h"

#include "app/cli/arguments.h"
#include "app/cli/filter_input.h"
#include "app/cli/study/studies.h"
#include "core/study/speed/peers/peers.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>

namespace trixel::app {
namespace {

struct Arguments
{
    std::optional<std::string> file;
    std::optional<std::string> mesh;
    std::string output;
    std::string samples = "1000";
    std::string seed = "1";
    std::string rounds = "5";
    std::string limit = "4";
    std::string faces{trixel::nameOf(TestFaces::Small)};
};

struct Numbers
{
    int samples = 0;
    std::uint64_t seed = 0;
    TestFaces faces = TestFaces::Small;
    SpeedAccuracyOptions options;
};

Result<TestFaces> facesNamed(std::string_view name)
{
    const auto found = std::ranges::find_if(
        kTestFaces, [&](TestFaces faces) { return trixel::nameOf(faces) == name; });
    if (found == kTestFaces.end()) {
        return contentsError("--faces: expected small or large, found '" + std::string(name) +
                             "'.");
    }
    return *found;
}

Result<Numbers> numbersOf(const Arguments& arguments)
{
    constexpr std::int64_t kMost = 1'000'000;
    const auto samples = wholeNumber("--samples", arguments.samples, 1, kMost);
    const auto seed = wholeNumber("--seed", arguments.seed, 0, INT64_MAX);
    const auto rounds = wholeNumber("--rounds", arguments.rounds, 1, 1000);
    const auto limit = positiveNumber("--limit", arguments.limit);
    for (const auto* number : {&samples, &seed, &rounds}) {
        if (!*number) {
            return tl::unexpected(number->error());
        }
    }
    if (!limit) {
        return tl::unexpected(limit.error());
    }
    const auto faces = facesNamed(arguments.faces);
    if (!faces) {
        return tl::unexpected(faces.error());
    }
    Numbers numbers{static_cast<int>(*samples), static_cast<std::uint64_t>(*seed), *faces, {}};
    numbers.options.rounds = static_cast<int>(*rounds);
    numbers.options.secondsAtMost = *limit;
    numbers.options.secondsOfRounds = *limit;
    return numbers;
}

struct Subjects
{
    std::vector<StudySubject> subjects;
    std::vector<std::string> notes;
};

Result<Subjects> subjectsOf(const Arguments& arguments, const Numbers& numbers, Progress& progress)
{
    if (!arguments.file) {
        return storedSubjects({kStudyTiles, numbers.faces}, Threads::all(), progress)
            .map([](std::vector<StudySubject>&& subjects) {
                return Subjects{std::move(subjects), {}};
            });
    }
    StageProgress opening(progress, 0, 0.4);
    auto scene = openFilterScene(*arguments.file, arguments.mesh, opening);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    StageProgress judging(progress, 0.4, 1);
    std::uint64_t refused = 0;
    auto subject = subjectOn(std::move(*scene),
                             std::filesystem::path(*arguments.file).filename().string(),
                             numbers.samples,
                             numbers.seed,
                             Threads::all(),
                             judging,
                             &refused);
    if (!subject) {
        return tl::unexpected(subject.error());
    }
    if (subject->queries.size() == 0) {
        return contentsError(*arguments.file + ": there is no footprint to measure on.");
    }
    Subjects made;
    made.subjects.push_back(std::move(*subject));
    if (refused > 0) {
        made.notes.push_back("exact refused " + std::to_string(refused) +
                             " footprints; nobody is measured on them.");
    }
    return made;
}

Result<Outcome> study(const Arguments& arguments, Progress& progress)
{
    const auto numbers = numbersOf(arguments);
    if (!numbers) {
        return tl::unexpected(numbers.error());
    }
    StageProgress preparing(progress, 0, 0.2);
    const auto subjects = subjectsOf(arguments, *numbers, preparing);
    if (!subjects) {
        return tl::unexpected(subjects.error());
    }
    Contestants contestants = tableContestants(subjects->subjects);
    StageProgress inviting(progress, 0.2, 0.3);
    auto peers = makePeers(subjects->subjects, peerFolder(), inviting);
    if (!peers) {
        return tl::unexpected(peers.error());
    }
    std::ranges::move(peers->contestants, std::back_inserter(contestants));
    StageProgress measuring(progress, 0.3, 1);
    UnwatchedPoints watcher(measuring);
    auto measured =
        measureSpeedAccuracy(subjects->subjects, contestants, numbers->options, watcher);
    if (!measured) {
        return tl::unexpected(measured.error());
    }
    measured->notes.insert(measured->notes.begin(), subjects->notes.begin(), subjects->notes.end());
    measured->notes.insert(measured->notes.end(), peers->notes.begin(), peers->notes.end());
    printStudy(*measured);
    return writeStudy(*measured, arguments.output).map([] { return Outcome::Done; });
}

} // namespace

void addSpeedAccuracy(CLI::App& verb, Work& chosen)
{
    auto arguments = std::make_shared<Arguments>();
    CLI::App* name = verb.add_subcommand("speed-accuracy", "Every filter: time against error");
    name->add_option("FILE",
                     arguments->file,
                     "Project, .ptx or mesh; without it, the stored textures and footprints")
        ->type_name("FILE");
    name->add_option("-o,--output", arguments->output, "Folder to write into")
        ->required()
        ->type_name("DIR");
    name->add_option("--mesh", arguments->mesh, "Mesh to put a .ptx on")->type_name("FILE");
    name->add_option("--samples", arguments->samples, "Footprints spread over FILE")
        ->capture_default_str()
        ->type_name("N");
    name->add_option("--seed", arguments->seed, "Another choice of footprints on FILE")
        ->capture_default_str()
        ->type_name("N");
    name->add_option("--rounds", arguments->rounds, "How often each method is timed, at most")
        ->capture_default_str()
        ->type_name("N");
    name->add_option("--limit", arguments->limit, "Seconds that one method may take")
        ->capture_default_str()
        ->type_name("S");
    name->add_option("--faces",
                     arguments->faces,
                     "Faces of the stored textures: small, about 18 a footprint, or large, which "
                     "few footprints leave")
        ->capture_default_str()
        ->type_name("SIZE");
    name->callback([arguments, &chosen] {
        chosen = [arguments](Progress& progress) { return study(*arguments, progress); };
    });
}

} // namespace trixel::app

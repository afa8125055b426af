// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "core/study/small_studies.h"
#include "core/study/speed/peers/peers.h"
#include "core/study/speed/speed_accuracy.h"
#include "ui/docks/chart_study.h"
#include "ui/docks/study_scene.h"

#include <algorithm>
#include <iterator>
#include <memory>

namespace trixel::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Studies", text);
}

/// Enough footprints for every class to have some.
constexpr int kFootprints = 1000;
constexpr std::uint64_t kSeed = 1;
/// Share of the whole that preparing takes.
constexpr double kPreparing = 0.3;
constexpr double kInviting = 0.1; ///< of it, for the peers

Result<std::vector<StudySubject>> subjectsOf(const StudyInput& input, Progress& progress)
{
    if (!input.project) {
        return storedSubjects(kStudyTiles, Threads::all(), progress);
    }
    StageProgress building(progress, 0, 0.3);
    auto scene = studyScene(*input.project, building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    StageProgress judging(progress, 0.3, 1);
    auto subject = subjectOn(
        std::move(*scene), input.name.toStdString(), kFootprints, kSeed, Threads::all(), judging);
    if (!subject) {
        return tl::unexpected(subject.error());
    }
    if (subject->queries.size() == 0) {
        return contentsError(input.name.toStdString() + ": there is no footprint to measure on.");
    }
    std::vector<StudySubject> subjects;
    subjects.push_back(std::move(*subject));
    return subjects;
}

/// Part of a longer work that also hears of points.
class StageWatcher final : public StudyWatcher
{
public:
    StageWatcher(StudyWatcher& whole, double begin, double end)
        : m_whole(whole)
        , m_stage(whole, begin, end)
    {
    }
    bool report(double fraction) override { return m_stage.report(fraction); }
    void measured(const StudyPoint& point) override { m_whole.measured(point); }

private:
    StudyWatcher& m_whole;
    StageProgress m_stage;
};

Result<Study> runSpeedAccuracy(const StudyInput& input, StudyWatcher& watcher)
{
    StageProgress preparing(watcher, 0, kPreparing - kInviting);
    const auto subjects = subjectsOf(input, preparing);
    if (!subjects) {
        return tl::unexpected(subjects.error());
    }
    StageProgress inviting(watcher, kPreparing - kInviting, kPreparing);
    auto peers = makePeers(*subjects, peerFolder(), inviting);
    if (!peers) {
        return tl::unexpected(peers.error());
    }
    Contestants contestants = tableContestants(*subjects);
    std::ranges::move(peers->contestants, std::back_inserter(contestants));
    StageWatcher measuring(watcher, kPreparing, 1);
    auto study = measureSpeedAccuracy(*subjects, contestants, {}, measuring);
    if (study) {
        std::ranges::move(peers->notes, std::back_inserter(study->notes));
    }
    return study;
}

Result<Study> runSubdivision(const StudyInput& input, StudyWatcher& watcher)
{
    if (input.project) {
        return studySubdivision(input.project->surface->mesh(), watcher);
    }
    const auto cage = storedCage();
    return cage ? studySubdivision(*cage, watcher) : tl::unexpected(cage.error());
}

/// \param choice  short: the list of studies is narrow
/// \param title, name, cost, unit  as the study itself has them
StudyOffer makeOffer(const char* choice,
                     const char* title,
                     const char* about,
                     const char* name,
                     const char* cost,
                     const char* unit)
{
    StudyOffer offer;
    offer.title = tr(choice);
    offer.about = tr(about);
    offer.header.name = name;
    offer.header.title = title;
    offer.header.costTitle = cost;
    offer.header.costUnit = unit;
    offer.stored = tr("Stored test textures");
    return offer;
}

/// A study of a choice of the program's own: on nothing of the user's.
StudyOffer withoutProject(StudyOffer offer, Result<Study> (*measure)(StudyWatcher&))
{
    offer.onProject = false;
    offer.run = [measure](const StudyInput& /*input*/, StudyWatcher& watcher) {
        return measure(watcher);
    };
    return offer;
}

} // namespace

std::vector<StudyOffer> studyOffers()
{
    StudyOffer filters =
        makeOffer("Filters",
                  "Filters: time against error",
                  "Every filter with every value of its parameter, judged by the exact integral",
                  "speed-accuracy",
                  "Time per sample",
                  "ns");
    filters.run = runSpeedAccuracy;
    StudyOffer subdivision =
        makeOffer("Subdivision",
                  "Subdivision: faces against distance",
                  "How near to the limit surface each further level of Loop subdivision comes",
                  "subdivision",
                  "Faces",
                  "faces");
    subdivision.stored = tr("Cage of the sample");
    subdivision.run = runSubdivision;
    return {
        filters,
        filteringOffer(),
        withoutProject(
            makeOffer("Paint projection",
                      "Paint projection: offset or none",
                      "Painting the packed square with the offset of 1/6 texel and without",
                      "paint-projection",
                      "Time per texel",
                      "ns"),
            studyPaintProjection),
        withoutProject(makeOffer("Reduction",
                                 "Reduction: our rule or 2×2 box",
                                 "Halving the resolution as triangles ask for, and as images do",
                                 "reduction",
                                 "Time per texel",
                                 "ns"),
                       studyReduction),
        withoutProject(makeOffer("Storage",
                                 "Storage: memory against error",
                                 "Texels as uint8, uint16, half and float",
                                 "storage",
                                 "Memory per texel",
                                 "bytes"),
                       studyStorage),
        subdivision};
}

} // namespace trixel::ui

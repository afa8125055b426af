// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>

#include "core/study/speed_accuracy.h"
#include "ui/docks/chart_study.h"

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
/// Tiles along a side of the patch that stored footprints lie on, as the command line has it.
constexpr int kTiles = 3;
/// Share of the whole that preparing takes.
constexpr double kPreparing = 0.3;

Result<std::shared_ptr<const FilterScene>> sceneOf(const Project& project, Progress& progress)
{
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(project.surface->mesh(), project.surface->adjacency()));
    return FilterScene::build(std::move(surface), project.texels, Threads::all(), progress)
        .map([](FilterScene&& scene) {
            return std::make_shared<const FilterScene>(std::move(scene));
        });
}

Result<std::vector<StudySubject>> subjectsOf(const StudyInput& input, Progress& progress)
{
    if (!input.project) {
        return storedSubjects(kTiles, Threads::all(), progress);
    }
    StageProgress building(progress, 0, 0.3);
    auto scene = sceneOf(*input.project, building);
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
    StageProgress preparing(watcher, 0, kPreparing);
    const auto subjects = subjectsOf(input, preparing);
    if (!subjects) {
        return tl::unexpected(subjects.error());
    }
    StageWatcher measuring(watcher, kPreparing, 1);
    return measureSpeedAccuracy(*subjects, tableContestants(*subjects), {}, measuring);
}

StudyOffer speedAccuracy()
{
    StudyOffer offer;
    offer.title = tr("Filters: time against error");
    offer.about =
        tr("Every filter with every value of its parameter, judged by the exact integral");
    offer.header.name = "speed-accuracy";
    offer.header.title = "Filters: time against error";
    offer.header.costTitle = "Time per sample";
    offer.header.costUnit = "ns";
    offer.run = runSpeedAccuracy;
    return offer;
}

} // namespace

std::vector<StudyOffer> studyOffers()
{
    return {speedAccuracy()};
}

} // namespace trixel::ui

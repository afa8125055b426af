// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limit surface in the view: seen, pointed at, painted on.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QToolButton>

#include "core/mesh/crease_angle.h"
#include "core/mesh/limit_surface.h"
#include "core/paint/stroke_file.h"
#include "tests/core/mesh/cages.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/document/background_job.h"
#include "ui/document/inspection.h"
#include "ui/inspector/footprint_lines.h"
#include "ui/viewport/crease_bar.h"
#include "ui/viewport/limit_view.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

Project icosahedronProject(int level = 4)
{
    NoProgress progress;
    Project project;
    project.surface = Surface::build(test::icosahedron(), progress).value();
    project.texels = TexelStore(20, TexelFormat{}, Level(level), kFill);
    return project;
}

/// Seen from the front, its face 2 has the edge from vertex 4 to 5 below.
Project cubeProject(const Sharpness& sharpness = {})
{
    NoProgress progress;
    TriangleMesh mesh = test::cube();
    mesh.sharpness = sharpness;
    Project project;
    project.surface = Surface::build(std::move(mesh), progress).value();
    project.texels = TexelStore(12, TexelFormat{}, Level(4), kFill);
    return project;
}

/// Two triangles that share a corner twice: no cage.
Project brokenProject()
{
    TriangleMesh mesh = squareMesh();
    mesh.triangles.push_back({0, 1, 0});
    NoProgress progress;
    Project project;
    project.surface = Surface::build(std::move(mesh), progress).value();
    project.texels = TexelStore(3, TexelFormat{}, Level(2), kFill);
    return project;
}

/// Pixels that show the surface.
int covered(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += std::abs(c.red() - c.blue()) > 30 ? 1 : 0; // the fill is of one hue
        }
    }
    return count;
}

struct LimitFixture : ViewFixture
{
    bool showLimit(Project project = icosahedronProject())
    {
        const bool shown = show(std::move(project));
        setLimit(true);
        return shown;
    }
    void setLimit(bool on, double error = 0.5)
    {
        ViewOptions view = settings.view();
        view.limitSurface = on;
        view.limitError = error;
        view.footprint = false;
        settings.setView(view);
        viewport->settle();
    }
    /// Of the middle of the cube's edge.
    double edgeHeight() const
    {
        viewport->settle();
        return viewport->seenLimit()->surface().at(faceId(2), {0.5, 0}).position.z;
    }
    LimitPoint limitAt(FaceId face, glm::dvec2 uv) const
    {
        return LimitSurface::build(document.surface()->mesh()).value()->at(face, uv);
    }
};

} // namespace

class TestViewportLimit : public QObject
{
    Q_OBJECT

private slots:
    void theLimitTakesTheCagesPlaceInThePicture()
    {
        LimitFixture f;
        QVERIFY(f.show(icosahedronProject()));
        f.setLimit(false);
        const int cage = covered(f.viewport->grabFramebuffer());
        f.setLimit(true);
        const int limit = covered(f.viewport->grabFramebuffer());
        QVERIFY(cage > 10000);
        // It lies within the cage: its outline is a smaller circle.
        QVERIFY2(limit < cage * 0.85, qPrintable(QString("%1 of %2").arg(limit).arg(cage)));
        QVERIFY(limit > cage / 4);
        f.setLimit(false);
        QCOMPARE(covered(f.viewport->grabFramebuffer()), cage);
    }

    void pointingMeetsTheFaceThatIsSeen()
    {
        LimitFixture f;
        QVERIFY(f.showLimit());
        int seen = 0;
        for (std::size_t k = 0; k < 20; ++k) {
            const glm::vec2 uv(0.4F, 0.3F);
            const LimitPoint p = f.limitAt(faceId(k), glm::dvec2(uv));
            const SurfacePoint point{faceId(k), uv, glm::vec3(p.position)};
            const auto at = f.viewport->widgetPosition(point);
            const double turned =
                glm::dot(p.normal(), glm::normalize(f.viewport->camera().eye() - p.position));
            QCOMPARE(at.has_value(), turned > 0);
            if (turned > 0.2) {
                ++seen;
                const auto hit = f.viewport->surfacePointAt(*at);
                QVERIFY(hit);
                QCOMPARE(indexOf(hit->face), k);
                QVERIFY(glm::distance(hit->uv, uv) < 0.01F);
                QVERIFY(glm::distance(glm::dvec3(hit->position), p.position) < 0.01);
            }
        }
        QVERIFY(seen > 4);
    }

    void footprintsFollowTheLimitsDerivatives()
    {
        LimitFixture f;
        QVERIFY(f.showLimit());
        std::optional<HoveredTexel> hovered;
        connect(f.viewport.get(),
                &Viewport::hovered,
                this,
                [&](const std::optional<HoveredTexel>& texel) { hovered = texel; });
        const QPoint at(240, 240);
        movePointer(*f.viewport, at);
        QVERIFY(hovered && hovered->hasFootprint && hovered->pixelQuery);
        const SurfacePoint& point = hovered->point;
        const LimitPoint p = f.limitAt(point.face, glm::dvec2(point.uv));
        QVERIFY(glm::distance(glm::dvec3(point.position), p.position) < 1e-5);
        // A step by W1 in (u,v) is a pixel's step on the screen.
        const auto& camera = f.viewport->camera();
        const auto pixel = [&](glm::dvec2 uv) {
            return *camera.project(f.limitAt(point.face, uv).position);
        };
        const glm::dvec2 uv(point.uv);
        const double h = 1e-3;
        const glm::dvec2 step1 =
            (pixel(uv + h * hovered->footprint.w1) - pixel(uv - h * hovered->footprint.w1)) /
            (2 * h);
        const glm::dvec2 step2 =
            (pixel(uv + h * hovered->footprint.w2) - pixel(uv - h * hovered->footprint.w2)) /
            (2 * h);
        QVERIFY(glm::distance(step1, glm::dvec2(1, 0)) < 0.01);
        QVERIFY(glm::distance(step2, glm::dvec2(0, 1)) < 0.01);
    }

    void aStrokeWithTheMousePaintsWhatIsSeenAndReplaysToTheSameBytes()
    {
        LimitFixture f;
        QVERIFY(f.showLimit());
        Brush brush = f.settings.brush();
        brush.radius = 0.25F;
        f.settings.setBrush(brush);
        const TexelStore before = f.document.texels();
        RecordedStroke recorded{brush, {}};
        recorded.onLimit = true;
        const auto record = [&](QPoint at) {
            const auto point = f.viewport->surfacePointAt(at);
            QVERIFY(point);
            recorded.samples.push_back({point->face, point->uv});
        };
        const QPoint from(200, 240);
        record(from);
        QTest::mousePress(f.viewport.get(), Qt::LeftButton, Qt::NoModifier, from);
        for (const QPoint at : {QPoint(220, 244), QPoint(250, 250), QPoint(290, 240)}) {
            record(at);
            movePointer(*f.viewport, at, Qt::LeftButton);
        }
        QTest::mouseRelease(f.viewport.get(), Qt::LeftButton, Qt::NoModifier, QPoint(290, 240));
        QCOMPARE(f.document.undoStack().count(), 1);

        // Red is what lies within reach on the limit surface.
        f.viewport->settle();
        QCOMPARE(f.seen(from).red() > 2 * f.seen(from).green(), true);
        const LimitPoint start =
            f.limitAt(recorded.samples[0].face, glm::dvec2(recorded.samples[0].uv));
        int red = 0;
        for (std::size_t face = 0; face < 20; ++face) {
            for (std::uint32_t t = 0; t < 256; ++t) {
                const TexelCoord texel = texelAt(Level(4), TexelIndex{t});
                const LimitPoint p = f.limitAt(faceId(face), centroid(Level(4), texel));
                const bool isNear = glm::distance(p.position, start.position) < 0.24;
                red += isNear ? 1 : 0;
                QVERIFY(!isNear || f.texel(faceId(face), texel) == kRed);
            }
        }
        QVERIFY(red > 10);

        NoProgress progress;
        TexelStore replayed = before;
        const auto strokes = parseStrokes(writeStrokes(std::span(&recorded, 1)), 20);
        QVERIFY(strokes);
        QVERIFY(replayStrokes(
            *strokes, f.document.surface(), kFill, replayed, Threads::all(), progress));
        const auto sameAs = [&](const TexelStore& store) {
            for (std::size_t face = 0; face < 20; ++face) {
                if (!std::ranges::equal(store.face(faceId(face)).bytes(),
                                        f.document.texels().face(faceId(face)).bytes())) {
                    return false;
                }
            }
            return true;
        };
        QVERIFY(sameAs(replayed));
        QVERIFY(!sameAs(before));
        f.document.undoStack().undo();
        QVERIFY(sameAs(before));
    }

    void creasesByAngleAreShownPointedAtAndUndone()
    {
        LimitFixture f;
        QVERIFY(f.showLimit(cubeProject()));
        const double round = f.edgeHeight();
        QVERIFY(round < 0.95);
        const int before = covered(f.viewport->grabFramebuffer());
        QSignalSpy seen(f.viewport.get(), &Viewport::seenSurfaceChanged);
        f.document.setCreaseAngle(30);
        QVERIFY(f.document.isModified());
        QVERIFY(std::abs(f.edgeHeight() - 1) < 1e-6);
        QVERIFY(seen.size() > 0);
        QVERIFY(covered(f.viewport->grabFramebuffer()) > before * 1.2);
        const auto hit = f.viewport->surfacePointAt(QPointF(240, 240));
        QVERIFY(hit && std::abs(hit->position.z - 1) < 1e-4F);
        f.document.undoStack().undo();
        QVERIFY(!f.document.isModified());
        QCOMPARE(f.edgeHeight(), round);
        f.document.undoStack().redo();
        f.document.setCreaseAngle(95); // no edge is folded by so much
        QCOMPARE(f.edgeHeight(), round);
    }

    void creasesOfTheMeshAreShownWithoutAnAngle()
    {
        LimitFixture f;
        const Sharpness own{{{4, 5}, {5, 7}, {7, 6}, {6, 4}}, {}};
        QVERIFY(f.showLimit(cubeProject(own)));
        QVERIFY(std::abs(f.edgeHeight() - 1) < 1e-6);
        const auto& limit = f.viewport->seenLimit()->surface();
        QVERIFY(limit.at(faceId(0), {0.5, 0.5}).position.z > -0.95); // those below are round
    }

    void strokesOnACreasedSurfaceReplayToTheSameBytes()
    {
        LimitFixture f;
        QVERIFY(f.showLimit(cubeProject()));
        f.document.setCreaseAngle(30);
        f.viewport->settle();
        RecordedStroke recorded{f.settings.brush(), {}};
        recorded.brush.radius = 0.4F;
        f.settings.setBrush(recorded.brush);
        recorded.onLimit = true;
        const QPoint at(240, 240);
        const auto point = f.viewport->surfacePointAt(at);
        QVERIFY(point);
        recorded.samples.push_back({point->face, point->uv});
        TexelStore replayed = f.document.texels();
        QTest::mouseClick(f.viewport.get(), Qt::LeftButton, Qt::NoModifier, at);
        NoProgress progress;
        const auto isPainted = [&](CreaseAngle creases) {
            TexelStore store = replayed;
            const Status status = replayStrokes(std::span(&recorded, 1),
                                                f.document.surface(),
                                                kFill,
                                                store,
                                                Threads::all(),
                                                progress,
                                                creases);
            bool isSame = status.has_value();
            for (std::size_t face = 0; face < 12; ++face) {
                isSame =
                    isSame && std::ranges::equal(store.face(faceId(face)).bytes(),
                                                 f.document.texels().face(faceId(face)).bytes());
            }
            return isSame;
        };
        QVERIFY(isPainted(30.0F));
        QVERIFY(!isPainted({})); // another surface
    }

    void theBarChoosesAnAngleAsOneUndoStep()
    {
        LimitFixture f;
        QVERIFY(f.show(cubeProject()));
        f.viewport->askForCreases();
        QVERIFY(f.settings.view().limitSurface);
        auto* bar = f.viewport->findChild<CreaseBar*>();
        QVERIFY(bar && bar->isVisible());
        auto* isOn = bar->findChild<QCheckBox*>();
        auto* angle = bar->findChild<QDoubleSpinBox*>();
        QVERIFY(!isOn->isChecked());
        QVERIFY(!angle->isEnabled());
        isOn->click();
        QCOMPARE(f.document.creaseAngle(), CreaseAngle(30.0F));
        angle->stepUp();
        angle->stepUp();
        QCOMPARE(f.document.creaseAngle(), CreaseAngle(40.0F));
        QCOMPARE(f.document.undoStack().count(), 1);
        QVERIFY(std::abs(f.edgeHeight() - 1) < 1e-6);

        f.document.undoStack().undo();
        QVERIFY(!f.document.creaseAngle());
        QVERIFY(!isOn->isChecked());
        f.document.undoStack().redo();
        QCOMPARE(f.document.creaseAngle(), CreaseAngle(40.0F));
        QCOMPARE(angle->value(), 40.0);
        angle->stepUp(); // after an undo: another step
        QCOMPARE(f.document.undoStack().count(), 2);
        QTest::keyClick(angle, Qt::Key_Escape);
        QVERIFY(!bar->isVisible());
        f.viewport->askForCreases();
        angle->stepUp();
        QCOMPARE(f.document.undoStack().count(), 3);
    }

    void theLimitIsToldOfWhileItIsMade()
    {
        BackgroundJobs jobs;
        LimitFixture f;
        QVERIFY(f.show(icosahedronProject()));
        f.viewport->useJobs(jobs);
        QStringList titles;
        connect(&jobs, &BackgroundJobs::started, this, [&](BackgroundJob* job) {
            titles += job->title();
        });
        f.setLimit(true);
        QVERIFY(f.viewport->seenLimit());
        QVERIFY(titles.contains("Making the limit surface"));
        titles.clear();
        f.viewport->lookFrom(20, 20); // follows the camera silently
        f.viewport->settle();
        QCOMPARE(titles, QStringList());
        QTRY_VERIFY(jobs.isIdle());
    }

    void cancelledItsMakingLeavesTheCageAndMayBeginAgain()
    {
        BackgroundJobs jobs;
        LimitFixture f;
        QVERIFY(f.show(icosahedronProject()));
        f.viewport->useJobs(jobs);
        const auto cancelling = connect(
            &jobs, &BackgroundJobs::started, this, [](BackgroundJob* job) { job->cancel(); });
        f.setLimit(true);
        QTRY_VERIFY(!f.settings.view().limitSurface);
        QVERIFY(!f.viewport->seenLimit());
        QVERIFY(f.viewport->limitSurfaceRefusal().isEmpty());
        disconnect(cancelling);
        f.setLimit(true);
        QVERIFY(f.viewport->seenLimit());
        QTRY_VERIFY(jobs.isIdle());
    }

    void anAngleChosenWhileItIsMadeIsTheOneThatComes()
    {
        BackgroundJobs jobs;
        LimitFixture f;
        QVERIFY(f.showLimit(cubeProject()));
        f.viewport->useJobs(jobs);
        for (const float angle : {10.0F, 95.0F, 30.0F, 120.0F, 40.0F}) {
            f.document.setCreaseAngle(angle);
            QVERIFY(f.viewport->seenLimit()); // what is there stays until the other is
        }
        QVERIFY(std::abs(f.edgeHeight() - 1) < 1e-6);
        QTRY_VERIFY(jobs.isIdle());
    }

    void probedFootprintsAreTheLimitsAndDrawnOnIt()
    {
        LimitFixture f;
        QVERIFY(f.showLimit());
        const auto limit = f.viewport->seenLimit();
        Inspection inspection(f.document);
        FootprintProbe probe(f.document, inspection);
        probe.setActive(true);
        probe.setCamera(f.viewport->camera());
        const auto point = f.viewport->surfacePointAt(QPointF(240, 240));
        QVERIFY(point);
        inspection.pointAt(point->face, point->uv);
        QVERIFY(probe.live());
        const Footprint onCage = probe.live()->placed.footprint;
        probe.setLimit(limit);
        const Footprint onLimit = probe.live()->placed.footprint;
        const glm::dvec2 uv(point->uv);
        const auto pixel = [&](glm::dvec2 step) {
            return *f.viewport->camera().project(f.limitAt(point->face, uv + step).position);
        };
        constexpr double h = 1e-3;
        const auto moved = [&](glm::dvec2 w) { return (pixel(h * w) - pixel(-h * w)) / (2 * h); };
        QVERIFY(glm::distance(moved(onLimit.w1), glm::dvec2(1, 0)) < 0.01);
        QVERIFY(glm::distance(moved(onLimit.w2), glm::dvec2(0, 1)) < 0.01);
        QVERIFY(glm::distance(moved(onCage.w1), glm::dvec2(1, 0)) > 0.05);
        const auto& per = probe.live()->derivatives;
        QVERIFY(per);

        FootprintMarks marks;
        marks.live = &*probe.live();
        const SeenSurface seen(*f.document.surface(), limit.get());
        const auto lines = marksOnSurface(seen, f.document.texels(), marks);
        QVERIFY(!lines.empty());
        for (const render::Polyline& line : lines) {
            for (const glm::vec3 p : line.points) {
                const auto near = limit->closestPoint(p, 1);
                QVERIFY(near && glm::distance(near->position, p) < 2e-3F);
            }
        }
    }

    void theErrorIsToldAndFewerPixelsTakeMoreTriangles()
    {
        LimitFixture f;
        QVERIFY(f.showLimit());
        std::vector<double> told;
        std::vector<std::uint64_t> triangles;
        for (const double error : {4.0, 0.5}) {
            f.setLimit(true, error);
            (void)f.viewport->grabFramebuffer();
            const render::FrameFigures figures = f.viewport->figures();
            QVERIFY(figures.surfaceError);
            QVERIFY(*figures.surfaceError <= error);
            QVERIFY(figures.triangles > figures.faces);
            triangles.push_back(figures.triangles);
        }
        QVERIFY(triangles[1] > 2 * triangles[0]);
        f.setLimit(false);
        (void)f.viewport->grabFramebuffer();
        QVERIFY(!f.viewport->figures().surfaceError);
    }

    void meshesWithoutALimitSayWhyAndShowTheirCage()
    {
        LimitFixture f;
        QVERIFY(f.show(brokenProject()));
        f.viewport->settle();
        QTRY_VERIFY(!f.viewport->limitSurfaceRefusal().isEmpty());
        QVERIFY(f.viewport->limitSurfaceRefusal().contains("face 2 has a corner twice"));
        f.setLimit(true);
        QVERIFY(f.viewport->surfacePointAt(QPointF(240, 250)));
        f.document.open(icosahedronProject(), {}, "whole");
        QTRY_VERIFY(f.viewport->limitSurfaceRefusal().isEmpty());
    }

    /// Leaves pictures to be looked at where a folder is named.
    void cageAndLimitAreDrawnWithTheirFacesEdges()
    {
        LimitFixture f;
        QVERIFY(f.show(icosahedronProject()));
        f.viewport->lookFrom(25, 20);
        ViewOptions view = f.settings.view();
        view.wireframe = true;
        f.settings.setView(view);
        const QString folder = qEnvironmentVariable("TRIXEL_TEST_PICTURES");
        for (const bool limit : {false, true}) {
            f.setLimit(limit);
            const QImage image = f.viewport->grabFramebuffer();
            QVERIFY(covered(image) > 10000);
            QVERIFY(folder.isEmpty() || image.save(folder + (limit ? "/limit.png" : "/cage.png")));
        }
    }

    void aLostContextBringsItBack()
    {
        LimitFixture f;
        QVERIFY(f.showLimit());
        const int before = covered(f.viewport->grabFramebuffer());
        f.viewport->setParent(nullptr);
        QWidget other;
        other.resize(480, 480);
        f.viewport->setParent(&other);
        other.show();
        f.viewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(&other));
        f.viewport->settle();
        const int after = covered(f.viewport->grabFramebuffer());
        f.viewport->setParent(nullptr);
        QVERIFY(std::abs(before - after) <= before / 100);
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::TestViewportLimit)
#include "tst_viewport_limit.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ways of filtering on the card: what they show and how they fare against `exact`.
#include <QTest>

#include "render/filtering_study.h"
#include "tests/render/filtering_views.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

using namespace trixel;
using namespace trixel::render;

namespace {

/// Processors round otherwise: a few pixels may lie on another side of an edge.
void expectAlike(const QImage& image, const QImage& other)
{
    QCOMPARE(other.size(), image.size());
    int off = 0;
    double sum = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor a = image.pixelColor(x, y);
            const QColor b = other.pixelColor(x, y);
            const int most = std::max({std::abs(a.red() - b.red()),
                                       std::abs(a.green() - b.green()),
                                       std::abs(a.blue() - b.blue())});
            off += most > 3 ? 1 : 0;
            sum += most;
        }
    }
    QVERIFY2(off <= image.width() * image.height() / 200, qPrintable(QString::number(off)));
    QVERIFY2(sum / (image.width() * image.height()) < 0.25, qPrintable(QString::number(sum)));
}

} // namespace

class TestFiltering : public FilteringTest
{
    Q_OBJECT

private slots:
    void init() { begin(); }
    void cleanup() { end(); }

    void looksAsItDid_data()
    {
        QTest::addColumn<bool>("isBunny");
        QTest::addColumn<int>("filtering");
        for (const bool isBunny : {false, true}) {
            for (const Filtering filtering : kFilterings) {
                QTest::addRow("%s, %s", isBunny ? "bunny" : "torus", nameOf(filtering))
                    << isBunny << static_cast<int>(filtering);
            }
        }
    }

    void looksAsItDid()
    {
        QFETCH(bool, isBunny);
        QFETCH(int, filtering);
        std::optional<Shown>& shown = isBunny ? m_bunny : m_torus;
        if (!shown) {
            shown = isBunny ? bunny() : torus();
        }
        QVERIFY2(shown, "glmark2-data has the bunny");
        const auto way = static_cast<Filtering>(filtering);
        const auto renderer = rendererOf(*shown->surface, shown->store);
        prepareFilterings(*renderer, shown->store, std::span(&way, 1));
        QVERIFY(renderer->isFilterReady(way));
        Scene scene = shown->scene;
        scene.surface.filtering = way;
        const QImage image = m_offscreen->draw(*renderer, scene);
        renderer->setCorners({});
        expectAlike(m_offscreen->draw(*renderer, scene), image); // three corners a face
        const QString name =
            QStringLiteral("%1-%2.png").arg(isBunny ? "bunny" : "torus", nameOf(way));
        const QString path = QStringLiteral(TRIXEL_TEST_DATA "/filtering/") + name;
        if (qEnvironmentVariableIsSet("TRIXEL_WRITE_GOLDEN")) {
            QVERIFY(image.save(path));
        }
        const QImage golden = QImage(path).convertToFormat(QImage::Format_RGB32);
        expectAlike(image, golden);
    }

    /// Colours of corners, lines and light; light by the faces' own normals, which is what faces
    /// are lit by that have no others.
    void sharedCornersShowWhatFacesDo()
    {
        const Shown shown = torus();
        const TriangleMesh& mesh = shown.surface->mesh();
        const auto renderer = rendererOf(*shown.surface, shown.store);
        renderer->uploadTexels(shown.store, std::size_t{1} << 30U);
        std::vector<std::uint32_t> normals;
        std::vector<std::uint32_t> colors;
        for (std::uint32_t corner = 0; corner < 3 * mesh.faceCount(); ++corner) {
            const auto [a, b, c] = mesh.corners(faceId(corner / 3));
            normals.push_back(packNormal(glm::normalize(glm::cross(b - a, c - a))));
            colors.push_back(corner * 2654435761U | 0xff000000U);
        }
        renderer->setFaceColors(colors);
        const SharedCorners hard = SharedCorners::of(mesh, normals);
        const SharedCorners smooth = SharedCorners::of(mesh, cornerNormals(mesh));
        for (const bool isLit : {false, true}) {
            for (const bool hasColors : {false, true}) {
                Scene scene = shown.scene;
                scene.surface.lit = isLit;
                scene.surface.wireframe = true;
                scene.surface.texelGrid = !hasColors;
                scene.surface.faceColors = hasColors;
                renderer->setCorners({});
                const QImage faces = m_offscreen->draw(*renderer, scene);
                renderer->setCorners(isLit ? hard : smooth);
                expectAlike(m_offscreen->draw(*renderer, scene), faces);
            }
        }
    }

    void anisotropicIsNearTheExactAnswer_data()
    {
        QTest::addColumn<int>("scene");
        QTest::addColumn<double>("yaw");
        QTest::addColumn<double>("pitch");
        QTest::addColumn<double>("distance");
        QTest::newRow("torus, banded levels") << 0 << 0.4 << 0.75 << 1.0;
        QTest::newRow("torus, banded levels, near") << 0 << 2.5 << 1.1 << 0.5;
        QTest::newRow("torus, mixed levels") << 1 << 1.0 << 0.4 << 0.75;
        QTest::newRow("torus, mixed levels, near") << 1 << 1.0 << 0.4 << 0.3;
        QTest::newRow("bunny") << 2 << 3.0 << 0.2 << 0.2;
        QTest::newRow("bunny, near") << 2 << 4.0 << 0.6 << 0.1;
        QTest::newRow("torus, mixed levels, far") << 1 << 0.4 << 0.75 << 1.0;
        QTest::newRow("bunny, far") << 2 << 1.0 << 0.3 << 0.6;
    }

    void anisotropicIsNearTheExactAnswer()
    {
        QFETCH(int, scene);
        QFETCH(double, yaw);
        QFETCH(double, pitch);
        QFETCH(double, distance);
        std::optional<Shown> shown = scene == 2 ? bunny() : torus();
        QVERIFY2(shown, "glmark2-data has the bunny");
        if (scene == 0) {
            shown->surface = surfaceOf(torusMesh(64, 40));
            shown->store =
                solidStore(shown->surface->mesh(), bandedLevels(shown->surface->mesh(), 2, 4), 4);
        }
        const TriangleMesh& mesh = shown->surface->mesh();
        CameraPose pose;
        pose.yaw = yaw;
        pose.pitch = pitch;
        pose.distance = distance;
        shown->scene = sceneOf(*shown->surface, kSide, pose);
        const auto renderer = rendererOf(*shown->surface, shown->store);
        prepareFilterings(*renderer, shown->store);
        NoProgress progress;
        const auto surface = std::make_shared<const FilterSurface>(
            FilterSurface::fromMesh(mesh, shown->surface->adjacency()));
        const FilterScene filters =
            *FilterScene::build(surface, shown->store, Threads::all(), progress);
        const ExactPicture exact = *exactPicture(*shown->surface,
                                                 filters,
                                                 shown->store.format(),
                                                 shown->scene.camera,
                                                 {3, 0},
                                                 Threads::all(),
                                                 progress);
        QVERIFY(exact.queries.size() > 1000);
        std::array<double, 5> rms{};
        for (const Filtering filtering : kFilterings) {
            Scene drawn = shown->scene;
            drawn.surface.filtering = filtering;
            const PictureDifference off = differenceOf(drawNumbers(*m_gl, *renderer, drawn), exact);
            qInfo() << nameOf(filtering) << "RMS %" << 100 * off.rms << "99 % below"
                    << 100 * off.p99 << "worst %" << 100 * off.worst;
            rms[static_cast<std::size_t>(filtering)] = off.rms;
        }
        QVERIFY(rms[static_cast<std::size_t>(Filtering::Anisotropic)] <= 0.015);
        QVERIFY(rms[static_cast<std::size_t>(Filtering::Anisotropic)] <=
                rms[static_cast<std::size_t>(Filtering::Seamless)]);
        QVERIFY(rms[static_cast<std::size_t>(Filtering::Seamless)] <=
                rms[static_cast<std::size_t>(Filtering::LowerHalf)]);
    }

    /// What is interpolated between the corners of faces of a few pixels is what each pixel would
    /// find, to where their tilts differ most: by the contour.
    void levelsOfSmallFacesAreThoseOfTheirPixels()
    {
        Shown shown;
        shown.surface = surfaceOf(torusMesh(200, 120));
        const TriangleMesh& mesh = shown.surface->mesh();
        shown.store = noiseStore(mixedLevels(mesh.faceCount(), 1, 3, 7), 3);
        const auto renderer = rendererOf(*shown.surface, shown.store);
        prepareFilterings(*renderer, shown.store);
        const FilterMesh sizes(mesh, shown.surface->adjacency(), shown.store);
        for (const CameraPose pose : {CameraPose{{}, 1.0, 0.4, 0.75},
                                      CameraPose{{}, 1.0, 2.0, 0.1},
                                      CameraPose{{}, 0.85, 1.0, 0.4}}) {
            Scene scene = sceneOf(*shown.surface, kSide, pose);
            QVERIFY(sizes.longestEdge() <= 8 * scene.camera.nearestWorldPerPixel());
            scene.surface.filtering = Filtering::Seamless;
            const DrawnPicture small = drawNumbers(*m_gl, *renderer, scene);
            scene.surface.pixelLevels = true;
            const DrawnPicture pixels = drawNumbers(*m_gl, *renderer, scene);
            double sum = 0;
            double worst = 0;
            for (std::size_t k = 0; k < small.values.size(); ++k) {
                const double off = std::abs(double{small.values[k]} - double{pixels.values[k]});
                sum += off * off;
                worst = std::max(worst, off);
            }
            sum = std::sqrt(sum / static_cast<double>(small.values.size()));
            qInfo() << sizes.longestEdge() / scene.camera.nearestWorldPerPixel() << "pixels, off by"
                    << 255 * sum << "of 255, at most" << 255 * worst;
            QVERIFY(worst > 0);
            QVERIFY(255 * sum <= 0.2);
            QVERIFY(255 * worst <= 25);
        }
    }

    /// What a stroke changes is sent alone, and shows as if all had been sent.
    void strokesShowInEveryWay()
    {
        Shown shown = torus();
        const auto renderer = rendererOf(*shown.surface, shown.store);
        const std::array<std::byte, 3> grey{std::byte{90}, std::byte{90}, std::byte{90}};
        for (std::size_t f = 100; f < 160; ++f) { // not painted yet
            shown.store.exchange(faceId(f),
                                 FaceTexels::constant(shown.store.face(faceId(f)).level(), grey));
        }
        renderer->setTexels(shown.store, 0);
        prepareFilterings(*renderer, shown.store);
        std::mt19937 random(3);
        for (int stroke = 0; stroke < 3; ++stroke) {
            std::vector<TouchedRect> rects;
            for (std::size_t f = 90 + 20 * static_cast<std::size_t>(stroke); f < 600; f += 7) {
                TouchedRect rect{faceId(f), 0, 0, 1, 2};
                rect.wholeFace = shown.store.face(faceId(f)).isConstant();
                const std::uint32_t r = shown.store.face(faceId(f)).level().resolution();
                const auto texels = shown.store.writable(faceId(f));
                for (std::size_t k = 0; k < 3; ++k) {
                    texels[k] = static_cast<std::byte>(random());
                    texels[3 * r + k] = static_cast<std::byte>(random());
                }
                rects.push_back(rect);
            }
            renderer->touchTexels(shown.store, rects);
            prepareFilterings(*renderer, shown.store);
        }
        const auto anew = rendererOf(*shown.surface, shown.store);
        prepareFilterings(*anew, shown.store);
        for (const Filtering filtering : kFilterings) {
            Scene scene = shown.scene;
            scene.surface.filtering = filtering;
            QVERIFY(renderer->isFilterReady(filtering));
            QVERIFY2(m_offscreen->draw(*renderer, scene) == m_offscreen->draw(*anew, scene),
                     nameOf(filtering));
        }
    }

    void showsTexelsUntilWhatItNeedsIsThere()
    {
        const Shown shown = torus();
        const auto renderer = rendererOf(*shown.surface, shown.store);
        const std::array<Filtering, 1> plain{Filtering::Texels};
        prepareFilterings(*renderer, shown.store, plain);
        Scene scene = shown.scene;
        const QImage texels = m_offscreen->draw(*renderer, scene);
        scene.surface.filtering = Filtering::Seamless;
        QVERIFY(!renderer->isFilterReady(Filtering::Seamless));
        QVERIFY(m_offscreen->draw(*renderer, scene) == texels);
        const std::array<Filtering, 1> seamless{Filtering::Seamless};
        prepareFilterings(*renderer, shown.store, seamless);
        QVERIFY(m_offscreen->draw(*renderer, scene) != texels);
        // Given up when nobody wants it any more.
        renderer->wantFilterings(plain);
        QVERIFY(!renderer->isFilterReady(Filtering::Seamless));
        QVERIFY(m_offscreen->draw(*renderer, scene) == texels);
    }

    void splitShowsTwoWays()
    {
        const Shown shown = torus();
        const auto renderer = rendererOf(*shown.surface, shown.store);
        prepareFilterings(*renderer, shown.store);
        Scene scene = shown.scene;
        const QImage left = m_offscreen->draw(*renderer, scene);
        scene.surface.filtering = Filtering::Seamless;
        const QImage right = m_offscreen->draw(*renderer, scene);
        scene.surface.filtering = Filtering::Texels;
        scene.split = Split{};
        scene.split->column = kSide / 2;
        scene.split->otherFiltering = Filtering::Seamless;
        const QImage both = m_offscreen->draw(*renderer, scene);
        const QRect half(0, 0, kSide / 2, kSide);
        QVERIFY(both.copy(half) == left.copy(half));
        QVERIFY(both.copy(half.translated(kSide / 2, 0)) ==
                right.copy(half.translated(kSide / 2, 0)));
        QVERIFY(left != right);
    }

private:
    std::optional<Shown> m_torus;
    std::optional<Shown> m_bunny;
};

QTEST_MAIN(TestFiltering)
#include "tst_filtering.moc"

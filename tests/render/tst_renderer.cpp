// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QOpenGLFunctions>
#include <QTest>

#include "core/lattice/texel.h"
#include "core/texture/mips.h"
#include "render/corner_normals.h"
#include "tests/render/offscreen.h"

#include <limits>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr std::size_t kAll = ~std::size_t{0};

/// Two triangles in the plane z = 0 that face the camera, one a half turn of the other.
TriangleMesh twoFaces()
{
    return {{{-1, -1, 0}, {0.9F, -1, 0}, {-1, 0.9F, 0}, {1, 1, 0}, {-0.9F, 1, 0}, {1, -0.9F, 0}},
            {{0, 1, 2}, {3, 4, 5}},
            {}};
}

Camera facing()
{
    Camera camera;
    camera.setViewport(1024, 1024);
    camera.setScene({-1, -1, 0}, {1, 1, 0});
    camera.setPose({{0, 0, 0}, 3.6, 0, 0});
    return camera;
}

Scene unlitScene()
{
    Scene scene;
    scene.camera = facing();
    scene.surface.lit = false;
    return scene;
}

FaceTexels randomFace(const TexelFormat& format, int level, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> in(0, 1);
    std::vector<float> values(Level(level).texelCount() * format.channels);
    std::ranges::generate(values, [&] { return in(random); });
    std::vector<std::byte> texels(values.size() * byteSize(format.type));
    encode(format.type, values, texels);
    return FaceTexels::full(Level(level), format.texelBytes(), texels);
}

TexelStore storeOf(const TexelFormat& format, const FaceTexels& a, const FaceTexels& b)
{
    TexelStore store(2, format, Level(0), std::vector<std::byte>(format.texelBytes()));
    store.exchange(faceId(0), a);
    store.exchange(faceId(1), b);
    return store;
}

/// Colour of a texel as the screen should show it.
QColor shownColor(const TexelFormat& format, std::span<const std::byte> texel)
{
    std::vector<float> values(format.channels);
    decode(format.type, texel, values);
    const auto channel = [&](std::size_t c) {
        return std::clamp(values[format.channels < 3 ? 0 : c], 0.0F, 1.0F);
    };
    return QColor::fromRgbF(channel(0), channel(1), channel(2));
}

bool alike(const QColor& a, const QColor& b)
{
    return std::abs(a.red() - b.red()) <= 1 && std::abs(a.green() - b.green()) <= 1 &&
           std::abs(a.blue() - b.blue()) <= 1;
}

/// How many texels do not show their colour where their centroid is seen; all of both faces.
int wrongTexels(const QImage& image,
                const TriangleMesh& mesh,
                const TexelStore& store,
                int drop = 0)
{
    const Camera camera = facing();
    int wrong = 0;
    for (std::size_t f = 0; f < store.faceCount(); ++f) {
        const FaceTexels face = reduced(store.format(), store.face(faceId(f)), drop);
        for (std::uint32_t t = 0; t < face.level().texelCount(); ++t) {
            const glm::dvec2 uv =
                centroid(face.level(), texelAt(face.level(), static_cast<TexelIndex>(t)));
            const glm::vec3 point = pointAt(
                mesh.corners(faceId(f)), static_cast<float>(uv.x), static_cast<float>(uv.y));
            const glm::dvec2 pixel = camera.project(point).value();
            const QColor seen = image.pixelColor(int(pixel.x), int(pixel.y));
            wrong += alike(seen, shownColor(store.format(), face.texel(t))) ? 0 : 1;
        }
    }
    return wrong;
}

} // namespace

class TestRenderer : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_offscreen = std::make_unique<Offscreen>();
        QVERIFY2(m_offscreen->isValid(), "OpenGL 4.1 core is needed");
        m_renderer = makeRenderer();
        QVERIFY(m_renderer);
    }

    void cleanup()
    {
        QVERIFY(!m_offscreen->hadErrors());
        m_renderer.reset();
        m_offscreen.reset();
    }

    void everyTexelOfBothHalvesShowsItsColour_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("levelA");
        QTest::addColumn<int>("levelB");
        QTest::newRow("level 3") << 0 << 3 << 3 << 3;
        QTest::newRow("level 0") << 0 << 3 << 0 << 0;
        QTest::newRow("level 1") << 0 << 3 << 1 << 1;
        QTest::newRow("level 5") << 0 << 3 << 5 << 5;
        QTest::newRow("mixed levels") << 0 << 3 << 5 << 2;
        QTest::newRow("grey") << 0 << 1 << 3 << 4;
        QTest::newRow("uint16") << 1 << 3 << 3 << 4;
        QTest::newRow("half") << 2 << 3 << 3 << 4;
        QTest::newRow("float") << 3 << 4 << 3 << 4;
    }

    void everyTexelOfBothHalvesShowsItsColour()
    {
        QFETCH(int, type);
        QFETCH(int, channels);
        QFETCH(int, levelA);
        QFETCH(int, levelB);
        const TexelFormat format{
            static_cast<TexelType>(type), static_cast<std::uint16_t>(channels), {}};
        const TexelStore store =
            storeOf(format, randomFace(format, levelA, 1), randomFace(format, levelB, 2));
        show(store);
        QCOMPARE(wrongTexels(picture(), m_mesh, store), 0);
    }

    void constantFacesShowTheirValue()
    {
        const TexelFormat format;
        const auto red = std::vector<std::byte>{std::byte{200}, std::byte{10}, std::byte{20}};
        const TexelStore store =
            storeOf(format, FaceTexels::constant(Level(4), red), randomFace(format, 3, 5));
        show(store);
        QCOMPARE(wrongTexels(picture(), m_mesh, store), 0);
    }

    void aMipDropShowsReducedTexels()
    {
        const TexelFormat format;
        const TexelStore store =
            storeOf(format, randomFace(format, 5, 1), randomFace(format, 1, 2));
        for (const int drop : {1, 2, 7}) {
            show(store, drop);
            QCOMPARE(wrongTexels(picture(), m_mesh, store, drop), 0);
        }
    }

    void aTouchedRectangleIsAllThatIsSent()
    {
        const TexelFormat format;
        TexelStore store = storeOf(format, randomFace(format, 5, 1), randomFace(format, 5, 2));
        show(store);
        std::span<std::byte> texels = store.writable(faceId(1));
        for (std::size_t y = 6; y < 10; ++y) {
            for (std::size_t x = 3; x < 8; ++x) {
                texels[3 * (x + 32 * y)] = std::byte{255};
            }
        }
        const TouchedRect rect{faceId(1), 3, 6, 5, 4, false};
        m_renderer->touchTexels(store, {{rect}});
        const std::size_t sent = m_renderer->uploadTexels(store, 0);
        // Rows of 32 lie close: they go in one piece, gaps included.
        QCOMPARE(sent, std::size_t{4 * (3 * 32 + 5)});
        QCOMPARE(wrongTexels(picture(), m_mesh, store), 0);
        QCOMPARE(m_renderer->uploadTexels(store, kAll), std::size_t{0});
    }

    void aFacePaintedForTheFirstTimeIsShown()
    {
        const TexelFormat format;
        const auto grey = std::vector<std::byte>(3, std::byte{90});
        TexelStore store(2, format, Level(4), grey);
        show(store);
        store.exchange(faceId(0), randomFace(format, 4, 3));
        const TouchedRect rect{faceId(0), 0, 0, 16, 16, true};
        m_renderer->touchTexels(store, {{rect}});
        QCOMPARE(m_renderer->uploadTexels(store, 0), std::size_t{4 * 256});
        QCOMPARE(wrongTexels(picture(), m_mesh, store), 0);
    }

    void aBufferThatGrowsKeepsWhatItHolds()
    {
        const TexelFormat format;
        const auto grey = std::vector<std::byte>(3, std::byte{90});
        TexelStore store(2, format, Level(3), grey);
        store.exchange(faceId(1), randomFace(format, 5, 4));
        show(store);
        store.exchange(faceId(0), randomFace(format, 10, 3)); // a million texels
        const TouchedRect rect{faceId(0), 0, 0, 1024, 1024, true};
        m_renderer->touchTexels(store, {{rect}});
        m_renderer->uploadTexels(store, 0);
        TexelStore second = store;
        second.exchange(faceId(0), store.face(faceId(1))); // compare face 1 only, twice
        const QImage image = picture();
        const Camera camera = facing();
        const FaceTexels& face = store.face(faceId(1));
        for (std::uint32_t t = 0; t < face.level().texelCount(); ++t) {
            const glm::dvec2 uv =
                centroid(face.level(), texelAt(face.level(), static_cast<TexelIndex>(t)));
            const glm::dvec2 p =
                *camera.project(pointAt(m_mesh.corners(faceId(1)), float(uv.x), float(uv.y)));
            QVERIFY(alike(image.pixelColor(int(p.x), int(p.y)), shownColor(format, face.texel(t))));
        }
    }

    void anotherContextShowsTheSamePicture()
    {
        const TexelFormat format;
        const TexelStore store =
            storeOf(format, randomFace(format, 4, 1), randomFace(format, 2, 2));
        Scene scene = unlitScene();
        scene.surface.lit = true;
        show(store);
        const QImage before = m_offscreen->draw(*m_renderer, scene);

        m_renderer.reset();
        m_offscreen.reset();
        m_offscreen = std::make_unique<Offscreen>();
        m_renderer = makeRenderer();
        show(store);
        QCOMPARE(m_offscreen->draw(*m_renderer, scene), before);
    }

    void lightChangesThePictureAndKeepsTheBackground()
    {
        const TexelFormat format;
        const auto white = std::vector<std::byte>(3, std::byte{255});
        show(TexelStore(2, format, Level(2), white));
        Scene scene = unlitScene();
        scene.camera.setPose({{0, 0, 0}, 3.6, 0.6, 0.4});
        const QImage unlit = m_offscreen->draw(*m_renderer, scene);
        scene.surface.lit = true;
        const QImage lit = m_offscreen->draw(*m_renderer, scene);
        m_renderer->setNormals(cornerNormals(m_mesh));
        const QImage smooth = m_offscreen->draw(*m_renderer, scene);
        QCOMPARE(unlit.pixelColor(400, 600), QColor(Qt::white));
        const QColor shade = lit.pixelColor(400, 600);
        QVERIFY(shade.lightness() < 254 && shade.lightness() > 120);
        QCOMPARE(lit.pixel(2, 2), unlit.pixel(2, 2));
        // A flat face has the same light with its own normal and with corner normals.
        QVERIFY(alike(shade, smooth.pixelColor(400, 600)));
    }

    void backFacesAreShownDarker()
    {
        const auto white = std::vector<std::byte>(3, std::byte{255});
        show(TexelStore(2, TexelFormat{}, Level(2), white));
        Scene scene = unlitScene();
        scene.camera.setPose({{0, 0, 0}, 3.6, 3.14159265, 0});
        const QColor back = m_offscreen->draw(*m_renderer, scene).pixelColor(600, 600);
        QVERIFY(back.lightness() > 150 && back.lightness() < 220);
    }

    void theTexelGridFollowsTheThreeDirectionsOfTheLattice()
    {
        const auto white = std::vector<std::byte>(3, std::byte{255});
        show(TexelStore(2, TexelFormat{}, Level(3), white));
        Scene scene = unlitScene();
        scene.surface.texelGrid = true;
        const QImage image = m_offscreen->draw(*m_renderer, scene);
        const auto darkness = [&](double u, double v) {
            const glm::dvec2 p =
                *scene.camera.project(pointAt(m_mesh.corners(faceId(0)), float(u), float(v)));
            return 255 - image.pixelColor(int(p.x), int(p.y)).lightness();
        };
        const double cell = 1.0 / 8;
        // Half-way along a cell's bottom, left side and diagonal; then the two centroids.
        QVERIFY(darkness(2.5 * cell, 3 * cell) > 40);
        QVERIFY(darkness(2 * cell, 3.5 * cell) > 40);
        QVERIFY(darkness(2.5 * cell, 3.5 * cell) > 40);
        QCOMPARE(darkness(2.333 * cell, 3.333 * cell), 0);
        QCOMPARE(darkness(2.667 * cell, 3.667 * cell), 0);
    }

    void theTexelGridVanishesWhenTexelsAreSmall()
    {
        const auto white = std::vector<std::byte>(3, std::byte{255});
        show(TexelStore(2, TexelFormat{}, Level(9), white));
        Scene scene = unlitScene();
        scene.surface.texelGrid = true;
        const QImage image = m_offscreen->draw(*m_renderer, scene);
        QCOMPARE(image.pixelColor(300, 700), QColor(Qt::white));
    }

    void theWireframeDarkensTheEdgesOfFaces()
    {
        const auto white = std::vector<std::byte>(3, std::byte{255});
        show(TexelStore(2, TexelFormat{}, Level(3), white));
        Scene scene = unlitScene();
        scene.surface.wireframe = true;
        const QImage image = m_offscreen->draw(*m_renderer, scene);
        const auto at = [&](glm::vec3 point) {
            const glm::dvec2 p = *scene.camera.project(point);
            return image.pixelColor(int(p.x), int(p.y)).lightness();
        };
        QVERIFY(at({-0.999F, 0, 0}) < 200);
        QVERIFY(at({-0.05F, -0.051F, 0}) < 200);
        QCOMPARE(at({-0.5F, -0.5F, 0}), 255);
    }

    void opacityIsShownOverAChecker()
    {
        const TexelFormat format{TexelType::UInt8, 4, 3};
        std::vector<std::byte> clear(4, std::byte{0});
        show(TexelStore(2, format, Level(1), clear));
        Scene scene = unlitScene();
        scene.surface.hasAlpha = true;
        const QImage image = m_offscreen->draw(*m_renderer, scene);
        const QColor a = image.pixelColor(300, 700);
        const QColor b = image.pixelColor(308, 700);
        QVERIFY(std::abs(a.red() - b.red()) > 20);
        QVERIFY(a.red() > 90 && b.red() > 90);
    }

    void texelsNotSentYetAreNeutralAndComeInParts()
    {
        const TexelFormat format;
        const TexelStore store =
            storeOf(format, randomFace(format, 5, 1), randomFace(format, 5, 2));
        QVERIFY(m_renderer->setMesh(m_mesh));
        m_renderer->setTexels(store, 0);
        m_renderer->uploadTexels(store, 1);
        QVERIFY(m_renderer->texels().hasWork());
        QCOMPARE(picture().pixelColor(724, 324), QColor(115, 115, 115)); // in the second face
        m_renderer->uploadTexels(store, 1);
        QVERIFY(!m_renderer->texels().hasWork());
        QCOMPARE(wrongTexels(picture(), m_mesh, store), 0);
    }

    void withoutAMeshThereIsTheBackgroundOnly()
    {
        const QImage image = picture();
        QVERIFY(image.pixelColor(512, 10).lightness() > image.pixelColor(512, 1000).lightness());
        show(TexelStore(2, TexelFormat{}, Level(0), std::vector<std::byte>(3)));
        QVERIFY(picture() != image);
        m_renderer->clear();
        QCOMPARE(picture(), image);
        QVERIFY(m_renderer->setMesh({}));
        m_renderer->setTexels(TexelStore(), 0);
        m_renderer->uploadTexels(TexelStore(), kAll);
        QCOMPARE(picture(), image);
    }

    void everyShaderCompiles()
    {
        const QStringList vertex =
            QDir(QStringLiteral(":/shaders")).entryList({QStringLiteral("*.vert")});
        const QStringList fragment =
            QDir(QStringLiteral(":/shaders")).entryList({QStringLiteral("*.frag")});
        QVERIFY(vertex.size() >= 3);
        QCOMPARE(fragment.size(), vertex.size());
        for (const QString& name : vertex) {
            const auto program = loadProgram(name, QString(name).replace(".vert", ".frag"));
            QVERIFY2(program, program ? "" : program.error().message.c_str());
        }
        QVERIFY(!loadProgram(QStringLiteral("none.vert"), QStringLiteral("none.frag")));
    }

private:
    std::unique_ptr<Renderer> makeRenderer()
    {
        auto made = Renderer::create();
        if (!made) {
            qCritical("%s", made.error().message.c_str());
        }
        return made ? std::move(*made) : nullptr;
    }

    void show(const TexelStore& store, int drop = 0)
    {
        QVERIFY(m_renderer);
        QVERIFY(m_renderer->setMesh(m_mesh));
        m_renderer->setTexels(store, drop);
        m_renderer->uploadTexels(store, kAll);
    }

    QImage picture() { return m_offscreen->draw(*m_renderer, unlitScene()); }

    const TriangleMesh m_mesh = twoFaces();
    std::unique_ptr<Offscreen> m_offscreen;
    std::unique_ptr<Renderer> m_renderer;
};

QTEST_MAIN(TestRenderer)
#include "tst_renderer.moc"

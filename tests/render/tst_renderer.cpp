// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QOpenGLExtraFunctions>
#include <QRegularExpression>
#include <QTest>

#include "core/lattice/texel.h"
#include "core/texture/mips.h"
#include "render/corner_normals.h"
#include "tests/render/offscreen.h"

#include <cmath>
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

    void everyPixelShowsTheTexelItsCentreLiesIn()
    {
        const TexelFormat format;
        const TexelStore store =
            storeOf(format, randomFace(format, 5, 1), randomFace(format, 3, 2));
        show(store);
        const QImage image = picture();
        const Camera camera = facing();
        int compared = 0;
        for (std::size_t f = 0; f < 2; ++f) {
            const auto c = m_mesh.corners(faceId(f));
            const FaceTexels& face = store.face(faceId(f));
            const double resolution = face.level().resolution();
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    const PixelRay ray = camera.pixelRay({x + 0.5, y + 0.5});
                    const glm::dvec3 at =
                        ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
                    // The faces are axis-aligned right triangles.
                    const double u = (at.x - c[0].x) / (c[1].x - c[0].x);
                    const double v = (at.y - c[0].y) / (c[2].y - c[0].y);
                    const auto offLine = [&](double t) {
                        return std::abs(t * resolution - std::round(t * resolution)) > 1e-3;
                    };
                    if (u < 0 || v < 0 || u + v > 1 || !offLine(u) || !offLine(v) ||
                        !offLine(u + v)) {
                        continue;
                    }
                    ++compared;
                    const TexelIndex t =
                        texelIndex(face.level(), texelAt(face.level(), glm::dvec2(u, v)));
                    QVERIFY(
                        alike(image.pixelColor(x, y), shownColor(format, face.texel(indexOf(t)))));
                }
            }
        }
        QVERIFY(compared > 200'000);
    }

    void theVeryCornersOfFacesShowTheirCornerTexel_data()
    {
        QTest::addColumn<int>("corner");
        QTest::newRow("V1, u = 1") << 1;
        QTest::newRow("V2, v = 1") << 2;
    }

    /// Faces around a point that is the centre of a pixel: one of them covers it, with u or v
    /// exactly 1, where the cell would lie outside.
    void theVeryCornersOfFacesShowTheirCornerTexel()
    {
        QFETCH(int, corner);
        constexpr std::uint32_t kFaces = 8;
        TriangleMesh fan;
        fan.positions.push_back({0, 0, 0});
        for (std::uint32_t k = 0; k < kFaces; ++k) {
            const double a = 0.1 + k * 2 * 3.14159265358979 / kFaces;
            fan.positions.push_back({float(std::cos(a)), float(std::sin(a)), 0});
        }
        for (std::uint32_t k = 0; k < kFaces; ++k) {
            const std::uint32_t a = 1 + k;
            const std::uint32_t b = 1 + (k + 1) % kFaces;
            fan.triangles.push_back(corner == 1 ? Triangle{b, 0, a} : Triangle{a, b, 0});
        }
        const TexelFormat format;
        const Level level(3);
        std::vector<std::byte> texels(3 * level.texelCount(), std::byte{0});
        const TexelCoord at = corner == 1 ? TexelCoord{7, 0} : TexelCoord{0, 7};
        texels[3 * indexOf(texelIndex(level, at))] = std::byte{255};
        TexelStore store(kFaces, format, level, std::vector<std::byte>(3));
        for (std::uint32_t k = 0; k < kFaces; ++k) {
            store.exchange(faceId(k), FaceTexels::full(level, 3, texels));
        }
        m_renderer.reset();
        m_offscreen.reset();
        m_offscreen = std::make_unique<Offscreen>(1025, 1025);
        m_renderer = makeRenderer();
        QVERIFY(m_renderer->setMesh(fan));
        m_renderer->setTexels(store, 0);
        m_renderer->uploadTexels(store, kAll);
        QCOMPARE(picture().pixelColor(512, 512), QColor(255, 0, 0));
    }

    void manyTexelsToAPixelAreAveraged()
    {
        const TexelFormat format;
        const TexelStore store =
            storeOf(format, randomFace(format, 12, 1), randomFace(format, 1, 2));
        show(store);
        const QImage image = picture();
        double squares = 0;
        int count = 0;
        for (int y = 600; y < 700; ++y) {
            for (int x = 150; x < 250; ++x) {
                const double off = image.pixelColor(x, y).redF() - 0.5;
                squares += off * off;
                ++count;
            }
        }
        // Uniform noise has a deviation of 0.289; the mean of four of half that.
        const double deviation = std::sqrt(squares / count);
        QVERIFY2(deviation > 0.12 && deviation < 0.17, qPrintable(QString::number(deviation)));
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
        QCOMPARE(m_renderer->uploadTexels(store, kAll), std::size_t{4}); // its mean
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
        m_renderer->setCorners(SharedCorners::of(m_mesh, cornerNormals(m_mesh)));
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

    void theTexelGridKeepsItsColourInShade()
    {
        const auto lightGrey = std::vector<std::byte>(3, std::byte{200});
        show(TexelStore(2, TexelFormat{}, Level(2), lightGrey));
        Scene scene = unlitScene();
        scene.surface.lit = true;
        scene.camera.setPose({{0, 0, 0}, 3.6, -1.2, 0}); // turned away from the light
        const QImage plain = m_offscreen->draw(*m_renderer, scene);
        scene.surface.texelGrid = true;
        const QImage grid = m_offscreen->draw(*m_renderer, scene);
        int darker = 0;
        int lighter = 0;
        for (int y = 0; y < grid.height(); y += 3) {
            for (int x = 0; x < grid.width(); ++x) {
                const int step =
                    grid.pixelColor(x, y).lightness() - plain.pixelColor(x, y).lightness();
                darker += step < -4 ? 1 : 0;
                lighter += step > 4 ? 1 : 0;
            }
        }
        const glm::dvec2 inFace =
            *scene.camera.project(pointAt(m_mesh.corners(faceId(0)), 0.3F, 0.3F));
        QVERIFY(plain.pixelColor(int(inFace.x), int(inFace.y)).lightness() < 110);
        QVERIFY(darker > 100);
        QCOMPARE(lighter, 0);
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

    void facesShowTheirMeanUntilTheirTexelsHaveCome()
    {
        const TexelFormat format;
        const TexelStore store =
            storeOf(format, randomFace(format, 5, 1), randomFace(format, 5, 2));
        QVERIFY(m_renderer->setMesh(m_mesh));
        m_renderer->setTexels(store, 0);
        m_renderer->uploadTexels(store, 0);
        QVERIFY(m_renderer->texels().hasWork());
        const QImage means = picture();
        const FaceTexels mean = reduced(format, store.face(faceId(1)), 5);
        const auto part = [&](int c) { return std::to_integer<int>(mean.bytes()[std::size_t(c)]); };
        QCOMPARE(means.pixelColor(724, 324), QColor(part(0), part(1), part(2)));
        QCOMPARE(means.pixelColor(700, 300), means.pixelColor(724, 324));
        m_renderer->uploadTexels(store, kAll);
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

    void everyShaderCompilesForEveryStyle()
    {
        const QDir shaders(QStringLiteral(":/shaders"));
        const QStringList fragments = shaders.entryList({QStringLiteral("*.frag")});
        QVERIFY(fragments.size() >= 4);
        for (const QString& name : fragments) {
            if (name != "surface.frag") { // needs the style's defines
                const QString own = QString(name).replace(".frag", ".vert");
                // Those that cover the screen share one.
                const auto program =
                    loadProgram(shaders.exists(own) ? own : QString("background.vert"), name);
                QVERIFY2(program, program ? "" : program.error().message.c_str());
            }
        }
        const Status made = m_renderer->makeAllPrograms();
        QVERIFY2(made, made ? "" : made.error().message.c_str());
    }

    void aShaderThatFailsIsNamed()
    {
        const auto none = loadProgram(QStringLiteral("none.vert"), QStringLiteral("line.frag"));
        QVERIFY(!none && none.error().message.find("none.vert") != std::string::npos);
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("QOpenGLShader::compile.*"));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(".*Problematic.*"));
        const auto bad = loadProgram(QStringLiteral("line.vert"),
                                     QStringLiteral("line.frag"),
                                     QByteArrayLiteral("this is no GLSL\n"));
        QVERIFY(!bad && bad.error().message.find("line.frag") != std::string::npos);
    }

    void aRendererOfALostContextLeavesOthersAlone()
    {
        Offscreen lost;
        lost.bind();
        auto renderer = Renderer::create();
        QVERIFY(renderer);
        const TriangleMesh mesh = twoFaces();
        QVERIFY((*renderer)->setMesh(mesh));
        const TexelStore store(2, TexelFormat{}, Level(3), std::vector<std::byte>(3));
        (*renderer)->wantFilterings(std::array{Filtering::PackedAtlas});
        (*renderer)->setTexels(store, 0);
        (*renderer)->setFilterMesh(std::make_shared<const FilterMesh>(
            mesh, buildAdjacency(mesh.triangles), store, nullptr));
        while ((*renderer)->hasAtlasWork()) {
            (*renderer)->uploadAtlas(store, 1U << 20U);
        }
        Offscreen other;
        other.bind();
        auto& gl = *other.context().extraFunctions();
        // The same small numbers that the renderer's objects have in their own context.
        std::array<GLuint, 64> buffers{};
        std::array<GLuint, 64> textures{};
        gl.glGenBuffers(64, buffers.data());
        gl.glGenTextures(64, textures.data());
        for (std::size_t k = 0; k < buffers.size(); ++k) {
            gl.glBindBuffer(GL_ARRAY_BUFFER, buffers[k]);
            gl.glBindTexture(GL_TEXTURE_2D, textures[k]);
        }
        renderer->reset();
        for (std::size_t k = 0; k < buffers.size(); ++k) {
            QVERIFY(gl.glIsBuffer(buffers[k]));
            QVERIFY(gl.glIsTexture(textures[k]));
        }
    }

    void theCardsTimeOfAFrameIsKnownSomeFramesLater()
    {
        Offscreen target;
        target.bind();
        auto renderer = Renderer::create().value();
        QVERIFY(!renderer->figures().cardMs);
        QVERIFY(renderer->setMesh(twoFaces()));
        for (int k = 0; k < 20 && !renderer->figures().cardMs; ++k) {
            target.drawOnly(*renderer, unlitScene());
        }
        QVERIFY(renderer->figures().cardMs);
        QVERIFY(*renderer->figures().cardMs > 0);
        QCOMPARE(renderer->figures().faces, std::uint64_t{2});
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

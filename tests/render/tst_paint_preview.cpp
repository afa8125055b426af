// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/paint/dab_painter.h"
#include "tests/core/test_meshes.h"
#include "tests/render/offscreen.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr std::size_t kAll = ~std::size_t{0};
constexpr int kSide = 512;

/// A picture of numbers.
using Picture = std::vector<float>;

std::shared_ptr<const Surface> bumpySurface()
{
    TriangleMesh mesh = test::gridMesh(3);
    for (glm::vec3& p : mesh.positions) {
        p = 2.0F * p - glm::vec3(1, 1, 0);
        p.z = 0.2F * std::sin(4 * p.x) * std::cos(3 * p.y);
    }
    NoProgress progress;
    return *Surface::build(std::move(mesh), progress);
}

/// Faces of random texels at mixed levels, every fourth of one value.
TexelStore randomStore(const TexelFormat& format, std::size_t faces)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> in(0, 1);
    const std::vector<std::byte> zero(format.texelBytes());
    TexelStore store(static_cast<std::uint32_t>(faces), format, Level(0), zero);
    for (std::size_t f = 0; f < faces; ++f) {
        const Level level(2 + static_cast<int>(f % 5));
        const bool isConstant = f % 4 == 1;
        std::vector<float> values((isConstant ? 1 : level.texelCount()) * format.channels);
        std::ranges::generate(values, [&] { return in(random); });
        std::vector<std::byte> texels(values.size() * byteSize(format.type));
        encode(format.type, values, texels);
        store.exchange(faceId(f),
                       isConstant ? FaceTexels::constant(level, texels)
                                  : FaceTexels::full(level, format.texelBytes(), texels));
    }
    return store;
}

Brush softBrush()
{
    Brush brush;
    brush.radius = 0.35F;
    brush.hardness = 0.3F;
    brush.flow = 0.4F;
    brush.opacity = 0.9F;
    brush.color = {0.9F, 0.2F, 1.4F, 0.5F}; // beyond what integers hold
    brush.pressureToOpacity = true;
    return brush;
}

std::vector<PlacedDab> dabsOver(const std::shared_ptr<const Surface>& surface, const Brush& brush)
{
    std::vector<PlacedDab> dabs;
    StrokeDabs path(surface, brush);
    for (int k = 0; k < 6; ++k) {
        const StrokeSample sample{faceId(static_cast<std::size_t>(3 * k)),
                                  {0.3F, 0.3F},
                                  0.4F + 0.1F * static_cast<float>(k)};
        path.add(sample, [&](const Dab& dab, std::span<const FaceId> faces) {
            dabs.push_back({dab, {faces.begin(), faces.end()}});
        });
    }
    return dabs;
}

double largestDifference(const Picture& a, const Picture& b)
{
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        most = std::max(most, static_cast<double>(std::abs(a[k] - b[k])));
    }
    return most;
}

class TestPaintPreview : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Offscreen> m_screen;
    std::unique_ptr<QOpenGLFramebufferObject> m_target; ///< of numbers
    std::unique_ptr<Renderer> m_renderer;
    std::shared_ptr<const Surface> m_surface;
    TexelStore m_store;
    Look m_look;

    Picture picture(bool hasAlpha = false)
    {
        Scene scene;
        scene.camera.setViewport(kSide, kSide);
        scene.camera.setScene({-1, -1, -0.2F}, {1, 1, 0.2F});
        scene.camera.setPose({{0, 0, 0}, 3.4, 0.3, 0.2});
        scene.surface.lit = false;
        scene.surface.hasAlpha = hasAlpha;
        m_target->bind();
        m_renderer->draw(scene);
        Picture pixels(std::size_t{4} * kSide * kSide);
        auto* gl = m_screen->context().functions();
        gl->glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, pixels.data());
        [this, gl] { QCOMPARE(gl->glGetError(), GLenum{GL_NO_ERROR}); }();
        return pixels;
    }

    void open(const TexelFormat& format)
    {
        m_store = randomStore(format, m_surface->mesh().faceCount());
        QVERIFY(m_renderer->setMesh(m_surface->mesh()));
        m_renderer->setTexels(m_store, 0);
        m_renderer->setLook(m_look);
        send();
    }

    void send()
    {
        while (m_renderer->uploadTexels(m_store, kAll) > 0) {
        }
    }

    PaintPreview& begun(const Brush& brush)
    {
        PaintPreview& preview = **m_renderer->preview();
        const std::vector<std::byte> fill(m_store.format().texelBytes());
        const TexelType type = m_store.format().type;
        preview.begin(m_store.faceCount(),
                      {strokeTarget(brush, m_store.format(), fill),
                       {brush.hardness, brush.flow},
                       type == TexelType::UInt8 || type == TexelType::UInt16});
        return preview;
    }

    /// Texels as the store has them in the end.
    void commit(const Brush& brush, std::span<const PlacedDab> dabs)
    {
        const std::vector<std::byte> fill(m_store.format().texelBytes());
        DabPainter painter(m_store.format(),
                           strokeTarget(brush, m_store.format(), fill),
                           brush.hardness,
                           brush.flow,
                           Threads{1});
        for (const PlacedDab& one : dabs) {
            painter.paint(one.dab, m_surface->mesh(), one.faces, m_store);
        }
        m_renderer->touchTexels(m_store, painter.takeTouched());
        send();
    }

    void compareWithCommit(bool hasAlpha)
    {
        const Brush brush = softBrush();
        const std::vector<PlacedDab> dabs = dabsOver(m_surface, brush);
        QVERIFY(dabs.size() > 33); // more than one batch
        const Picture before = picture(hasAlpha);
        PaintPreview& preview = begun(brush);
        preview.add(m_surface->mesh(), m_store, std::span(dabs).first(5));
        preview.add(m_surface->mesh(), m_store, std::span(dabs).subspan(5));
        QVERIFY(preview.isShown());
        const Picture shown = picture(hasAlpha);
        QVERIFY(largestDifference(shown, before) > 0.3);
        preview.end();
        QCOMPARE(picture(hasAlpha), before); // a stroke taken back leaves nothing

        PaintPreview& again = begun(brush);
        again.add(m_surface->mesh(), m_store, dabs);
        QVERIFY(largestDifference(picture(hasAlpha), shown) < 1e-6);
        again.end();
        commit(brush, dabs);
        const bool isByte = m_store.format().type == TexelType::UInt8;
        QVERIFY(largestDifference(picture(hasAlpha), shown) <= (isByte ? 1.0 / 255 : 1.0 / 1024));
    }

private slots:
    void initTestCase()
    {
        m_screen = std::make_unique<Offscreen>(16, 16);
        QVERIFY(m_screen->isValid());
        m_screen->bind();
        m_target = std::make_unique<QOpenGLFramebufferObject>(
            kSide, kSide, QOpenGLFramebufferObject::Depth, GL_TEXTURE_2D, GL_RGBA32F);
        QVERIFY(m_target->isValid());
        auto made = Renderer::create();
        QVERIFY(made.has_value());
        m_renderer = std::move(*made);
        m_surface = bumpySurface();
    }

    void cleanupTestCase()
    {
        m_screen->bind();
        m_renderer.reset();
        m_target.reset();
        m_screen.reset();
    }

    void init() { m_look = {}; }

    void theStrokeLooksBeforeItsCommitAsAfterIt_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("channels");
        QTest::addColumn<bool>("alpha");
        for (const TexelType type :
             {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
            for (const int channels : {1, 3, 4}) {
                const auto name = QByteArray::fromStdString(std::string(nameOf(type))) +
                                  QByteArray::number(channels);
                QTest::newRow(name.constData())
                    << static_cast<int>(type) << channels << (channels == 4);
            }
        }
    }
    void theStrokeLooksBeforeItsCommitAsAfterIt()
    {
        QFETCH(int, type);
        QFETCH(int, channels);
        QFETCH(bool, alpha);
        TexelFormat format{
            static_cast<TexelType>(type), static_cast<std::uint16_t>(channels), std::nullopt};
        if (alpha) {
            format.alpha = 3;
        }
        open(format);
        compareWithCommit(alpha);
    }

    void aChannelThatIsShownAloneLooksTheSameToo()
    {
        m_look.channel = 4;
        open({TexelType::UInt16, 5, std::nullopt});
        compareWithCommit(false);
    }

    void facesGivenBackOneByOneNeverChangeThePicture()
    {
        open({TexelType::Float, 3, std::nullopt});
        const Brush brush = softBrush();
        const std::vector<PlacedDab> dabs = dabsOver(m_surface, brush);
        PaintPreview& preview = begun(brush);
        preview.add(m_surface->mesh(), m_store, dabs);
        const Picture shown = picture();

        const TexelStore before = m_store;
        TexelStore after = m_store;
        std::swap(m_store, after);
        DabPainter painter(m_store.format(),
                           strokeTarget(brush, m_store.format(), {}),
                           brush.hardness,
                           brush.flow,
                           Threads{1});
        for (const PlacedDab& one : dabs) {
            painter.paint(one.dab, m_surface->mesh(), one.faces, m_store);
        }
        for (const TouchedRect& rect : painter.takeTouched()) {
            m_renderer->touchTexels(m_store, std::array{rect});
            send();
            preview.release(std::array{rect.face});
            QVERIFY(largestDifference(picture(), shown) <= 1.0 / 1024);
        }
    }

    void filledFacesShowTheirColour()
    {
        open({TexelType::UInt8, 3, std::nullopt});
        const Picture before = picture();
        Brush brush = softBrush();
        PaintPreview& preview = begun(brush);
        std::vector<FaceId> faces{faceId(0), faceId(1), faceId(7), faceId(16)};
        preview.fill(faces);
        const Picture shown = picture();
        QVERIFY(largestDifference(shown, before) > 0.3);
        preview.end();
        const std::array<float, 3> color{0.9F, 0.2F, 1.4F};
        std::vector<std::byte> texel(3);
        encode(TexelType::UInt8, color, texel);
        fillFaces(m_store, faces, texel);
        m_renderer->touchAllTexels();
        send();
        QVERIFY(largestDifference(picture(), shown) <= 1.0 / 255);
    }

    void aPictureThrownOntoFacesLooksBeforeItsCommitAsAfterIt_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("channels");
        for (const TexelType type :
             {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
            QTest::newRow(std::string(nameOf(type)).c_str()) << static_cast<int>(type) << 3;
        }
        QTest::newRow("one channel") << static_cast<int>(TexelType::UInt16) << 1;
    }
    void aPictureThrownOntoFacesLooksBeforeItsCommitAsAfterIt()
    {
        QFETCH(int, type);
        QFETCH(int, channels);
        const TexelFormat format{
            static_cast<TexelType>(type), static_cast<std::uint16_t>(channels), std::nullopt};
        open(format);
        const Picture before = picture();
        std::vector<float> pixels;
        for (int k = 0; k < 64 * 48; ++k) {
            const auto x = static_cast<float>(k % 64) / 63;
            const auto y = static_cast<float>(k / 64) / 47;
            pixels.insert(pixels.end(),
                          {x, 0.5F + 0.5F * std::sin(9 * y), 1 - x * y, 0.4F + 0.6F * y});
        }
        Camera camera; // other than the one that looks
        camera.setViewport(64, 48);
        camera.setScene({-1, -1, -0.2F}, {1, 1, 0.2F});
        camera.setPose({{0.1, 0, 0}, 3.0, -0.5, 0.3});
        const PictureProjection thrown{
            glm::dmat4(camera.projection() * camera.view()), 64, 48, pixels, 0.8F};
        std::vector<FaceId> faces;
        for (std::size_t f = 0; f < m_surface->mesh().faceCount(); f += f % 3 + 1) {
            faces.push_back(faceId(f));
        }
        PaintPreview& preview = **m_renderer->preview();
        preview.begin(
            m_store.faceCount(),
            {{}, {}, format.type == TexelType::UInt8 || format.type == TexelType::UInt16});
        preview.project(m_surface->mesh(), m_store, faces, thrown);
        const Picture shown = picture();
        QVERIFY(largestDifference(shown, before) > 0.3);
        preview.end();
        QCOMPARE(picture(), before);
        projectPicture(m_store, m_surface->mesh(), faces, thrown, Threads{1});
        m_renderer->touchAllTexels();
        send();
        const double most = format.type == TexelType::UInt8 ? 1.0 / 255 : 1.0 / 1024;
        QVERIFY(largestDifference(picture(), shown) <= most);
    }

    void aFaceTooLargeForTheSheetLeavesRoomForOthers()
    {
        const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
        FaceMap<Level> levels(m_surface->mesh().faceCount(), Level(3));
        levels[faceId(0)] = Level(12);
        m_store = TexelStore(format, levels, std::vector<std::byte>(3));
        m_renderer->setCardBudget(std::uint64_t{256} << 20U);
        QVERIFY(m_renderer->setMesh(m_surface->mesh()));
        m_renderer->setTexels(m_store, 0);
        send();
        Brush brush = softBrush();
        brush.radius = 4;
        brush.paintThrough = true;
        PaintPreview& preview = begun(brush);
        PlacedDab dab{{{0, 0, 0}, {}, 0.01F, 1}, {}};
        for (std::size_t f = 0; f < levels.size(); ++f) {
            dab.faces.push_back(faceId(f));
        }
        preview.add(m_surface->mesh(), m_store, std::array{dab});
        QVERIFY(!preview.hasSquare(faceId(0)));
        for (std::size_t f = 1; f < levels.size(); ++f) {
            QVERIFY(preview.hasSquare(faceId(f)));
        }
        preview.end();
    }

    void facesWithoutRoomShowTheStoreAndTheRestGoesOn()
    {
        const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
        const std::vector<std::byte> black(3);
        m_store = TexelStore(static_cast<std::uint32_t>(m_surface->mesh().faceCount()),
                             format,
                             Level(11), // eight of these fill the sheet; they store one texel
                             black);
        m_renderer->setCardBudget(std::uint64_t{2} << 30U); // of which the sheet has an eighth
        QVERIFY(m_renderer->setMesh(m_surface->mesh()));
        m_renderer->setTexels(m_store, 0);
        send();
        Brush brush = softBrush();
        brush.radius = 4;
        brush.paintThrough = true;
        PaintPreview& preview = begun(brush);
        PlacedDab dab{{{0, 0, 0}, {}, 0.01F, 1}, {}};
        for (std::size_t f = 0; f < m_surface->mesh().faceCount(); ++f) {
            dab.faces.push_back(faceId(f));
        }
        preview.add(m_surface->mesh(), m_store, std::array{dab});
        std::size_t squares = 0;
        for (const FaceId face : dab.faces) {
            squares += preview.hasSquare(face) ? 1 : 0;
        }
        QVERIFY(squares >= 4 && squares < dab.faces.size());
        preview.end();
        QVERIFY(!preview.isShown());
        QVERIFY(preview.sheet().bytes() < 20'000'000); // and the room is given back
    }
};

} // namespace

QTEST_MAIN(TestPaintPreview)
#include "tst_paint_preview.moc"

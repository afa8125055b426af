// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the card makes of a look is what `shade` makes of it.
#include <QTest>

#include "core/lattice/texel.h"
#include "render/look.h"
#include "tests/render/offscreen.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr std::size_t kAll = ~std::size_t{0};
constexpr int kSize = 256;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Two triangles in the plane z = 0 that face the camera, one a half turn of
/// the other.
TriangleMesh twoFaces()
{
    return {{{-1, -1, 0}, {0.9F, -1, 0}, {-1, 0.9F, 0}, {1, 1, 0}, {-0.9F, 1, 0}, {1, -0.9F, 0}},
            {{0, 1, 2}, {3, 4, 5}},
            {}};
}

Scene unlitScene(const TexelFormat& format)
{
    Scene scene;
    scene.camera.setViewport(kSize, kSize);
    scene.camera.setScene({-1, -1, 0}, {1, 1, 0});
    scene.camera.setPose({{0, 0, 0}, 3.6, 0, 0});
    scene.surface.lit = false;
    scene.surface.hasAlpha = format.alpha.has_value();
    return scene;
}

/// Values in and out of [0, 1]; of floating types also the ones no colour can
/// show.
FaceTexels wildFace(const TexelFormat& format, int level, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> in(-0.4F, 1.6F);
    std::vector<float> values(Level(level).texelCount() * format.channels);
    std::ranges::generate(values, [&] { return in(random); });
    const float wild[] = {std::nanf(""), kInfinity, -kInfinity, 60000, -60000, -0.0F, 1e-6F};
    for (std::size_t k = 0; k < values.size(); k += 7) {
        values[k] = wild[(k / 7) % std::size(wild)];
    }
    std::vector<std::byte> texels(values.size() * byteSize(format.type));
    encode(format.type, values, texels);
    return FaceTexels::full(Level(level), format.texelBytes(), texels);
}

TexelStore wildStore(const TexelFormat& format)
{
    TexelStore store(2, format, Level(0), std::vector<std::byte>(format.texelBytes()));
    store.exchange(faceId(0), wildFace(format, 3, 1));
    store.exchange(faceId(1), wildFace(format, 2, 2));
    return store;
}

std::vector<Look> manyLooks()
{
    std::vector<Look> looks{{}};
    for (int k = 0; k < 36; ++k) {
        Look look;
        if (const int channel = k % 6; channel > 0) {
            look.channel = static_cast<std::uint16_t>(channel - 1);
        }
        look.falseColor = k % 4 == 1;
        look.luminance = k % 5 == 2;
        look.marks = k % 3 == 1;
        look.opaque = k % 7 == 3;
        if (k % 2 == 1) {
            look.exposure = static_cast<float>(k % 11 - 5) * 0.7F;
            look.low = static_cast<float>(k % 9) * 0.1F - 0.3F;
            look.high = k % 8 == 7 ? look.low - 1 : look.low + 0.4F + static_cast<float>(k % 3);
        }
        looks.push_back(look);
    }
    return looks;
}

bool alike(const QColor& a, const Rgba& b)
{
    return std::abs(a.red() - b[0]) <= 1 && std::abs(a.green() - b[1]) <= 1 &&
           std::abs(a.blue() - b[2]) <= 1;
}

/// The colour over the checker of the view.
Rgba overChecker(Rgba color, QPoint pixel)
{
    const int square = pixel.x() / 8 + (kSize - 1 - pixel.y()) / 8;
    const double checker = 255 * (square % 2 == 0 ? 0.42 : 0.58);
    for (std::size_t c = 0; c < 3; ++c) {
        const double mixed = checker + (color[c] - checker) * color[3] / 255.0;
        color[c] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    return color;
}

QString describe(const Look& look)
{
    return QString("channel %1 exposure %2 range %3 %4 luminance %5 false %6 "
                   "marks %7 opaque %8")
        .arg(look.channel ? int(*look.channel) : -1)
        .arg(look.exposure)
        .arg(look.low)
        .arg(look.high)
        .arg(look.luminance)
        .arg(look.falseColor)
        .arg(look.marks)
        .arg(look.opaque);
}

} // namespace

class TestRendererLook : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_offscreen = std::make_unique<Offscreen>(kSize, kSize);
        QVERIFY2(m_offscreen->isValid(), "OpenGL 4.1 core is needed");
        auto made = Renderer::create();
        QVERIFY2(made, made ? "" : made.error().message.c_str());
        m_renderer = std::move(*made);
    }

    void cleanup()
    {
        QVERIFY(!m_offscreen->hadErrors());
        m_renderer.reset();
        m_offscreen.reset();
    }

    void everyLookShowsTheColoursOfShade_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<int>("channels");
        QTest::addColumn<bool>("alpha");
        for (const auto& [name, type] : {std::pair("uint8", 0),
                                         std::pair("uint16", 1),
                                         std::pair("half", 2),
                                         std::pair("float", 3)}) {
            QTest::addRow("%s, 1 channel", name) << type << 1 << false;
            QTest::addRow("%s, 3 channels", name) << type << 3 << false;
            QTest::addRow("%s, 6 channels", name) << type << 6 << false;
            QTest::addRow("%s, colour and opacity", name) << type << 4 << true;
            QTest::addRow("%s, grey and opacity", name) << type << 2 << true;
        }
    }

    void everyLookShowsTheColoursOfShade()
    {
        QFETCH(int, type);
        QFETCH(int, channels);
        QFETCH(bool, alpha);
        TexelFormat format{static_cast<TexelType>(type), static_cast<std::uint16_t>(channels), {}};
        if (alpha) {
            format.alpha = static_cast<std::uint16_t>(channels - 1);
        }
        const TexelStore store = wildStore(format);
        show(store);
        for (const Look& look : manyLooks()) {
            const QImage image = picture(store, look);
            const QString wrong = firstWrongTexel(image, store, look);
            QVERIFY2(wrong.isEmpty(), qPrintable(describe(look) + ": " + wrong));
        }
    }

    void sixteenBitIntegersKeepTheirLowerByte()
    {
        const TexelFormat format{TexelType::UInt16, 1, {}};
        std::vector<std::uint16_t> words(16);
        for (std::size_t k = 0; k < words.size(); ++k) {
            words[k] = static_cast<std::uint16_t>(0x8000 + k);
        }
        TexelStore store(2, format, Level(2), std::vector<std::byte>(2));
        store.exchange(faceId(0), FaceTexels::full(Level(2), 2, std::as_bytes(std::span(words))));
        show(store);
        Look look;
        look.low = 0x8000 / 65535.0F;
        look.high = 0x800f / 65535.0F;
        const QImage image = picture(store, look);
        QCOMPARE(firstWrongTexel(image, store, look), QString());
        std::set<int> levels;
        for (std::uint32_t t = 0; t < 16; ++t) {
            levels.insert(image.pixelColor(pixelOf(store, 0, t)).red());
        }
        QCOMPARE(levels.size(), std::size_t{16});
    }

    void numbersBeyondHalfAreNotTakenForInfinite()
    {
        const TexelFormat format{TexelType::Float, 1, {}};
        const std::vector<float> values{1e30F, kInfinity, -1e30F, 70000};
        TexelStore store(2, format, Level(1), std::vector<std::byte>(4));
        store.exchange(faceId(0), FaceTexels::full(Level(1), 4, std::as_bytes(std::span(values))));
        show(store);
        Look look;
        look.marks = true;
        look.high = 2e30F;
        QCOMPARE(firstWrongTexel(picture(store, look), store, look), QString());
    }

    void aChannelThatWasNotSentComesWhenItIsLookedAt()
    {
        const TexelFormat format{TexelType::UInt8, 6, {}};
        const TexelStore store = wildStore(format);
        show(store);
        Look look;
        look.channel = 2;
        m_renderer->setLook(look);
        QVERIFY(!m_renderer->texels().hasWork());
        look.channel = 5;
        m_renderer->setLook(look);
        QVERIFY(m_renderer->texels().hasWork());
        QCOMPARE(firstWrongTexel(picture(store, look), store, look), QString());
        m_renderer->setLook({});
        QVERIFY(m_renderer->texels().hasWork());
        QCOMPARE(firstWrongTexel(picture(store, {}), store, {}), QString());
    }

    void marksAreDrawnInColourAndInk()
    {
        const TexelFormat format{TexelType::Float, 1, {}};
        Look look;
        look.marks = true;
        for (const auto& [value, mark] : {std::pair(std::nanf(""), Mark::NotANumber),
                                          std::pair(-kInfinity, Mark::Infinite),
                                          std::pair(-0.5F, Mark::Negative),
                                          std::pair(1.5F, Mark::Clipped)}) {
            const TexelStore store(2, format, Level(0), std::as_bytes(std::span(&value, 1)));
            show(store);
            const QImage image = picture(store, look);
            int ink = 0;
            const QPoint middle = pixelOf(store, 0, 0);
            for (int k = 0; k < 256; ++k) {
                const QColor seen = image.pixelColor(middle + QPoint(k % 16, k / 16));
                const bool isInk = alike(seen, kMarkInk);
                QVERIFY(isInk || alike(seen, markColor(mark)));
                ink += isInk ? 1 : 0;
            }
            QVERIFY2(ink > 80 && ink < 140, qPrintable(QString::number(ink)));
        }
    }

    void falseColourIsNotLit()
    {
        const TexelStore store = wildStore({TexelType::Float, 3, {}});
        show(store);
        Look look;
        look.falseColor = true;
        const QImage unlit = picture(store, look);
        Scene scene = unlitScene(store.format());
        scene.surface.lit = true;
        QCOMPARE(m_offscreen->draw(*m_renderer, scene), unlit);
    }

    void manyTexelsToAPixelShowTheirMarks()
    {
        const TexelFormat format{TexelType::Float, 1, {}};
        std::vector<float> values(Level(9).texelCount());
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] = k % 2 == 0 ? 0.25F : std::nanf("");
        }
        TexelStore store(2, format, Level(0), std::vector<std::byte>(4));
        store.exchange(faceId(0), FaceTexels::full(Level(9), 4, std::as_bytes(std::span(values))));
        show(store);
        Look look;
        look.marks = true;
        const QImage image = picture(store, look);
        int marked = 0;
        for (int k = 0; k < 400; ++k) {
            const QColor seen = image.pixelColor(60 + k % 20, 180 + k / 20);
            marked += alike(seen, kMarkInk) || alike(seen, markColor(Mark::NotANumber)) ? 1 : 0;
        }
        QVERIFY2(marked > 300, qPrintable(QString::number(marked)));
    }

private:
    void show(const TexelStore& store)
    {
        QVERIFY(m_renderer->setMesh(m_mesh));
        m_renderer->setTexels(store, 0);
        m_renderer->uploadTexels(store, kAll);
    }

    QImage picture(const TexelStore& store, const Look& look)
    {
        m_renderer->setLook(look);
        m_renderer->uploadTexels(store, kAll);
        return m_offscreen->draw(*m_renderer, unlitScene(store.format()));
    }

    /// Where a texel's centroid is seen.
    QPoint pixelOf(const TexelStore& store, std::size_t face, std::uint32_t texel) const
    {
        const Level level = store.face(faceId(face)).level();
        const glm::vec2 uv(centroid(level, texelAt(level, static_cast<TexelIndex>(texel))));
        const glm::vec3 point = pointAt(m_mesh.corners(faceId(face)), uv.x, uv.y);
        const glm::dvec2 pixel = unlitScene(store.format()).camera.project(point).value();
        return QPoint(int(pixel.x), int(pixel.y));
    }

    /// Which texel does not show its colour where its centroid is seen, and what
    /// it shows.
    QString firstWrongTexel(const QImage& image, const TexelStore& store, const Look& look) const
    {
        const TexelFormat& format = store.format();
        std::vector<float> values(format.channels);
        for (std::size_t f = 0; f < store.faceCount(); ++f) {
            const FaceTexels& face = store.face(faceId(f));
            for (std::uint32_t t = 0; t < face.level().texelCount(); ++t) {
                decode(format.type, face.texel(t), values);
                const QPoint pixel = pixelOf(store, f, t);
                const QColor seen = image.pixelColor(pixel);
                const Rgba color = shade(format, values, look);
                const bool isMarked = look.marks && markOf(format, values, look) != Mark::None;
                if (!alike(seen, overChecker(color, pixel)) &&
                    !(isMarked && alike(seen, kMarkInk))) {
                    return QString("face %1 texel %2 is %3, not %4 %5 %6 %7; value %8")
                        .arg(f)
                        .arg(t)
                        .arg(seen.name())
                        .arg(color[0])
                        .arg(color[1])
                        .arg(color[2])
                        .arg(color[3])
                        .arg(double(values[0]));
                }
            }
        }
        return {};
    }

    const TriangleMesh m_mesh = twoFaces();
    std::unique_ptr<Offscreen> m_offscreen;
    std::unique_ptr<Renderer> m_renderer;
};

QTEST_MAIN(TestRendererLook)
#include "tst_renderer_look.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/texture/mips.h"
#include "ui/inspector/face_painter.h"

#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <thread>
#include <vector>

namespace trixel::ui {

namespace {

constexpr QRgb kBackground = 0xff102030;

/// Every texel another colour.
FaceTexels manyColors(Level level)
{
    std::vector<std::byte> bytes;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        bytes.push_back(static_cast<std::byte>(k & 0xffU));
        bytes.push_back(static_cast<std::byte>((k >> 8U) & 0xffU));
        bytes.push_back(static_cast<std::byte>(k * 37 % 251));
    }
    return FaceTexels::full(level, 3, bytes);
}

QRgb colorOf(const FaceTexels& texels, TexelCoord texel)
{
    const auto bytes = texels.texel(indexOf(texelIndex(texels.level(), texel)));
    return qRgb(static_cast<int>(bytes[0]), static_cast<int>(bytes[1]), static_cast<int>(bytes[2]));
}

QImage canvas(int width = 300, int height = 260)
{
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(kBackground);
    return image;
}

std::vector<FaceLayout> layoutsInPixels()
{
    return {FaceLayout::packed().moved({{20, 250}, {230, 0}, {0, -230}}),
            FaceLayout::rectilinear().moved({{10.3, 240.7}, {270, 0}, {0, -220}}),
            FaceLayout::triangle({5, 200}, {290, 130}, {40, 3}),
            FaceLayout::triangle({-4000, 3000}, {5000, 2500}, {300, -6000}), // far beyond
            FaceLayout::triangle({250, 20}, {20, 20}, {100, 240})};
}

ShadedTexels shadesOf(const FaceTexels& texels, const render::Look& look = {})
{
    return {TexelFormat{}, look, texels.level()};
}

int channelGap(QRgb a, QRgb b)
{
    return std::max({std::abs(qRed(a) - qRed(b)),
                     std::abs(qGreen(a) - qGreen(b)),
                     std::abs(qBlue(a) - qBlue(b))});
}

} // namespace

class FacePainterTest : public QObject
{
    Q_OBJECT

private slots:
    void everyPixelShowsTheTexelUnderItsMiddle()
    {
        for (const Level level : {Level(0), Level(2), Level(5), Level(7)}) {
            const FaceTexels texels = manyColors(level);
            for (const FaceLayout& layout : layoutsInPixels()) {
                QImage image = canvas();
                ShadedTexels shades = shadesOf(texels);
                paintTexels(image, image.rect(), layout, texels, shades, {.smooth = false});
                for (int y = 0; y < image.height(); ++y) {
                    for (int x = 0; x < image.width(); ++x) {
                        // On a line between texels either may be shown.
                        bool right = false;
                        for (const double aside : {0.0, -1e-6, 1e-6}) {
                            const auto texel =
                                layout.texelAt(level, {x + 0.5 + aside, y + 0.5 + 0.7 * aside});
                            const QRgb expected = texel ? colorOf(texels, *texel) : kBackground;
                            right = right || image.pixel(x, y) == expected;
                        }
                        QVERIFY(right);
                    }
                }
            }
        }
    }

    void smoothPicturesDifferOnlyWhereTexelsMeet()
    {
        const Level level(3);
        const FaceTexels texels = manyColors(level);
        for (const FaceLayout& layout : layoutsInPixels()) {
            QImage crisp = canvas();
            QImage smooth = canvas();
            ShadedTexels shades = shadesOf(texels);
            paintTexels(crisp, crisp.rect(), layout, texels, shades, {.smooth = false});
            paintTexels(smooth, smooth.rect(), layout, texels, shades);
            int mixed = 0;
            for (int y = 0; y < crisp.height(); ++y) {
                for (int x = 0; x < crisp.width(); ++x) {
                    if (crisp.pixel(x, y) == smooth.pixel(x, y)) {
                        continue;
                    }
                    ++mixed;
                    // Then another texel lies within a pixel's reach.
                    const auto here = layout.texelAt(level, {x + 0.5, y + 0.5});
                    QVERIFY(here);
                    bool meets = false;
                    for (const double dx : {-0.5, 0.0, 0.5}) {
                        for (const double dy : {-0.5, 0.0, 0.5}) {
                            const auto there = layout.texelAt(level, {x + 0.5 + dx, y + 0.5 + dy});
                            meets = meets || there != here;
                        }
                    }
                    QVERIFY(meets);
                }
            }
            QVERIFY(mixed < crisp.width() * crisp.height() / 5);
        }
    }

    void facesThatMeetLeaveNoGap()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> any(0, 260);
        const FaceTexels texels = FaceTexels::constant(Level(0), manyColors(Level(0)).texel(0));
        for (int k = 0; k < 50; ++k) {
            // A fan that covers the picture's middle from all sides.
            const glm::dvec2 middle(any(random) / 3 + 90, any(random) / 3 + 90);
            QImage image = canvas();
            for (int part = 0; part < 7; ++part) {
                const auto at = [&](int n) {
                    const double angle = 6.283185307179586 * (n % 7) / 7 + k;
                    return middle + 80.0 * glm::dvec2(std::cos(angle), std::sin(angle));
                };
                ShadedTexels shades = shadesOf(texels);
                const auto layout = FaceLayout::triangle(middle, at(part), at(part + 1));
                paintTexels(image, image.rect(), layout, texels, shades);
            }
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (glm::length(glm::dvec2(x + 0.5, y + 0.5) - middle) < 70) {
                        QVERIFY(image.pixel(x, y) != kBackground);
                    }
                }
            }
        }
    }

    void nothingIsDrawnBesideTheClip()
    {
        const FaceTexels texels = manyColors(Level(4));
        const QRect clip(100, 90, 60, 50);
        for (const FaceLayout& layout : layoutsInPixels()) {
            QImage image = canvas();
            ShadedTexels shades = shadesOf(texels);
            paintTexels(image, clip, layout, texels, shades);
            paintTexels(image, QRect(-500, -500, 400, 400), layout, texels, shades);
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    QVERIFY(clip.contains(x, y) || image.pixel(x, y) == kBackground);
                }
            }
        }
    }

    void onlyWhatIsSeenIsShaded()
    {
        const FaceTexels texels = manyColors(Level(9));
        ShadedTexels shades = shadesOf(texels);
        QImage image = canvas(40, 40);
        // 40 × 40 texels of the middle of the face.
        const auto layout = FaceLayout::packed().moved({{-200, -150}, {512, 0}, {0, 512}});
        paintTexels(image, image.rect(), layout, texels, shades);
        QVERIFY(shades.memoryBytes() <= 9 * 32 * 32 * sizeof(QRgb));
        QVERIFY(shades.memoryBytes() > 0);
    }

    void forgottenTexelsAreShadedAnewAndOthersAreKept()
    {
        const Level level(7);
        FaceTexels texels = manyColors(level);
        ShadedTexels shades = shadesOf(texels);
        const auto layout = FaceLayout::packed().moved({{0, 0}, {128, 0}, {0, 128}});
        QImage before = canvas(128, 128);
        paintTexels(before, before.rect(), layout, texels, shades);
        auto bytes = texels.writable();
        const auto paint = [&](std::size_t x, std::size_t y) {
            std::fill_n(
                bytes.begin() + static_cast<std::ptrdiff_t>((y * 128 + x) * 3), 3, std::byte{9});
        };
        paint(40, 50);
        paint(100, 100);
        shades.forget(TouchedRect{.x = 40, .y = 50, .width = 1, .height = 1});
        QImage after = canvas(128, 128);
        paintTexels(after, after.rect(), layout, texels, shades);
        QCOMPARE(after.pixel(40, 50), qRgb(9, 9, 9));
        QCOMPARE(after.pixel(100, 100), before.pixel(100, 100)); // nobody said
        shades.forget(TouchedRect{.wholeFace = true});
        paintTexels(after, after.rect(), layout, texels, shades);
        QCOMPARE(after.pixel(100, 100), qRgb(9, 9, 9));
    }

    void transparentTexelsLetTheBackgroundThrough()
    {
        const std::array bytes{std::byte{200}, std::byte{100}, std::byte{0}, std::byte{51}};
        const FaceTexels texels = FaceTexels::constant(Level(3), bytes);
        ShadedTexels shades({TexelType::UInt8, 4, std::uint16_t{3}}, {}, Level(3));
        QImage image = canvas();
        image.fill(qRgb(100, 100, 100));
        const auto layout = FaceLayout::packed().moved({{0, 0}, {100, 0}, {0, 100}});
        paintTexels(image, image.rect(), layout, texels, shades);
        // A fifth of the texel, four fifths of what was there.
        QVERIFY(channelGap(image.pixel(50, 50), qRgb(120, 100, 80)) <= 1);
    }

    void tintsTellUpperTexelsFromLower()
    {
        const std::array bytes{std::byte{100}, std::byte{100}, std::byte{100}};
        const FaceTexels texels = FaceTexels::constant(Level(2), bytes);
        for (const FaceLayout& layout : layoutsInPixels()) {
            QImage image = canvas();
            ShadedTexels shades = shadesOf(texels);
            paintTexels(image,
                        image.rect(),
                        layout,
                        texels,
                        shades,
                        {.upperTint = qPremultiply(qRgba(255, 0, 0, 128)), .smooth = false});
            for (int y = 0; y < image.height(); y += 7) {
                for (int x = 0; x < image.width(); x += 7) {
                    if (const auto texel = layout.texelAt(Level(2), {x + 0.5, y + 0.5})) {
                        const bool tinted = qRed(image.pixel(x, y)) > 150;
                        QCOMPARE(tinted, texel->half == TexelHalf::Upper);
                    }
                }
            }
        }
    }

    void marksOfTheLookAreDrawnWithTheirPatterns()
    {
        std::vector<float> numbers(64, 0.5F);
        const std::size_t bad = indexOf(texelIndex(Level(3), TexelCoord{2, 2, TexelHalf::Lower}));
        numbers[bad] = std::numeric_limits<float>::quiet_NaN();
        const FaceTexels texels = FaceTexels::full(Level(3), 4, std::as_bytes(std::span(numbers)));
        render::Look look;
        look.marks = true;
        ShadedTexels shades({TexelType::Float, 1, {}}, look, Level(3));
        QImage image = canvas(160, 160);
        const auto layout = FaceLayout::packed().moved({{0, 0}, {160, 0}, {0, 160}});
        paintTexels(image, image.rect(), layout, texels, shades);
        int inked = 0;
        for (int y = 42; y < 58; ++y) {
            for (int x = 42; x < 58; ++x) {
                const bool ink = render::hasInk(render::Mark::NotANumber, x, y);
                const render::Rgba color =
                    ink ? render::kMarkInk : render::markColor(render::Mark::NotANumber);
                QCOMPARE(image.pixel(x, y), qRgb(color[0], color[1], color[2]));
                inked += ink ? 1 : 0;
            }
        }
        QVERIFY(inked > 30 && inked < 220);
        QCOMPARE(image.pixel(10, 10), qRgb(128, 128, 128));
        const render::Rgba plain = render::markColor(render::Mark::NotANumber);
        QCOMPARE(plainColor(shades.at(texels, {2, 2})), qRgb(plain[0], plain[1], plain[2]));
    }

    void severalThreadsMayAskAtOnce()
    {
        const FaceTexels texels = manyColors(Level(8));
        ShadedTexels shades = shadesOf(texels);
        std::atomic<int> wrong = 0;
        {
            std::vector<std::jthread> readers;
            for (unsigned seed = 0; seed < 4; ++seed) {
                readers.emplace_back([&, seed] {
                    std::mt19937 random(seed);
                    for (int k = 0; k < 20000; ++k) {
                        const auto texel =
                            texelAt(Level(8), static_cast<TexelIndex>(random() & 0xffffU));
                        const PackedPixel pixel = packedPixel(Level(8), texel);
                        wrong += shades.at(texels, pixel) != colorOf(texels, texel) ? 1 : 0;
                    }
                });
            }
        }
        QCOMPARE(wrong.load(), 0);
    }

    void theLevelDrawnHasAboutAsManyTexelsAsPixels()
    {
        const auto square = [](double side) {
            return FaceLayout::packed().moved({{0, 0}, {side, 0}, {0, side}});
        };
        QCOMPARE(levelToDraw(square(300), Level(12)), Level(8));
        QCOMPARE(levelToDraw(square(256), Level(12)), Level(8));
        QCOMPARE(levelToDraw(square(190), Level(12)), Level(8));
        QCOMPARE(levelToDraw(square(175), Level(12)), Level(7));
        QCOMPARE(levelToDraw(square(300), Level(3)), Level(3));
        QCOMPARE(levelToDraw(square(0.1), Level(3)), Level(0));
        // A triangle has half the pixels.
        QCOMPARE(levelToDraw(FaceLayout::triangle({0, 0}, {240, 0}, {0, 240}), Level(12)),
                 Level(7));
        QCOMPARE(texelSide(square(300), Level(1)), 150.0);
    }
};

} // namespace trixel::ui

QTEST_GUILESS_MAIN(trixel::ui::FacePainterTest)
#include "tst_face_painter.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/render/offscreen.h"

#include <bit>
#include <vector>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 200;

std::uint32_t rgba(int r, int g, int b, int a = 255)
{
    const std::array<std::uint8_t, 4> bytes{static_cast<std::uint8_t>(r),
                                            static_cast<std::uint8_t>(g),
                                            static_cast<std::uint8_t>(b),
                                            static_cast<std::uint8_t>(a)};
    return std::bit_cast<std::uint32_t>(bytes);
}

/// Every pixel tells where it is.
std::vector<std::uint32_t> gradient()
{
    std::vector<std::uint32_t> pixels;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            pixels.push_back(rgba(x % 256, y, x / 256));
        }
    }
    return pixels;
}

} // namespace

class TestPicture : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_offscreen = std::make_unique<Offscreen>(kWidth, kHeight);
        QVERIFY2(m_offscreen->isValid(), "OpenGL 4.1 core is needed");
        auto made = Renderer::create();
        QVERIFY(made);
        m_renderer = std::move(*made);
    }
    void cleanup()
    {
        QVERIFY(!m_offscreen->hadErrors());
        m_renderer.reset();
        m_offscreen.reset();
    }

    void coversTheViewPixelOnPixelFromTheTop()
    {
        m_renderer->picture().set(gradient(), {kWidth, kHeight});
        const QImage image = m_offscreen->draw(*m_renderer, {});
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                QCOMPARE(image.pixelColor(x, y), QColor(x % 256, y, x / 256));
            }
        }
    }

    void whereItIsClearTheSurfaceShows()
    {
        const QImage without = m_offscreen->draw(*m_renderer, {});
        std::vector<std::uint32_t> pixels = gradient();
        std::fill(pixels.begin(), pixels.begin() + kWidth * 100, rgba(255, 255, 255, 0));
        m_renderer->picture().set(pixels, {kWidth, kHeight});
        const QImage image = m_offscreen->draw(*m_renderer, {});
        QCOMPARE(image.copy(0, 0, kWidth, 100), without.copy(0, 0, kWidth, 100));
        QCOMPARE(image.pixelColor(7, 150), QColor(7, 150, 0));
        m_renderer->picture().clear();
        QCOMPARE(m_offscreen->draw(*m_renderer, {}), without);
    }

    void rowsAreTakenAnew()
    {
        m_renderer->picture().set(gradient(), {kWidth, kHeight});
        m_renderer->picture().setRows(std::vector(2 * kWidth, rgba(9, 8, 7)), 50);
        const QImage image = m_offscreen->draw(*m_renderer, {});
        QCOMPARE(image.pixelColor(100, 49), QColor(100, 49, 0));
        QCOMPARE(image.pixelColor(100, 50), QColor(9, 8, 7));
        QCOMPARE(image.pixelColor(100, 51), QColor(9, 8, 7));
        QCOMPARE(image.pixelColor(100, 52), QColor(100, 52, 0));
    }

    void linesAreDrawnOverIt()
    {
        m_renderer->picture().set(std::vector(kWidth * kHeight, rgba(0, 0, 0)), {kWidth, kHeight});
        Scene scene;
        scene.camera.setScene({-1, -1, 0}, {1, 1, 0});
        scene.camera.setPose({{0, 0, 0}, 3.6, 0, 0});
        Polyline line;
        line.points = {{-1, 0, 0}, {1, 0, 0}};
        line.width = 6;
        scene.overlays = {line};
        const QImage image = m_offscreen->draw(*m_renderer, scene);
        QCOMPARE(image.pixelColor(kWidth / 2, kHeight / 2), QColor(255, 255, 255));
        QCOMPARE(image.pixelColor(kWidth / 2, kHeight / 4), QColor(0, 0, 0));
    }

private:
    std::unique_ptr<Offscreen> m_offscreen;
    std::unique_ptr<Renderer> m_renderer;
};

QTEST_MAIN(TestPicture)
#include "tst_picture.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/render/offscreen.h"

#include <cmath>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr std::size_t kAll = ~std::size_t{0};

/// A square of two faces in z = 0.
TriangleMesh square()
{
    return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}};
}

Polyline ring(float z, float radius = 0.5F)
{
    Polyline line;
    for (int k = 0; k < 64; ++k) {
        const float a = static_cast<float>(k) / 64.0F * 6.2831853F;
        line.points.push_back({radius * std::cos(a), radius * std::sin(a), z});
    }
    line.closed = true;
    line.color = {1, 0.8F, 0, 1};
    line.width = 2;
    return line;
}

Scene scene()
{
    Scene result;
    result.camera.setScene({-1, -1, 0}, {1, 1, 0});
    result.camera.setPose({{0, 0, 0}, 3.6, 0, 0});
    result.surface.lit = false;
    return result;
}

int changedPixels(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
        }
    }
    return count;
}

} // namespace

class TestOverlay : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_offscreen = std::make_unique<Offscreen>(800, 800);
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

    void aRingInTheSurfaceShowsOnWhiteAndOnBlack_data()
    {
        QTest::addColumn<int>("texel");
        QTest::addColumn<double>("yaw");
        QTest::newRow("white") << 255 << 0.0;
        QTest::newRow("black") << 0 << 0.0;
        QTest::newRow("grey") << 128 << 0.0;
        QTest::newRow("grazing") << 255 << 1.4;
    }

    void aRingInTheSurfaceShowsOnWhiteAndOnBlack()
    {
        QFETCH(int, texel);
        QFETCH(double, yaw);
        showAll(texel);
        Scene s = scene();
        s.camera.setPose({{0, 0, 0}, 3.6, yaw, 0});
        const QImage without = m_offscreen->draw(*m_renderer, s);
        const Polyline line = ring(0);
        s.overlays = {line};
        const QImage with = m_offscreen->draw(*m_renderer, s);
        s.camera.setViewport(800, 800);
        int seen = 0;
        for (const glm::vec3& point : line.points) {
            const glm::dvec2 p = *s.camera.project(point);
            const QColor color = with.pixelColor(int(p.x), int(p.y));
            seen += color.red() - color.blue() > 100 ? 1 : 0;
        }
        QVERIFY2(seen >= 60, qPrintable(QString::number(seen)));
        // Dark beside the bright line, whatever lies below.
        const int changed = changedPixels(with, without);
        QVERIFY2(changed > 500 && changed < 20000, qPrintable(QString::number(changed)));
    }

    void whatLiesBehindTheSurfaceIsHidden()
    {
        showAll(255);
        Scene s = scene();
        const QImage without = m_offscreen->draw(*m_renderer, s);
        s.overlays = {ring(-0.3F)};
        QCOMPARE(changedPixels(m_offscreen->draw(*m_renderer, s), without), 0);
        s.overlays[0].hiddenOpacity = 0.3F;
        QVERIFY(changedPixels(m_offscreen->draw(*m_renderer, s), without) > 500);
    }

    void linesThatPassBehindTheEyeStayFinite()
    {
        showAll(128);
        Scene s = scene();
        s.camera.setPose({{0, 0, 0}, 0.5, 0.3, 0.2});
        Polyline line;
        line.points = {{0, 0, 0.01F}, {0, 0.2F, 30}, {5, 0, 40}, {0.1F, 0, 0.01F}};
        s.overlays = {line};
        const QImage image = m_offscreen->draw(*m_renderer, s);
        QVERIFY(!image.isNull());
    }

    void aLineOfOnePointOrNoneDrawsNothing()
    {
        showAll(128);
        Scene s = scene();
        const QImage without = m_offscreen->draw(*m_renderer, s);
        s.overlays = {Polyline{}, Polyline{{{0, 0, 0}}}};
        QCOMPARE(m_offscreen->draw(*m_renderer, s), without);
    }

private:
    void showAll(int texel)
    {
        const TexelStore store(
            2, TexelFormat{}, Level(1), std::vector<std::byte>(3, static_cast<std::byte>(texel)));
        QVERIFY(m_renderer->setMesh(square()));
        m_renderer->setTexels(store, 0);
        m_renderer->uploadTexels(store, kAll);
    }

    std::unique_ptr<Offscreen> m_offscreen;
    std::unique_ptr<Renderer> m_renderer;
};

QTEST_MAIN(TestOverlay)
#include "tst_overlay.moc"

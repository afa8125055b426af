// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/paint/dab_painter.h"
#include "render/paint_sheet.h"
#include "tests/render/offscreen.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

using Corners = std::array<glm::vec3, 3>;
constexpr FaceId kFace{0};
constexpr double kTolerance = 1.0 / 1024;

TexelStore coverageStore(Level level)
{
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    return TexelStore(1, format, level, std::vector<std::byte>(4));
}

/// What the texels' owner makes of the dabs: coverage as such, towards 1 from 0.
std::vector<float> committed(const Corners& corners,
                             Level level,
                             std::span<const Dab> dabs,
                             const PaintSheet::Strength& strength)
{
    const TriangleMesh mesh{{corners.begin(), corners.end()}, {{0, 1, 2}}, {}};
    TexelStore store = coverageStore(level);
    const std::array<float, 1> one{1};
    DabPainter painter(store.format(), one, strength.hardness, strength.flow, Threads{1});
    for (const Dab& dab : dabs) {
        painter.paint(dab, mesh, std::array{kFace}, store);
    }
    std::vector<float> coverage(level.texelCount());
    decode(TexelType::Float, std::span<const std::byte>(store.writable(kFace)), coverage);
    return coverage;
}

class TestPaintSheet : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Offscreen> m_screen;
    std::unique_ptr<Gl> m_gl;
    std::unique_ptr<PaintSheet> m_sheet;

    /// Dabs as the view sends them: several batches, the first of which is the square's first.
    std::vector<float> drawn(const Corners& corners,
                             const PaintSquare& square,
                             std::span<const Dab> dabs,
                             const PaintSheet::Strength& strength,
                             std::size_t atATime)
    {
        for (std::size_t done = 0; done < dabs.size(); done += atATime) {
            const auto some = dabs.subspan(done, std::min(atATime, dabs.size() - done));
            PaintBatch batch(some);
            const auto all = static_cast<std::uint32_t>((std::uint64_t{1} << some.size()) - 1);
            batch.add(corners, square, all, done == 0);
            m_sheet->draw(batch, strength);
        }
        return m_sheet->read(square);
    }

    static double
    distanceTo(const Corners& corners, Level level, std::uint32_t texel, const Dab& dab)
    {
        const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex{texel}));
        const glm::dvec3 a(corners[0]);
        const glm::dvec3 at =
            a + uv.x * (glm::dvec3(corners[1]) - a) + uv.y * (glm::dvec3(corners[2]) - a);
        return glm::length(at - glm::dvec3(dab.centre)) / dab.radius;
    }

    /// Whether a dab's rim runs through the centroid, where its falloff is 0 or, when hard, breaks
    /// off: there rounding decides.
    static bool
    isOnRim(const Corners& corners, Level level, std::uint32_t texel, std::span<const Dab> dabs)
    {
        return std::ranges::any_of(dabs, [&](const Dab& dab) {
            return std::abs(distanceTo(corners, level, texel, dab) - 1) < 2e-5;
        });
    }

    void expectSame(const Corners& corners,
                    const PaintSquare& square,
                    std::span<const Dab> dabs,
                    const PaintSheet::Strength& strength,
                    std::size_t atATime)
    {
        const std::vector<float> card = drawn(corners, square, dabs, strength, atATime);
        const std::vector<float> truth = committed(corners, square.level, dabs, strength);
        for (std::uint32_t k = 0; k < truth.size(); ++k) {
            const bool alike = std::abs(card[k] - truth[k]) <= kTolerance &&
                               (card[k] > 1e-5F || truth[k] <= 2e-5F) &&
                               (truth[k] > 1e-5F || card[k] <= 2e-5F);
            if (!alike && !isOnRim(corners, square.level, k, dabs)) {
                const std::string found =
                    "level " + std::to_string(square.level.log2()) + " texel " + std::to_string(k) +
                    ": card " + std::to_string(card[k]) + ", commit " + std::to_string(truth[k]);
                QFAIL(found.c_str());
            }
        }
    }

private slots:
    void initTestCase()
    {
        m_screen = std::make_unique<Offscreen>(64, 64);
        QVERIFY(m_screen->isValid());
        m_screen->bind();
        m_gl = currentGl();
        QVERIFY(m_gl);
        auto made = PaintSheet::create(*m_gl);
        QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
        m_sheet = std::move(*made);
        QVERIFY(m_sheet->reserve(2048));
    }

    void cleanupTestCase()
    {
        m_screen->bind();
        m_sheet.reset();
        m_gl.reset();
        m_screen.reset();
    }

    void bothHalvesOfEveryLevelAreCoveredOnceAtTheirCentroids()
    {
        // The fall of one wide soft dab gives each centroid a coverage of its own.
        const Corners corners{glm::vec3{0, 0, 0}, {1, 0, 0.25F}, {0.25F, 1, 0}};
        const std::array dabs{Dab{{0.1F, 0.2F, 0}, {}, 1.6F, 1}};
        for (int n = 0; n <= 10; ++n) {
            const Level level(n);
            const PaintSquare square{static_cast<std::uint16_t>(17 * n), 300, level};
            const std::vector<float> card = drawn(corners, square, dabs, {0, 1}, 32);
            for (std::uint32_t k = 0; k < card.size(); ++k) {
                const double s = distanceTo(corners, level, k, dabs[0]);
                QVERIFY2(std::abs(card[k] - (1 - s * s * (3 - 2 * s))) < 2e-6,
                         qPrintable(QStringLiteral("level %1 texel %2").arg(n).arg(k)));
            }
        }
    }

    /// Coverage as grey, 4 pixels a texel: a dab by the lower left corner and one on the third
    /// edge, which lies on the diagonal.
    void theTwoHalvesLookAsInTheGoldenPicture()
    {
        const Corners corners{glm::vec3{0, 0, 0}, {1, 0, 0}, {0.5F, 0.8660254F, 0}};
        const std::array dabs{Dab{{0.3F, 0.15F, 0}, {}, 0.4F, 1},
                              Dab{{0.8F, 0.4F, 0}, {}, 0.35F, 0.6F}};
        const Level level(4);
        const std::vector<float> card = drawn(corners, {40, 60, level}, dabs, {0.3F, 0.9F}, 2);
        QImage picture(16, 16, QImage::Format_Grayscale8);
        for (int k = 0; k < 256; ++k) {
            picture.scanLine(k / 16)[k % 16] =
                static_cast<uchar>(std::lround(255 * card[static_cast<std::size_t>(k)]));
        }
        const QImage golden = QImage(QStringLiteral(TRIXEL_TEST_DATA "/paint/two_halves.png"))
                                  .scaled(16, 16)
                                  .convertToFormat(QImage::Format_Grayscale8);
        if (golden.isNull()) {
            picture.scaled(64, 64).save("two_halves.png");
        }
        QCOMPARE(golden.size(), picture.size());
        for (int k = 0; k < 256; ++k) {
            const int found = picture.constScanLine(k / 16)[k % 16];
            QVERIFY(std::abs(found - golden.constScanLine(k / 16)[k % 16]) <= 1);
        }
    }

    void nothingBesideASquareIsTouched()
    {
        const Corners corners{glm::vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        const std::array wide{Dab{{0, 0, 0}, {}, 10, 1}};
        const PaintSquare around{0, 0, Level(6)};
        for (int n = 0; n <= 5; ++n) {
            drawn(corners, around, std::array{Dab{{50, 0, 0}, {}, 1, 1}}, {1, 1}, 1); // all zero
            const std::uint32_t side = 1U << n;
            drawn(corners, {13, 20, Level(n)}, wide, {1, 1}, 1);
            const std::vector<float> found = m_sheet->read(around);
            for (std::uint32_t k = 0; k < found.size(); ++k) {
                const std::uint32_t x = k % 64 - 13;
                const std::uint32_t y = k / 64 - 20;
                QCOMPARE(found[k], x < side && y < side ? 1.0F : 0.0F);
            }
        }
    }

    void coverageIsTheCommitsForRandomDabsOnRandomTriangles()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> place(-1, 1);
        std::uniform_real_distribution<float> part(0, 1);
        const auto point = [&] { return glm::vec3(place(random), place(random), place(random)); };
        for (int k = 0; k < 330; ++k) {
            const Level level(k % 11);
            if (level.log2() > 8 && k > 30) {
                continue; // a few of the large ones will do
            }
            const glm::vec3 away = k % 4 == 0 ? glm::vec3(100, -200, 50) : glm::vec3(0);
            const Corners corners{away + point(), away + point(), away + point()};
            std::vector<Dab> dabs;
            for (int d = 0; d < 1 + k % 40; ++d) {
                const float u = part(random);
                const float v = (1 - u) * part(random);
                const glm::vec3 on =
                    corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
                const float radius = std::exp2(-4 * part(random));
                dabs.push_back({on + 0.3F * radius * point(), {}, radius, part(random)});
            }
            const std::array hardnesses{0.0F, 0.3F, 0.8F, 0.97F, 1.0F};
            const PaintSheet::Strength strength{hardnesses[random() % 5],
                                                k % 3 == 0 ? 1.0F : 0.05F + 0.9F * part(random)};
            const PaintSquare square{static_cast<std::uint16_t>(random() % 2000), 100, level};
            expectSame(corners, square, dabs, strength, 1 + random() % 32);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }

    void sliversAndFacesWithoutAreaAreCoveredToo()
    {
        const glm::vec3 a(0.3F, -0.2F, 0.7F);
        const glm::vec3 b(-0.5F, 0.1F, 0.2F);
        const std::vector<Corners> faces{{a, a, b},
                                         {a, b, a},
                                         {b, a, a},
                                         {a, a, a},
                                         {a, 0.5F * (a + b), b},
                                         {a, b, b + glm::vec3(1e-6F, 0, 0)},
                                         {a, b, b + glm::vec3(1e-3F, 0, 0)}};
        for (const Corners& corners : faces) {
            for (int n = 0; n <= 9; n += 3) {
                for (const float radius : {0.05F, 0.3F, 5.0F}) {
                    const std::array dabs{Dab{a, {}, radius, 1},
                                          Dab{0.5F * (a + b), {}, radius, 0.5F}};
                    expectSame(corners, {40, 8, Level(n)}, dabs, {0.4F, 0.7F}, 1);
                    if (QTest::currentTestFailed()) {
                        return;
                    }
                }
            }
        }
    }

    void squaresKeepTheirCoverageWhenTheSheetGrows()
    {
        auto small = PaintSheet::create(*m_gl);
        QVERIFY(small.has_value());
        const Corners corners{glm::vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        const std::array dabs{Dab{{0.2F, 0.1F, 0}, {}, 1, 1}};
        PaintBatch batch(dabs);
        const PaintSquare square{700, 200, Level(8)};
        batch.add(corners, square, 1, true);
        (*small)->draw(batch, {0.2F, 0.5F});
        const std::vector<float> before = (*small)->read(square);
        QVERIFY((*small)->reserve(1500));
        QCOMPARE((*small)->read(square), before);
        QVERIFY(!(*small)->reserve((*small)->mostRows() + 1));
    }

    void whatWasBoundStaysBound()
    {
        m_screen->bind();
        m_gl->glViewport(1, 2, 30, 40);
        GLint before = 0;
        m_gl->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
        const Corners corners{glm::vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        drawn(corners, {0, 0, Level(3)}, std::array{Dab{{0, 0, 0}, {}, 1, 1}}, {1, 1}, 1);
        GLint after = 0;
        std::array<GLint, 4> viewport{};
        m_gl->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &after);
        m_gl->glGetIntegerv(GL_VIEWPORT, viewport.data());
        QCOMPARE(after, before);
        QCOMPARE(viewport, (std::array<GLint, 4>{1, 2, 30, 40}));
        QCOMPARE(m_gl->glGetError(), GLenum{GL_NO_ERROR});
    }

    void aCardThatCannotDrawNumbersIsRefusedInOneSentence()
    {
        const auto made = PaintSheet::create(*m_gl, GL_RGB9_E5); // can be read, not drawn into
        QVERIFY(!made.has_value());
        QVERIFY(QString::fromStdString(made.error().message).contains("cannot draw"));
        while (m_gl->glGetError() != GL_NO_ERROR) {
        }
    }
};

} // namespace

QTEST_MAIN(TestPaintSheet)
#include "tst_paint_sheet.moc"

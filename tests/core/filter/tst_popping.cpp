// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether answers jump while a footprint grows: on long ones, over many faces, and about vertices
// that no plane holds.
#include "core/filter/unfolding.h"
#include "core/study/test_scene.h"
#include "tests/core/filter/filter_footprints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace trixel::test {
namespace {

constexpr double kStep = 2e-4; // of the logarithm of the width
constexpr double kBound = 1e-3;

using Along = std::function<double(double)>;
/// \param begin  where the step of kStep begins over which the answer changes by `jump`
using Found = std::function<void(double begin, double jump)>;

/// Follows a value along a logarithm; a step over which it changes by more than kBound is halved
/// until it is kStep long.
class Sweep
{
public:
    Sweep(Along value, Found found)
        : m_value(std::move(value))
        , m_found(std::move(found))
    {
    }

    void over(double low, double high) const
    {
        constexpr double kLong = 256 * kStep;
        double before = m_value(low);
        for (double x = low; x < high; x += kLong) {
            const double next = m_value(x + kLong);
            narrow(x, kLong, before, next);
            before = next;
        }
    }

private:
    void narrow(double begin, double step, double from, double to) const
    {
        if (std::abs(to - from) <= kBound) {
            return;
        }
        if (step < 1.5 * kStep) {
            m_found(begin, std::abs(to - from));
            return;
        }
        const double middle = m_value(begin + step / 2);
        narrow(begin, step / 2, from, middle);
        narrow(begin + step / 2, step / 2, middle, to);
    }

    Along m_value;
    Found m_found;
};

/// A footprint on a closed mesh, to be scaled.
struct Place
{
    FaceId face{};
    glm::dvec2 uv{0};
    double edge = 1;
    double anisotropy = 1;
    double angle = 0;

    Place(const TestScene& scene, Dice& dice, bool isRound)
        : face(faceId(dice.below(scene.mesh.faceCount())))
        , uv(randomPoint(dice))
        , edge(std::exp2(scene.surface->log2Length(face, uv)))
        , anisotropy(isRound ? 1.0 : dice.logBetween(1, 8))
        , angle(dice.between(0, std::numbers::pi))
    {
    }

    /// \param across  in edges
    Footprint footprint(const TestScene& scene, double across) const
    {
        return planeFootprint(scene.surface->shape(face), across * edge, anisotropy, angle);
    }
};

double
answerAt(const FilterMethod& method, const TestScene& scene, const Place& place, double across)
{
    QueryArrays query;
    add(query, place.face, place.uv, place.footprint(scene, across));
    return double{filtered(method, scene.filter, query).values[0]};
}

/// The faces of a footprint, each with its corners in the plane.
std::map<FaceId, std::array<glm::dvec2, 3>>
placesOf(const TestScene& scene, const Place& place, double across)
{
    const Footprint footprint = place.footprint(scene, across);
    const QueryEllipse ellipse = queryEllipse(scene.filter,
                                              place.face,
                                              glm::vec2(place.uv),
                                              glm::vec2(footprint.w1),
                                              glm::vec2(footprint.w2));
    const EllipseFrame frame(ellipse);
    std::map<FaceId, std::array<glm::dvec2, 3>> places;
    Unfolding unfolding;
    for (const PlacedFace& laid : unfolding.unfold(*scene.surface, place.face, ellipse, frame, 6)) {
        for (std::size_t k = 0; k < 3; ++k) {
            places[laid.face][k] = frame.toPlane(laid.corners[k]);
        }
    }
    return places;
}

/// Whether a face lies elsewhere after a step of kStep.
bool aFaceMoves(const TestScene& scene, const Place& place, double logarithm)
{
    const auto before = placesOf(scene, place, std::exp(logarithm));
    const auto after = placesOf(scene, place, std::exp(logarithm + kStep));
    for (const auto& [face, corners] : before) {
        const auto found = after.find(face);
        for (std::size_t k = 0; k < 3 && found != after.end(); ++k) {
            if (glm::length(corners[k] - found->second[k]) > 1e-3 * place.edge) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

TEST(Popping, nothingPopsOnTheStoredFootprints)
{
    // Up to hundreds of faces long.
    const auto data = parseTestData(storedTestFiles());
    ASSERT_TRUE(data);
    NoProgress progress;
    for (const TestFaces faces : kTestFaces) {
        const auto scene = buildTestScene(
            *data, TestContent::HardEdged, TestPatch(15, faces), Threads{1}, progress);
        ASSERT_TRUE(scene);
        const FilterQueries all = scene->queries.queries();
        for (const MethodEntry& entry : filterMethods()) {
            const bool isSwitch = entry.name == "nearest-level"; // seen to pop
            if (entry.claims.levelContinuous != Claim::Yes && !isSwitch) {
                continue;
            }
            const auto method = makeMethod({std::string(entry.name), std::nullopt});
            int sweeps = 0;
            int pops = 0;
            for (std::size_t i = 7; i < all.size(); i += all.size() / 12, ++sweeps) {
                const auto value = [&](double logarithm) {
                    const auto factor = static_cast<float>(std::exp(logarithm));
                    QueryArrays one;
                    one.add(all.face[i],
                            {all.u[i], all.v[i]},
                            factor * glm::vec2(all.uw1[i], all.vw1[i]),
                            factor * glm::vec2(all.uw2[i], all.vw2[i]));
                    return double{filtered(*method, scene->scene, one).values[0]};
                };
                Sweep(value, [&](double at, double jump) {
                    ++pops;
                    EXPECT_TRUE(isSwitch) << entry.name << " pops by " << jump << " at query " << i
                                          << ", scaled by " << std::exp(at);
                }).over(std::log(0.5), 0);
            }
            EXPECT_GE(sweeps, 12);
            EXPECT_EQ(pops > 0, isSwitch) << entry.name;
        }
    }
}

TEST(Popping, aboutAVertexThatNoPlaneHoldsOnlyFacesThatChangeSidesPop)
{
    // Widths up to two edges on small closed meshes.
    for (const std::string_view name : {"exact", "ewa-blended:0.7"}) {
        const auto method = makeMethod(*parseMethod(name));
        int sweeps = 0;
        int pops = 0;
        double worst = 0;
        for (std::uint32_t valence = 3; valence <= 10; ++valence) {
            TriangleMesh mesh = closedIrregular(valence, valence);
            const auto levels = mixedLevels(mesh.faceCount(), 0, 6, valence);
            const TestScene scene = makeScene(std::move(mesh), levels, noiseContent(valence));
            Dice dice(100 + valence);
            for (int k = 0; k < 14; ++k, ++sweeps) {
                const Place place(scene, dice, k % 3 == 0);
                const auto value = [&](double logarithm) {
                    return answerAt(*method, scene, place, std::exp(logarithm));
                };
                Sweep(value, [&](double at, double jump) {
                    EXPECT_TRUE(aFaceMoves(scene, place, at))
                        << name << " pops by " << jump << ", valence " << valence << " place " << k;
                    ++pops;
                    worst = std::max(worst, jump);
                }).over(std::log(0.125 / place.anisotropy), std::log(2 / place.anisotropy));
            }
        }
        RecordProperty(std::string(name), std::to_string(pops) + " pops, " + std::to_string(worst));
        EXPECT_LE(pops, sweeps / 20) << name;
        EXPECT_LE(worst, 0.02) << name;
    }
}

} // namespace trixel::test

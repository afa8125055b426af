// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace trixel {
namespace {

/// Mixes all bits of a word into all others. Source: Steele, Lea, Flood, "Fast Splittable
/// Pseudorandom Number Generators", 2014.
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

/// The same for the same query, whatever was asked before.
std::uint64_t hashOf(const QueryEllipse& ellipse, FaceId face)
{
    std::uint64_t hash = mixed(indexOf(face));
    for (const double part : {ellipse.uv.x, ellipse.uv.y, ellipse.xx, ellipse.xy, ellipse.yy}) {
        hash = mixed(hash ^ std::bit_cast<std::uint64_t>(part));
    }
    return hash;
}

/// Points of the unit square that fill it evenly however many are taken, moved by a random vector
/// around it. In 32-bit fixed point, where going around is free. Source: Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", 2018: steps of 1/g and 1/g², g³ = g + 1.
class EvenPoints
{
public:
    explicit EvenPoints(std::uint64_t random)
        : m_x(static_cast<std::uint32_t>(random))
        , m_y(static_cast<std::uint32_t>(random >> 32U))
    {
    }

    /// Both coordinates inside (0, 1).
    glm::dvec2 next()
    {
        m_x += 3242174889U; // 2³² / 1.3247179572
        m_y += 2447445413U; // 2³² / 1.3247179572²
        constexpr double kUnit = 1.0 / 4294967296.0;
        return {(m_x + 0.5) * kUnit, (m_y + 0.5) * kUnit};
    }

private:
    std::uint32_t m_x, m_y;
};

/// A point of the standard normal distribution in the plane, from one of the unit square (Box and
/// Muller).
glm::dvec2 normal(glm::dvec2 square)
{
    const double radius = std::sqrt(-2 * std::log(square.x));
    const double angle = 2 * std::numbers::pi * square.y;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

QueryCost stochasticAnswer(int samples,
                           const FilterScene& scene,
                           const QueryEllipse& ellipse,
                           FaceId face,
                           int group,
                           GroupValue& value)
{
    // A look-up at a random point of a texel spreads it over the texel: s²/24 along any axis.
    const double texel = std::exp2(2 * ellipse.log2Texel) / 24;
    const auto sigma = [&](double whole) { return std::sqrt(whole * whole - texel); };
    const FaceShape& shape = scene.surface().shape(face);
    const glm::dvec2 major = shape.toUv(sigma(ellipse.majorSigma) * ellipse.majorAxis);
    const glm::dvec2 minor = shape.toUv(sigma(ellipse.minorSigma) * ellipse.minorAxis());
    EvenPoints points(hashOf(ellipse, face));
    TexelSum sum;
    for (int k = 0; k < samples; ++k) {
        const glm::dvec2 z = normal(points.next());
        const SurfaceWalk walk =
            walkStraight(scene.surface(), {face, ellipse.uv}, z.x * major + z.y * minor);
        sum.add(texelUnder(scene, walk.end, scene.level(walk.end.face), group), 1);
    }
    sum.store(value.data());
    return {static_cast<float>(scene.level(face).log2()), static_cast<std::uint32_t>(samples)};
}

} // namespace

MethodEntry stochasticMethod()
{
    MethodEntry entry;
    entry.name = "stochastic";
    entry.title = "Stochastic";
    entry.about = "The mean of base-level texels at points drawn from the Gaussian, the same for "
                  "the same query.";
    entry.claims = {.affineKept = Claim::InTheMean,
                    .rotationFree = Claim::InTheMean,
                    .edgeContinuous = Claim::InTheMean,
                    .footprintFree = Claim::InTheMean,
                    .levelContinuous = Claim::InTheMean};
    entry.parameter = MethodParameter{.name = "samples",
                                      .meaning = "Points drawn for a query.",
                                      .least = 1,
                                      .most = 4096,
                                      .standard = 16,
                                      .curve = {1, 4, 16, 64},
                                      .whole = true};
    entry.make = [](double parameter) {
        return perQueryMethod([samples = static_cast<int>(parameter)](auto&&... query) {
            return stochasticAnswer(samples, query...);
        });
    };
    return entry;
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/footprint_class.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel {

FootprintClass classOf(const QueryEllipse& ellipse)
{
    const double width = 2 * ellipse.minorSigma * std::exp2(-ellipse.log2Texel);
    const double anisotropy = ellipse.majorSigma / ellipse.minorSigma;
    const int across = width < kMediumWidth ? 0 : width < kLargeWidth ? 1 : 2;
    const int along = anisotropy < kElongated ? 0 : anisotropy < kGrazing ? 1 : 2;
    return static_cast<FootprintClass>(3 * across + along);
}

void classify(const FilterScene& scene,
              const FilterQueries& queries,
              std::span<std::uint8_t> classes)
{
    check(classes.size() == queries.size(), "room for every class");
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const FaceShape& shape = scene.surface().shape(queries.face[i]);
        const glm::vec2 e1(shape.e1);
        const glm::vec2 e2(shape.e2);
        const float u = queries.u[i];
        const float v = queries.v[i];
        const bool inside = u >= 0 && v >= 0 && u + v <= 1;
        const auto log2Texel = static_cast<float>(
            scene.log2TexelSize(queries.face[i], inside ? glm::dvec2(u, v) : glm::dvec2(1.0 / 3)));
        // In texels: axes a and b of the ellipse without its floor of a quarter.
        const float perTexel = 0.5F * std::exp2(-log2Texel);
        const glm::vec2 a = perTexel * (queries.uw1[i] * e1 + queries.vw1[i] * e2);
        const glm::vec2 b = perTexel * (queries.uw2[i] * e1 + queries.vw2[i] * e2);
        const float cross = a.x * b.y - a.y * b.x;
        const float sum = a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y;
        const float apart = sum * sum - 4 * cross * cross;
        const float larger = 0.5F * (sum + std::sqrt(std::max(apart, 0.0F)));
        const float major = larger + 0.25F;
        const float minor = (larger > 0 ? cross * cross / larger : 0.0F) + 0.25F;
        // Squares, so that no root is needed.
        const float width = 4 * minor;
        const auto square = [](double x) { return static_cast<float>(x * x); };
        const int across = width < square(kMediumWidth) ? 0 : width < square(kLargeWidth) ? 1 : 2;
        const int along = major < square(kElongated) * minor ? 0
                          : major < square(kGrazing) * minor ? 1
                                                             : 2;
        classes[i] = static_cast<std::uint8_t>(3 * across + along);
    }
}

std::string_view nameOf(FootprintClass footprintClass)
{
    constexpr std::array<std::string_view, kFootprintClasses> kNames = {"small round",
                                                                        "small elongated",
                                                                        "small grazing",
                                                                        "medium round",
                                                                        "medium elongated",
                                                                        "medium grazing",
                                                                        "large round",
                                                                        "large elongated",
                                                                        "large grazing"};
    return kNames[static_cast<std::size_t>(footprintClass)];
}

std::span<const FootprintClass> footprintClasses()
{
    static constexpr std::array<FootprintClass, kFootprintClasses> kAll = {
        FootprintClass::SmallRound,
        FootprintClass::SmallElongated,
        FootprintClass::SmallGrazing,
        FootprintClass::MediumRound,
        FootprintClass::MediumElongated,
        FootprintClass::MediumGrazing,
        FootprintClass::LargeRound,
        FootprintClass::LargeElongated,
        FootprintClass::LargeGrazing};
    return kAll;
}

} // namespace trixel

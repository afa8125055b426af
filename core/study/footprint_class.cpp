// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/footprint_class.h"

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

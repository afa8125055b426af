// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/query_ellipse.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace trixel {

/// Kinds of footprint that methods are judged by: how wide the ellipse is across (its minor axis
/// in base-level texels) and how long for its width (its anisotropy).
enum class FootprintClass {
    SmallRound, ///< under 2 texels across, anisotropy under 2
    SmallElongated,
    SmallGrazing,
    MediumRound, ///< 2 to 16 texels
    MediumElongated,
    MediumGrazing,
    LargeRound, ///< 16 texels and more
    LargeElongated,
    LargeGrazing
};

inline constexpr int kFootprintClasses = 9;

/// Widths and anisotropies at which a class ends.
inline constexpr double kMediumWidth = 2;
inline constexpr double kLargeWidth = 16;
inline constexpr double kElongated = 2;
inline constexpr double kGrazing = 8;

/// Width is 2 σ_minor over the texel's edge, anisotropy σ_major / σ_minor; the floor of the ellipse
/// counts in both.
FootprintClass classOf(const QueryEllipse& ellipse);

/// The classes of many queries, as numbers of the enumeration, in float: beside a boundary it may
/// be the class across it. What is not finite counts as large or grazing.
/// \param classes  one a query (checked)
void classify(const FilterScene& scene,
              const FilterQueries& queries,
              std::span<std::uint8_t> classes);

/// As people read it: "small round", "medium elongated", "large grazing".
std::string_view nameOf(FootprintClass footprintClass);

/// All nine, in the order of the enumeration.
std::span<const FootprintClass> footprintClasses();

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/atlas/hidden_colors.h"
#include "core/filter/filter_method.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <optional>

namespace trixel {

/// What samples of a hand-off atlas are. Where one channel is opacity, programs look up the colours
/// on their own, and those that nothing shows count beside those that something does:
/// `HiddenColors`.
class HandOffSampler
{
public:
    /// Refers to scene and method. \param scene  as `handOffPages` has it, of as many channels
    HandOffSampler(const FilterScene& scene, const FilterMethod& method, const TexelFormat& format);

    /// Values, not weighed, at places without a footprint. From any thread.
    ResultArrays sampled(const QueryArrays& places) const;

private:
    void takeColors(const QueryArrays& places, ResultArrays& samples) const;

    const FilterScene& m_scene;
    const FilterMethod& m_method;
    std::optional<std::size_t> m_opacity; ///< a channel
    std::optional<HiddenColors> m_hidden; ///< where there is one
};

} // namespace trixel

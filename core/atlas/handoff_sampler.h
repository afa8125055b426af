// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_method.h"
#include "core/texture/texel_format.h"

#include <memory>

namespace trixel {

/// What samples of a hand-off atlas are. Where one channel is opacity, programs look up the colours
/// on their own, and those that nothing shows count beside those that something does: they are what
/// is shown about them, the nearest of it.
class HandOffSampler
{
public:
    /// Refers to scene and method. \param scene  as `handOffPages` has it, of as many channels
    HandOffSampler(const FilterScene& scene, const FilterMethod& method, const TexelFormat& format);

    /// Values, not weighed, at places without a footprint. From any thread.
    ResultArrays sampled(const QueryArrays& places) const;

private:
    void spreadColors(const QueryArrays& places, ResultArrays& samples) const;

    const FilterScene& m_scene;
    const FilterMethod& m_method;
    TexelFormat m_format;
    std::unique_ptr<const FilterMethod> m_average; ///< of what lies about a place
};

} // namespace trixel

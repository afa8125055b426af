// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/texture/float_mips.h"

#include <span>
#include <vector>

namespace trixel {

/// Least and greatest base-level texel of every channel. Values that are not finite do not count.
class ValueBounds
{
public:
    ValueBounds() = default;
    static ValueBounds of(const FloatMips& mips, Threads threads);

    /// The texels of a face as well.
    void add(const FloatMips& mips, FaceId face);

    /// The largest span of a channel: what jumps and errors are told in fractions of. 0 where all
    /// texels are alike.
    double range() const;

private:
    struct Span
    {
        float low, high;
    };
    void add(std::span<const Span> others);

    std::vector<Span> m_channels; // a whole number of groups; those never seen are inside out
};

/// The range of all base-level texels.
double valueRange(const FloatMips& mips, Threads threads);

} // namespace trixel

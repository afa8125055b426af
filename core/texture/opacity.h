// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels as means are made of them where one channel is opacity (`TexelFormat::alpha`): values
// count as far as they are opaque, so that what is not seen lends no colour. *Weighed* texels are
// floats, every value multiplied with the opacity, which itself is in [0,1].
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_store.h"

#include <cstddef>
#include <span>

namespace trixel {

/// The opacity that a stored number stands for: within [0,1], NaN is none. A plain choice between
/// values, so that loops over it run several at a time.
inline float opacityOf(float stored)
{
    const float positive = stored > 0.0F ? stored : 0.0F; // false for NaN
    return positive < 1.0F ? positive : 1.0F;
}

/// Values of a weighed texel, or of a mean of such, as they were before; 0 where nothing is opaque.
/// \param opacity  the channel that says so
inline void unweigh(std::span<float> texel, std::size_t opacity)
{
    const float whole = texel[opacity];
    for (std::size_t c = 0; c < texel.size(); ++c) {
        texel[c] = c == opacity ? whole : whole > 0.0F ? texel[c] / whole : 0.0F;
    }
}

/// The format of weighed texels.
TexelFormat weighedFormat(const TexelFormat& format);

/// \param format  of the face; one of its channels is opacity (checked)
FaceTexels weighed(const FaceTexels& face, const TexelFormat& format);
/// Takes it back. \param format  what the texels are to be of (an opacity: checked)
FaceTexels unweighed(const FaceTexels& face, const TexelFormat& format);

/// All faces weighed; the store itself where no channel is opacity. Fails when cancelled and when
/// a face cannot be read.
Result<TexelStore> weighed(const TexelStore& store, Threads threads, Progress& progress);

} // namespace trixel

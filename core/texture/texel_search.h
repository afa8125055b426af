// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_store.h"

#include <functional>
#include <optional>
#include <span>

namespace trixel {

/// Texel number `index` of a face.
struct TexelSpot
{
    FaceId face{};
    TexelIndex index{};

    bool operator==(const TexelSpot&) const = default;
};

/// The number of the first of some texels that is looked for, or nothing. \param values  of one
/// texel after another, one a channel each
using TexelTest = std::function<std::optional<std::size_t>(std::span<const float> values)>;

/// The next texel that is looked for, face after face and in storage order within each; after the
/// last comes the first. A constant face is one texel. Fails only when cancelled.
/// \param after  a texel of the store (checked) that is the last to be looked at; nothing: the
///               search begins with the first texel of all
/// \return       nothing where there is no such texel
Result<std::optional<TexelSpot>> nextTexel(const TexelStore& store,
                                           std::optional<TexelSpot> after,
                                           const TexelTest& test,
                                           Progress& progress);

} // namespace trixel

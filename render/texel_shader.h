// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/look.h"

#include <cstddef>
#include <vector>

namespace trixel::render {

/// `shade` for many texels of one format under one look: what can be known beforehand is computed
/// once.
class TexelShader
{
public:
    TexelShader(const TexelFormat& format, const Look& look);

    /// \param values  one a channel (checked)
    Rgba operator()(std::span<const float> values) const;

    /// Colours of texels as they are stored.
    /// \param texels  whole texels of the format
    /// \param colors  one a texel (checked)
    void operator()(std::span<const std::byte> texels, std::span<Rgba> colors) const;

    const LookRule& rule() const { return m_rule; }

private:
    void bytes(std::span<const std::byte> texels, std::span<Rgba> colors) const;
    void decoded(std::span<const std::byte> texels, std::span<Rgba> colors) const;

    TexelFormat m_format;
    LookRule m_rule;
    std::vector<Rgba> m_numbers;        ///< of each byte; only where that is all that counts
    std::vector<std::uint8_t> m_levels; ///< of each byte; only for colours without marks
};

} // namespace trixel::render

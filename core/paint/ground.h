// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace trixel {

/// What strokes are painted on: texels as they are, which Erase moves towards a fill, or those of a
/// layer, where paint covers what lies below and Erase uncovers it.
class Ground
{
public:
    /// A base, or texels without layers; meant to be made of a fill wherever one is at hand.
    /// \param fill  the bytes of one texel that Erase moves towards
    Ground(std::vector<std::byte> fill = {})
        : m_fill(std::move(fill))
    {
    }

    /// Texels of `layerFormat`: the last channel is their coverage.
    static Ground layer()
    {
        Ground ground;
        ground.m_isLayer = true;
        return ground;
    }

    bool isLayer() const { return m_isLayer; }
    /// Nothing on a layer.
    std::span<const std::byte> fill() const { return m_fill; }

private:
    std::vector<std::byte> m_fill;
    bool m_isLayer = false;
};

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/fit/fit_equations.h"
#include "core/texture/texel_store.h"

#include <span>
#include <vector>

namespace trixel {

/// Four channels, or those there are, of every texel that the equations know.
class FitTexelGroup
{
public:
    /// \param store  of float texels; both must outlive it
    /// \param group  0 for the first four channels, 1 for the next
    FitTexelGroup(const FitEquations& equations, TexelStore& store, int group);

    std::vector<Quad> read() const;
    /// \param isMoved  the faces to write; all others stay as they are
    void write(std::span<const Quad> texels, const FaceMap<char>& isMoved);
    std::size_t channels() const { return m_count; }

private:
    const FitEquations& m_equations;
    TexelStore& m_store;
    std::size_t m_channels;
    std::size_t m_from;
    std::size_t m_count;
};

} // namespace trixel

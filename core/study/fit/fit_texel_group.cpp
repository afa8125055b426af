// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_texel_group.h"

#include <algorithm>
#include <cstring>

namespace trixel {

FitTexelGroup::FitTexelGroup(const FitEquations& equations, TexelStore& store, int group)
    : m_equations(equations)
    , m_store(store)
    , m_channels(static_cast<std::size_t>(store.format().channels))
    , m_from(static_cast<std::size_t>(group) * 4)
    , m_count(std::min<std::size_t>(4, m_channels - m_from))
{
}

std::vector<Quad> FitTexelGroup::read() const
{
    std::vector<Quad> texels(m_equations.texelCount(), Quad(0));
    for (const FaceId face : m_equations.faces()) {
        const FaceTexels& from = m_store.face(face);
        Quad* to = texels.data() + *m_equations.firstTexel(face);
        for (std::uint32_t t = 0; t < from.level().texelCount(); ++t) {
            std::memcpy(
                to + t, from.texel(t).data() + m_from * sizeof(float), m_count * sizeof(float));
        }
    }
    return texels;
}

void FitTexelGroup::write(std::span<const Quad> texels, const FaceMap<char>& isMoved)
{
    for (const FaceId face : m_equations.faces()) {
        if (isMoved[face] == 0) {
            continue;
        }
        const auto to = m_store.writable(face);
        const Quad* from = texels.data() + *m_equations.firstTexel(face);
        for (std::size_t t = 0; t < m_store.face(face).level().texelCount(); ++t) {
            std::memcpy(to.data() + (t * m_channels + m_from) * sizeof(float),
                        from + t,
                        m_count * sizeof(float));
        }
    }
}

} // namespace trixel

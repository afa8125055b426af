// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_scene.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace trixel {

/// Colours of what nothing shows: between mesh vertices, each the mean of what the faces about it
/// show or, where they show nothing, of the vertices next to it that have one, from ring to ring.
/// Zero where nothing that is connected shows anything. Finer means beside paint were measured to
/// change nothing that is seen: filters give every sample that they reach its own colour.
class HiddenColors
{
public:
    /// Refers to the scene. \param scene  weighed by that channel (opacity.h)
    HiddenColors(const FilterScene& scene, std::size_t opacity);

    /// \param value  of all channels (checked); the opacity is left 0
    void at(FaceId face, glm::vec2 uv, std::span<float> value) const;

private:
    enum class State : std::uint8_t { Unknown, Next, Known };

    std::span<float> color(RingId ring);
    std::span<const float> color(RingId ring) const;
    bool takeShown(RingId ring);
    std::vector<RingId> nextTo(std::span<const RingId> rings);
    void takeMean(RingId ring);

    const FilterScene& m_scene;
    std::size_t m_opacity;
    std::vector<float> m_colors; ///< of each ring
    std::vector<State> m_states; ///< of each ring
};

} // namespace trixel

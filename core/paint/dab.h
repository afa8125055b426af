// SPDX-License-Identifier: GPL-3.0-or-later
//
// One touch of the brush, and the one rule for what it adds to a texel.
#pragma once

#include <glm/vec3.hpp>

namespace trixel {

/// A sphere around a point of the surface. What it does to a texel depends on where the texel's
/// centroid lies in the world and on nothing else, so faces of any level meet without a join.
struct Dab
{
    glm::vec3 centre{0};
    /// Unit normal of the surface at the centre, turned where the face is wound against its
    /// neighbours; zero where the face has none: then faces of every direction are painted.
    glm::vec3 normal{0};
    float radius = 0; ///< world units; > 0
    float cap = 1;    ///< [0,1]: coverage that this dab moves towards, the opacity by pressure
};

/// How strength falls from the centre of a dab to its rim: full within `hardness` of the radius,
/// then 1 - s²(3 - 2s), which leaves and arrives level.
class Falloff
{
public:
    /// \param hardness  [0,1]
    explicit Falloff(float hardness)
        : m_hardness(hardness)
        // At hardness 1 the fall happens within one float: full inside, nothing outside.
        , m_scale(hardness < 1.0F ? 1.0F / (1.0F - hardness) : 1e30F)
    {
    }

    /// \param distance  from the centre in radii, >= 0
    /// \return          [0,1]; 0 from the rim on
    float at(float distance) const
    {
        // Plain choices between values, here and below: loops over them run several at a time.
        const float fall = (distance - m_hardness) * m_scale;
        const float begun = fall > 0.0F ? fall : 0.0F;
        const float s = begun < 1.0F ? begun : 1.0F;
        return 1.0F - s * s * (3.0F - 2.0F * s);
    }

private:
    float m_hardness;
    float m_scale;
};

/// Coverage after a dab: a step of `strength` (flow by falloff) from the coverage before towards
/// the dab's cap. Coverage above the cap (from a dab of more pressure) stays, so a stroke covers
/// each texel at most by the largest cap that touched it, however often it crosses itself; with
/// one cap throughout this is cap (1 - Π(1 - strength)).
inline float covered(float before, float cap, float strength)
{
    const float moved = before + (cap - before) * strength;
    const float capped = moved < cap ? moved : cap;
    return capped > before ? capped : before;
}

} // namespace trixel

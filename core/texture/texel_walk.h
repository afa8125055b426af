// SPDX-License-Identifier: GPL-3.0-or-later
//
// From texel to texel over a surface, as one walks: across mesh edges, levels and orientation.
#pragma once

#include "core/lattice/texel_edges.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_store.h"

#include <optional>
#include <vector>

namespace trixel {

/// A texel of a surface.
struct TexelPlace
{
    FaceId face{};
    TexelCoord texel;

    bool operator==(const TexelPlace&) const = default;
};

/// What a walk goes over; refers to both.
struct WalkedSurface
{
    const Adjacency& adjacency;
    const TexelStore& texels;
    int levelsDropped = 0; ///< faces are walked so many levels coarser than they are, not below 0

    Level level(FaceId face) const { return texels.face(face).level().coarser(levelsDropped); }
};

/// Where a walk stands and how it came there. A texel has three edges: seen from the one that it
/// was entered by, one lies to the right and one to the left.
class TexelWalk
{
public:
    /// Begins as if the texel had been entered by that edge.
    explicit TexelWalk(const TexelPlace& start, LocalEdge entered = LocalEdge::E0)
        : m_here{start, entered, Turn::Left}
    {
    }

    const TexelPlace& place() const { return m_here.place; }
    /// The edge that the texel was entered by.
    LocalEdge entered() const { return m_here.entered; }

    /// One texel on; the place is a texel of the surface (checked). False at a border, where the
    /// walk stays as it is.
    ///
    /// Right and left turn about a corner of the texel: again and again, they go round it, also
    /// where it is a vertex of the mesh, of any valence and whatever the levels of its faces:
    /// of several finer texels across a mesh edge the one at that corner is entered. Ahead keeps
    /// the direction: it turns right and left by turns, and enters the middle one.
    bool right(const WalkedSurface& surface);
    bool left(const WalkedSurface& surface);
    bool ahead(const WalkedSurface& surface);
    /// Back on one's own steps; where there are none, out by the edge that was entered by.
    bool back(const WalkedSurface& surface);

private:
    enum class Turn { Right, Left };
    enum class Landing { AtStart, Middle, AtEnd }; ///< of the edge that is left by
    struct Step
    {
        TexelPlace place;
        LocalEdge entered{};
        Turn turn{}; ///< taken to come here
    };

    std::optional<Step>
    across(const WalkedSurface& surface, LocalEdge edge, Landing landing, Turn turn) const;
    bool turnTo(const WalkedSurface& surface, Turn turn, Landing landing);

    Step m_here;
    std::vector<Step> m_steps; ///< before this one
};

} // namespace trixel

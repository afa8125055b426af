// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/chain_cache.h"
#include "core/texture/vertex_averages.h"
#include "core/texture/vertex_block.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace trixel {

/// Whether a face and all that share a vertex with it are one constant.
bool isConstantAround(const TexelStore& store, const VertexRings& rings, FaceId face);

/// The vertices of single faces, made when asked for: what `ConformingPyramid` holds of all faces
/// at once, to the bit before they are stored. Each vertex is stored as four channels of the
/// store's own type (4, 8 or 16 bytes). What rule 3 derives is derived from values as they are
/// stored, so that what two faces show along their edge differs by half a step of that type at
/// most.
class FaceVertices
{
public:
    /// Refers to all three, which must stay as they are meanwhile.
    FaceVertices(const FaceMips& mips, const Adjacency& adjacency, const VertexRings& rings);

    /// The face's own level; its block may be asked for up to there.
    Level level(FaceId face) const { return m_mips.level(face); }

    /// Whether the face and all about it are one constant, so that one vertex stands for all.
    bool isConstant(FaceId face) const;

    /// Appends the stored values of the first vertices of a face, all levels up to `most`.
    /// \param most  not above level(face) (checked)
    void appendBlock(FaceId face, Level most, std::vector<std::byte>& bytes) const;

    /// Appends those of a run, which must lie within the face's block (checked).
    void appendRun(const VertexRun& run, std::vector<std::byte>& bytes) const;

    /// Appends the one vertex that stands for a constant face.
    void appendConstant(FaceId face, std::vector<std::byte>& bytes) const;

    /// The same as floats, as stored: for tests and figures.
    std::vector<float> values(const VertexRun& run) const;

    std::size_t vertexBytes() const;

private:
    /// What every vertex of a face asks for.
    struct Face
    {
        FaceId id{};
        std::array<Level, 3> edgeBases;
        std::array<Level, 3> ringBases;
    };

    Face faceOf(FaceId face) const;
    void fillRow(const Face& face,
                 Level level,
                 std::uint32_t j,
                 std::uint32_t i0,
                 std::uint32_t i1,
                 float* values) const;
    void
    fillEdge(const Face& face, LocalEdge edge, Level level, std::uint32_t k, float* value) const;
    void round(float* value) const;

    const FaceMips& m_mips;
    const VertexRings& m_rings;
    BasicVertexAverages<FaceMips> m_averages;
    TexelType m_type;
};

} // namespace trixel

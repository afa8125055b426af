// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_vertices.h"

#include "core/base/check.h"

#include <algorithm>
#include <array>

namespace trixel {

bool isConstantAround(const TexelStore& store, const VertexRings& rings, FaceId face)
{
    const FaceTexels& own = store.face(face);
    if (!own.isConstant()) {
        return false;
    }
    const auto isAlike = [&](const Corner& corner) {
        const FaceTexels& other = store.face(corner.face);
        return other.isConstant() &&
               (other.sharesBytesWith(own) || std::ranges::equal(other.texel(0), own.texel(0)));
    };
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
        if (!std::ranges::all_of(rings.corners(rings.ring({face, corner})), isAlike)) {
            return false;
        }
    }
    return true;
}

FaceVertices::FaceVertices(const FaceMips& mips,
                           const Adjacency& adjacency,
                           const VertexRings& rings)
    : m_mips(mips)
    , m_rings(rings)
    , m_averages(mips, adjacency, rings, 0)
    , m_type(mips.store().format().type)
{
}

std::size_t FaceVertices::vertexBytes() const
{
    return kGroupChannels * byteSize(m_type);
}

bool FaceVertices::isConstant(FaceId face) const
{
    return isConstantAround(m_mips.store(), m_rings, face);
}

FaceVertices::Face FaceVertices::faceOf(FaceId face) const
{
    Face about{face, {}, {}};
    for (std::uint8_t k = 0; k < 3; ++k) {
        about.edgeBases[k] = m_averages.edgeBase(face, kLocalEdges[k]);
        about.ringBases[k] = m_averages.ringBase(face, k);
    }
    return about;
}

void FaceVertices::appendBlock(FaceId face, Level most, std::vector<std::byte>& bytes) const
{
    appendRun({face, 0, vertexBlockSize(most)}, bytes);
}

void FaceVertices::appendRun(const VertexRun& run, std::vector<std::byte>& bytes) const
{
    const std::vector<float> stored = values(run);
    const std::size_t before = bytes.size();
    bytes.resize(before + stored.size() * byteSize(m_type));
    encode(m_type, stored, std::span(bytes).subspan(before));
}

void FaceVertices::appendConstant(FaceId face, std::vector<std::byte>& bytes) const
{
    const float* value = m_mips.texels(face, Level(0)).values;
    const std::size_t before = bytes.size();
    bytes.resize(before + vertexBytes());
    encode(m_type, {value, kGroupChannels}, std::span(bytes).subspan(before));
}

std::vector<float> FaceVertices::values(const VertexRun& run) const
{
    check(run.first + run.count <= vertexBlockSize(level(run.face)), "vertices that the face has");
    std::vector<float> values(std::size_t{run.count} * kGroupChannels);
    const Face face = faceOf(run.face);
    float* value = values.data();
    const std::uint32_t end = run.first + run.count;
    std::uint32_t at = run.first;
    while (at < end) {
        // To the end of the row, or of the run.
        const Level level = vertexBlockLevel(at);
        const std::uint32_t r = level.resolution();
        const std::uint32_t begin = vertexBlockBegin(level);
        const std::uint32_t j = latticeRow(level, at - begin);
        const auto rowBegin = static_cast<std::uint32_t>(latticeVertex(level, 0, j)) + begin;
        const std::uint32_t i0 = at - rowBegin;
        const std::uint32_t i1 = std::min(r - j, end - 1 - rowBegin);
        fillRow(face, level, j, i0, i1, value);
        value += std::size_t{i1 - i0 + 1} * kGroupChannels;
        at += i1 - i0 + 1;
    }
    return values;
}

/// Vertices (i0…i1, j), wherever in the face or on its rim they lie.
void FaceVertices::fillRow(const Face& face,
                           Level level,
                           std::uint32_t j,
                           std::uint32_t i0,
                           std::uint32_t i1,
                           float* values) const
{
    const std::uint32_t r = level.resolution();
    const auto at = [&](std::uint32_t i) { return values + std::size_t{i - i0} * kGroupChannels; };
    if (j == 0) {
        for (std::uint32_t i = i0; i <= i1; ++i) {
            fillEdge(face, LocalEdge::E0, level, i, at(i));
        }
        return;
    }
    const std::uint32_t last = r - j; // on the hypotenuse
    if (i0 == 0) {
        fillEdge(face, LocalEdge::E2, level, r - j, at(0));
    }
    if (i1 == last && (i0 > 0 || last > 0)) {
        fillEdge(face, LocalEdge::E1, level, j, at(last));
    }
    const std::uint32_t first = std::max(i0, 1U);
    const std::uint32_t end = std::min(i1 + 1, last);
    if (first < end) {
        m_averages.insideRow(face.id, level, j, first, end - 1, at(first));
        for (std::uint32_t i = first; i < end; ++i) {
            round(at(i));
        }
    }
}

/// Vertex k of an edge, its ends among them.
void FaceVertices::fillEdge(
    const Face& face, LocalEdge edge, Level level, std::uint32_t k, float* value) const
{
    const std::uint32_t r = level.resolution();
    if (k == 0 || k == r) {
        const auto corner = static_cast<std::uint8_t>(k == 0 ? edge : nextEdge(edge));
        m_averages.cornerValue(face.id, corner, face.ringBases[corner], level, value);
        round(value);
        return;
    }
    const Level base = face.edgeBases[indexOf(edge)];
    if (level <= base) {
        m_averages.edgeValue(face.id, edge, level, k, value);
        round(value);
        return;
    }
    const int steps = level.log2() - base.log2();
    const std::uint32_t span = 1U << steps;
    std::array<float, kGroupChannels> from{};
    fillEdge(face, edge, base, k >> steps, from.data());
    const double t = static_cast<double>(k & (span - 1)) / span;
    if (t == 0) {
        std::ranges::copy(from, value);
        return;
    }
    std::array<float, kGroupChannels> to{};
    fillEdge(face, edge, base, (k >> steps) + 1, to.data());
    BasicVertexAverages<FaceMips>::between(from.data(), to.data(), t, value);
    round(value);
}

/// To what the type can store.
void FaceVertices::round(float* value) const
{
    if (m_type == TexelType::Float) {
        return;
    }
    std::array<std::byte, kGroupChannels * sizeof(float)> stored{};
    const std::span bytes = std::span(stored).first(vertexBytes());
    encode(m_type, {value, kGroupChannels}, bytes);
    decode(m_type, bytes, {value, kGroupChannels});
}

} // namespace trixel

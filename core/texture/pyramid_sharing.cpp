// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/pyramid_sharing.h"

#include <algorithm>
#include <cstring>
#include <unordered_map>

namespace trixel {
namespace {

constexpr std::uint32_t kNothing = 3; // where an edge or corner number would stand

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value)
{
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 29U);
}

} // namespace

PyramidSharing::PyramidSharing(const FloatMips& mips,
                               const Adjacency& adjacency,
                               const VertexRings& rings)
    : m_mips(mips)
    , m_adjacency(adjacency)
    , m_rings(rings)
{
}

template <class Work>
bool PyramidSharing::eachSource(FaceId face, const Work& work) const
{
    for (const LocalEdge edge : kLocalEdges) {
        const auto across = m_adjacency.neighbour(face, edge);
        const bool more = across ? work(across->face, static_cast<std::uint32_t>(across->edge))
                                 : work(face, kNothing);
        if (!more) {
            return false;
        }
    }
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
        const RingId ring = m_rings.ring({face, corner});
        const auto corners = m_rings.corners(ring);
        // A closed ring begins anywhere: here with the face itself.
        const auto own = std::ranges::find(corners, Corner{face, corner});
        const auto first =
            m_rings.isClosed(ring) ? static_cast<std::size_t>(own - corners.begin()) : 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Corner& other = corners[(first + k) % corners.size()];
            if (!work(other.face, other.index)) {
                return false;
            }
        }
        if (!work(face, kNothing)) { // where this ring ends
            return false;
        }
    }
    return true;
}

bool PyramidSharing::isConstant(FaceId face) const
{
    return m_mips.isConstant(face) && eachSource(face, [&](FaceId other, std::uint32_t) {
               if (m_mips.share(face, other)) {
                   return true;
               }
               if (!m_mips.isConstant(other)) {
                   return false;
               }
               for (int group = 0; group < m_mips.groups(); ++group) {
                   if (std::memcmp(m_mips.average(face, group),
                                   m_mips.average(other, group),
                                   kGroupChannels * sizeof(float)) != 0) {
                       return false;
                   }
               }
               return true;
           });
}

std::uint64_t PyramidSharing::signature(FaceId face) const
{
    std::uint64_t hash = mixed(0, m_mips.valuesOf(face));
    eachSource(face, [&](FaceId other, std::uint32_t place) {
        hash = mixed(hash, std::uint64_t{m_mips.valuesOf(other)} << 2U | place);
        return true;
    });
    return hash;
}

bool PyramidSharing::isAlike(FaceId a, FaceId b) const
{
    std::vector<std::uint64_t> sources;
    const auto take = [&](FaceId other, std::uint32_t place) {
        sources.push_back(std::uint64_t{m_mips.valuesOf(other)} << 2U | place);
        return true;
    };
    eachSource(a, take);
    const std::vector<std::uint64_t> ofA = std::exchange(sources, {});
    eachSource(b, take);
    return m_mips.share(a, b) && ofA == sources;
}

std::vector<FaceId> PyramidSharing::firstAlike(Threads threads) const
{
    const std::size_t faces = m_mips.faceCount();
    // A face whose values nobody shares is like no other.
    constexpr std::size_t kGrain = 1024;
    std::vector<std::uint64_t> signatures(faces);
    std::vector<char> constant(faces);
    parallelFor(faces, kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            constant[f] = isConstant(faceId(f)) ? 1 : 0;
            const bool shared = constant[f] == 0 && m_mips.sharers(faceId(f)) > 1;
            signatures[f] = shared ? signature(faceId(f)) : m_mips.valuesOf(faceId(f));
        }
    });
    std::vector<FaceId> first(faces);
    std::unordered_multimap<std::uint64_t, FaceId> known;
    FaceId last{}; // neighbours in the numbering are often alike
    for (std::size_t f = 0; f < faces; ++f) {
        const FaceId face = faceId(f);
        first[f] = face;
        const auto alike = [&](FaceId other) {
            return constant[f] == constant[indexOf(other)] &&
                   signatures[f] == signatures[indexOf(other)] &&
                   (constant[f] != 0 ? m_mips.share(face, other) : isAlike(face, other));
        };
        if (constant[f] == 0 && m_mips.sharers(face) == 1) {
            continue;
        }
        if (f > 0 && alike(last)) {
            first[f] = last;
            continue;
        }
        const auto [from, to] = known.equal_range(signatures[f]);
        const auto found =
            std::find_if(from, to, [&](const auto& entry) { return alike(entry.second); });
        if (found != to) {
            first[f] = found->second;
        } else {
            known.emplace(signatures[f], face);
        }
        last = first[f];
    }
    return first;
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces are first given colours by what lies around them, farther and farther out, so that faces of
// different colours cannot be counterparts. A face of the rarest colour of each connected part is
// then tried on every face of its colour in all six ways; from it the match follows across edges.
#include "core/mesh/face_match.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace trixel {

namespace {

constexpr int kMostRounds = 64;
/// Faces that may be visited in all tries, in parts of the faces there are: a mesh so regular that
/// more are needed is as good as ambiguous.
constexpr std::uint64_t kMostVisits = 64;
constexpr std::uint64_t kLeastVisits = 1'000'000;
/// How many tries go by between two looks at whether to go on.
constexpr std::uint64_t kVisitsAtOnce = 1U << 16U;

constexpr std::uint64_t mixed(std::uint64_t value)
{
    value = (value ^ (value >> 31U)) * 0x9E3779B97F4A7C15U;
    return value ^ (value >> 29U);
}

using Colors = std::vector<std::uint64_t>;

/// One ring farther out.
Colors recolored(const Adjacency& mesh, const Colors& colors)
{
    Colors next(colors.size());
    for (std::size_t k = 0; k < colors.size(); ++k) {
        std::array<std::uint64_t, 3> around{};
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = mesh.neighbour(faceId(k), edge);
            around[indexOf(edge)] = across ? mixed(colors[indexOf(across->face)] + 1) : 0;
        }
        std::ranges::sort(around);
        std::uint64_t color = mixed(colors[k]);
        for (const std::uint64_t one : around) {
            color = mixed(color ^ one) + 0x632BE59BD9B4E019U;
        }
        next[k] = color;
    }
    return next;
}

Colors sortedColors(Colors colors)
{
    std::ranges::sort(colors);
    return colors;
}

std::size_t distinct(const Colors& sorted)
{
    std::size_t count = sorted.empty() ? 0 : 1;
    for (std::size_t k = 1; k < sorted.size(); ++k) {
        count += sorted[k] != sorted[k - 1] ? 1 : 0;
    }
    return count;
}

/// The edge there that an edge here lies on.
LocalEdge edgeThere(LocalEdge here, const CornerOrder& order)
{
    const std::size_t e = indexOf(here);
    return static_cast<LocalEdge>(turnsOver(order) ? order[(e + 1) % 3] : order[e]);
}

/// The order of a face, from the edge it was reached across, here and there.
/// \param over  whether the face before it is turned over
CornerOrder orderAcross(LocalEdge neighbourEdge, LocalEdge otherNeighbourEdge, bool over)
{
    // An edge's start is the end of the same edge as the neighbour runs along it.
    const std::size_t here = indexOf(neighbourEdge);
    const std::size_t there = indexOf(otherNeighbourEdge);
    const auto corner = [](std::size_t k) { return static_cast<std::uint8_t>(k % 3); };
    CornerOrder across{};
    across[here] = corner(over ? there + 1 : there);
    across[(here + 1) % 3] = corner(over ? there : there + 1);
    across[(here + 2) % 3] = corner(there + 2);
    return across;
}

class NeighbourMatcher
{
public:
    NeighbourMatcher(const Adjacency& mesh, const Adjacency& other, Progress& progress)
        : m_mesh(mesh)
        , m_other(other)
        , m_progress(progress)
        , m_match(mesh.faceCount())
        , m_isMatched(mesh.faceCount())
        , m_isUsed(mesh.faceCount())
        , m_mostVisits(std::max(kLeastVisits, kMostVisits * mesh.faceCount()))
    {
    }

    Result<FaceMatch> match()
    {
        if (Status colored = color(); !colored) {
            return tl::unexpected(colored.error());
        }
        for (const std::uint32_t seed : seeds()) {
            if (!m_isMatched[seed]) {
                if (Status placed = place(seed); !placed) {
                    return tl::unexpected(placed.error());
                }
            }
        }
        return std::move(m_match);
    }

private:
    Status color()
    {
        m_colors.assign(m_mesh.faceCount(), 1);
        m_otherColors = m_colors;
        std::size_t count = 1;
        for (int round = 0; round < kMostRounds; ++round) {
            if (!m_progress.report(0.5 * round / kMostRounds)) {
                return cancelled();
            }
            m_colors = recolored(m_mesh, m_colors);
            m_otherColors = recolored(m_other, m_otherColors);
            const Colors here = sortedColors(m_colors);
            if (here != sortedColors(m_otherColors)) {
                return contentsError("its faces do not neighbour each other as the mesh's do");
            }
            if (std::exchange(count, distinct(here)) == distinct(here)) {
                break; // more rounds tell no more faces apart
            }
        }
        for (std::uint32_t k = 0; k < m_otherColors.size(); ++k) {
            m_ofColor[m_otherColors[k]].push_back(k);
        }
        return {};
    }

    /// All faces, those of rare colours first.
    std::vector<std::uint32_t> seeds() const
    {
        std::vector<std::pair<std::size_t, std::uint32_t>> byRarity(m_colors.size());
        for (std::uint32_t k = 0; k < m_colors.size(); ++k) {
            byRarity[k] = {m_ofColor.at(m_colors[k]).size(), k};
        }
        std::ranges::sort(byRarity);
        std::vector<std::uint32_t> faces(byRarity.size());
        std::ranges::transform(byRarity, faces.begin(), [](const auto& one) { return one.second; });
        return faces;
    }

    /// Finds the one way in which the part around a face lies on the other mesh.
    Status place(std::uint32_t seed)
    {
        FaceMatch found; // of the part's faces, in the order of m_part
        std::vector<std::uint32_t> part;
        for (const std::uint32_t candidate : m_ofColor.at(m_colors[seed])) {
            for (const CornerOrder& order : kCornerOrders) {
                if (m_isUsed[candidate] || !tryOn(seed, {faceId(candidate), order})) {
                    if (m_isStopped) {
                        return cancelled();
                    }
                    if (m_visits > m_mostVisits) {
                        return contentsError("the mesh is too regular to match its faces by their "
                                             "neighbours alone");
                    }
                    continue;
                }
                if (!found.empty()) {
                    return contentsError(
                        "face " + std::to_string(seed) +
                        " of the mesh has several counterparts: by their neighbours alone faces "
                        "can be matched in more than one way");
                }
                for (const std::uint32_t face : m_part) {
                    found.push_back(m_match[face]);
                }
                part = m_part;
                takeBack();
            }
        }
        if (found.empty()) {
            return contentsError("face " + std::to_string(seed) +
                                 " of the mesh has no counterpart: no other face has such "
                                 "neighbours");
        }
        for (std::size_t k = 0; k < part.size(); ++k) {
            put(part[k], found[k]);
        }
        return {};
    }

    /// Follows the match across edges from a face; what does not fit is taken back.
    bool tryOn(std::uint32_t seed, const MatchedFace& on)
    {
        m_part.clear();
        put(seed, on);
        for (std::size_t next = 0; next < m_part.size(); ++next) {
            if (++m_visits % kVisitsAtOnce == 0) {
                m_isStopped =
                    !m_progress.report(0.5 + 0.5 * std::min(1.0,
                                                            static_cast<double>(m_visits) /
                                                                static_cast<double>(m_mostVisits)));
            }
            if (m_isStopped || m_visits > m_mostVisits || !spread(m_part[next])) {
                takeBack();
                return false;
            }
        }
        return true;
    }

    bool spread(std::uint32_t face)
    {
        const MatchedFace from = m_match[face];
        for (const LocalEdge edge : kLocalEdges) {
            const auto here = m_mesh.neighbour(faceId(face), edge);
            const auto there = m_other.neighbour(from.face, edgeThere(edge, from.corners));
            if (here.has_value() != there.has_value()) {
                return false;
            }
            if (!here) {
                continue;
            }
            const auto across = static_cast<std::uint32_t>(here->face);
            const MatchedFace wanted{there->face,
                                     orderAcross(here->edge, there->edge, turnsOver(from.corners))};
            if (m_isMatched[across]) {
                if (m_match[across] != wanted) {
                    return false;
                }
            } else if (m_isUsed[indexOf(there->face)] ||
                       m_colors[across] != m_otherColors[indexOf(there->face)]) {
                return false;
            } else {
                put(across, wanted);
            }
        }
        return true;
    }

    void put(std::uint32_t face, const MatchedFace& on)
    {
        m_match[face] = on;
        m_isMatched[face] = true;
        m_isUsed[indexOf(on.face)] = true;
        m_part.push_back(face);
    }

    void takeBack()
    {
        for (const std::uint32_t face : m_part) {
            m_isMatched[face] = false;
            m_isUsed[indexOf(m_match[face].face)] = false;
        }
        m_part.clear();
    }

    const Adjacency& m_mesh;
    const Adjacency& m_other;
    Progress& m_progress;
    FaceMatch m_match;
    std::vector<bool> m_isMatched;
    std::vector<bool> m_isUsed;        ///< faces of the other mesh
    std::vector<std::uint32_t> m_part; ///< faces matched in this try
    Colors m_colors;
    Colors m_otherColors;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_ofColor; ///< other faces
    std::uint64_t m_visits = 0;
    std::uint64_t m_mostVisits;
    bool m_isStopped = false;
};

} // namespace

Result<FaceMatch>
matchByNeighbours(const Adjacency& mesh, const Adjacency& other, Progress& progress)
{
    if (mesh.faceCount() != other.faceCount()) {
        return contentsError("has " + std::to_string(other.faceCount()) + " faces, the mesh " +
                             std::to_string(mesh.faceCount()));
    }
    return NeighbourMatcher(mesh, other, progress).match();
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shared_corners.h"

#include "core/base/check.h"

#include <limits>
#include <utility>

namespace trixel::render {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;
/// Faces for which a corner is remembered by what draws, more or less.
constexpr std::size_t kRecent = 128;

using Labels = std::array<std::uint32_t, 3>; // one a corner
constexpr std::array<Labels, 6> kLabellings{Labels{0, 1, 2},
                                            Labels{1, 2, 0},
                                            Labels{2, 0, 1},
                                            Labels{0, 2, 1},
                                            Labels{2, 1, 0},
                                            Labels{1, 0, 2}};

/// Face after face takes what corners there are, the latest of a vertex and a label.
class Sharing
{
public:
    Sharing(const TriangleMesh& mesh, std::span<const std::uint32_t> normals)
        : m_mesh(mesh)
        , m_normals(normals)
        , m_latest(mesh.positions.size(), {kNone, kNone, kNone})
    {
        m_made.corners.reserve(mesh.faceCount() + mesh.faceCount() / 4);
        m_made.faces.reserve(mesh.faceCount());
    }

    SharedCorners share() &&
    {
        for (std::size_t f = 0; f < m_mesh.faceCount(); ++f) {
            add(f);
        }
        m_made.corners.shrink_to_fit();
        return std::move(m_made);
    }

private:
    struct Use
    {
        std::uint32_t latest = 0; ///< face
        bool standsForFace = false;
    };

    /// What a corner of the face at hand may take.
    struct Offer
    {
        std::uint32_t corner = kNone;
        bool isFree = true;            ///< to stand for the face
        bool isStale = false;          ///< drawn so long ago that it is computed again
        std::uint32_t lastUse = kNone; ///< the latest face that took it
    };
    using Offers = std::array<std::array<Offer, 3>, 3>; // by label

    Offers offers(std::size_t f) const
    {
        Offers result;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& latest = m_latest[m_mesh.triangles[f][k]];
            for (std::size_t label = 0; label < 3; ++label) {
                const std::uint32_t corner = latest[label];
                if (corner != kNone && m_made.corners[corner].normal == m_normals[3 * f + k]) {
                    const Use& use = m_uses[corner];
                    result[k][label] = {
                        corner, !use.standsForFace, use.latest + kRecent < f, use.latest};
                }
            }
        }
        return result;
    }

    /// What it would take: a corner made anew is computed, sent and kept, a stale one computed.
    static int cost(const Offers& offers, const Labels& labels)
    {
        int fresh = 0;
        int stale = 0;
        bool hasFree = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Offer& offer = offers[k][labels[k]];
            fresh += offer.corner == kNone ? 1 : 0;
            stale += offer.isStale ? 1 : 0;
            hasFree = hasFree || offer.isFree;
        }
        if (!hasFree) { // the oldest is made anew
            fresh = 1;
            stale -= stale > 0 ? 1 : 0;
        }
        return 3 * fresh + 2 * stale;
    }

    static const Labels& bestOf(const Offers& offers)
    {
        const Labels* best = nullptr;
        int least = std::numeric_limits<int>::max();
        for (const Labels& labels : kLabellings) {
            const int own = cost(offers, labels);
            if (own < least) {
                least = own;
                best = &labels;
            }
        }
        return *best;
    }

    /// Which of the face's corners is to stand for it: of those that can the one that faces to come
    /// are the least likely to need; where none can, the same of all, to be made anew.
    static std::size_t ownOf(const std::array<Offer, 3>& corners)
    {
        const auto rank = [&](std::size_t k) {
            return std::uint64_t{corners[k].isFree ? 0U : 1U} << 32U | corners[k].lastUse;
        };
        std::size_t own = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            own = rank(k) < rank(own) ? k : own;
        }
        return own;
    }

    void add(std::size_t f)
    {
        const Offers offered = offers(f);
        const Labels& labels = bestOf(offered);
        std::array<Offer, 3> taken;
        for (std::size_t k = 0; k < 3; ++k) {
            taken[k] = offered[k][labels[k]];
        }
        const std::size_t own = ownOf(taken);
        if (!taken[own].isFree) {
            taken[own] = {};
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (taken[k].corner == kNone) {
                taken[k].corner = make(m_mesh.triangles[f][k], labels[k], m_normals[3 * f + k]);
            }
        }
        const std::uint32_t last = taken[own].corner;
        m_made.corners[last].bits |= labels[1] << 2U | labels[2] << 4U |
                                     static_cast<std::uint32_t>(f) << SharedCorner::kFaceShift;
        for (const Offer& corner : taken) {
            m_uses[corner.corner].latest = static_cast<std::uint32_t>(f);
        }
        m_uses[last].standsForFace = true;
        m_made.faces.push_back({taken[(own + 1) % 3].corner, taken[(own + 2) % 3].corner, last});
    }

    std::uint32_t make(std::uint32_t vertex, std::uint32_t label, std::uint32_t normal)
    {
        const auto corner = static_cast<std::uint32_t>(m_made.corners.size());
        m_made.corners.push_back({vertex, label, normal});
        m_uses.emplace_back();
        m_latest[vertex][label] = corner;
        return corner;
    }

    const TriangleMesh& m_mesh;
    std::span<const std::uint32_t> m_normals;
    std::vector<std::array<std::uint32_t, 3>> m_latest; ///< a vertex, by label
    std::vector<Use> m_uses;                            ///< a corner
    SharedCorners m_made;
};

} // namespace

SharedCorners SharedCorners::of(const TriangleMesh& mesh, std::span<const std::uint32_t> normals)
{
    check(normals.size() == 3 * mesh.faceCount(), "three normals a face");
    return mesh.faceCount() > kMostFaces ? SharedCorners() : Sharing(mesh, normals).share();
}

} // namespace trixel::render

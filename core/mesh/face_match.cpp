// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_match.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <unordered_map>

namespace trixel {

namespace {

/// Of the mesh's size: what text files round away.
constexpr float kTolerance = 1e-5F;

/// Numbers places: positions that are the same get the same number.
class Places
{
public:
    std::uint32_t numberOf(glm::vec3 position)
    {
        position += glm::vec3(0); // -0 is 0
        const auto [found, isNew] =
            m_numbers.try_emplace(position, static_cast<std::uint32_t>(m_numbers.size()));
        return found->second;
    }

private:
    struct Hash
    {
        std::size_t operator()(const glm::vec3& p) const
        {
            std::uint64_t hash = 0;
            for (int k = 0; k < 3; ++k) {
                std::uint32_t bits = 0;
                std::memcpy(&bits, &p[k], sizeof bits);
                hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
                hash ^= hash >> 29U;
            }
            return hash;
        }
    };
    std::unordered_map<glm::vec3, std::uint32_t, Hash> m_numbers;
};

/// Finds which of some points is nearest within a distance.
class PointGrid
{
public:
    PointGrid(std::span<const glm::vec3> points, float distance)
        : m_points(points)
        , m_distance(distance)
    {
        for (std::uint32_t k = 0; k < points.size(); ++k) {
            m_cells[key(cellOf(points[k]))].push_back(k);
        }
    }

    std::optional<std::uint32_t> nearest(glm::vec3 to) const
    {
        std::optional<std::uint32_t> best;
        float least = m_distance;
        const glm::i64vec3 middle = cellOf(to);
        for (int n = 0; n < 27; ++n) {
            const glm::i64vec3 cell = middle + glm::i64vec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
            const auto found = m_cells.find(key(cell));
            if (found == m_cells.end()) {
                continue;
            }
            for (const std::uint32_t k : found->second) {
                const float distance = glm::distance(m_points[k], to);
                if (distance < least || (distance == least && !best)) {
                    least = distance;
                    best = k;
                }
            }
        }
        return best;
    }

private:
    glm::i64vec3 cellOf(glm::vec3 point) const
    {
        const glm::dvec3 cell = glm::floor(glm::dvec3(point) / (2.0 * double{m_distance}));
        return glm::i64vec3(glm::clamp(cell, -1e15, 1e15));
    }
    static std::uint64_t key(glm::i64vec3 cell)
    {
        std::uint64_t hash = 0;
        for (int k = 0; k < 3; ++k) {
            hash = (hash ^ static_cast<std::uint64_t>(cell[k])) * 0x9E3779B97F4A7C15U;
            hash ^= hash >> 31U;
        }
        return hash;
    }

    std::span<const glm::vec3> m_points;
    float m_distance;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
};

float sizeOf(const TriangleMesh& mesh)
{
    if (mesh.positions.empty()) {
        return 0;
    }
    glm::vec3 low = mesh.positions.front();
    glm::vec3 high = low;
    for (const glm::vec3& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    return glm::distance(low, high);
}

/// Where the corners of each face lie, by number.
using CornerPlaces = std::vector<Triangle>;

CornerPlaces placesOf(const TriangleMesh& mesh, std::span<const std::uint32_t> numbers)
{
    CornerPlaces places(mesh.faceCount());
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            places[k][c] = numbers[mesh.triangles[k][c]];
        }
    }
    return places;
}

Triangle sorted(Triangle triangle)
{
    std::ranges::sort(triangle);
    return triangle;
}

struct TriangleHash
{
    std::size_t operator()(const Triangle& t) const
    {
        std::uint64_t hash = 0;
        for (const std::uint32_t k : t) {
            hash = (hash ^ k) * 0x9E3779B97F4A7C15U;
            hash ^= hash >> 32U;
        }
        return hash;
    }
};

/// The first order that brings the corners together; turns come before turning over.
std::optional<CornerOrder> orderOf(const Triangle& here, const Triangle& there)
{
    for (const CornerOrder& order : kCornerOrders) {
        if (here[0] == there[order[0]] && here[1] == there[order[1]] &&
            here[2] == there[order[2]]) {
            return order;
        }
    }
    return std::nullopt;
}

/// "(1, 0.5, 0)"
std::string text(glm::vec3 point)
{
    std::ostringstream words;
    words << '(' << point.x << ", " << point.y << ", " << point.z << ')';
    return words.str();
}

/// What has no counterpart yet, and why.
struct Pairing
{
    FaceMatch match;
    std::optional<Error> error;
    bool isMissing = false; ///< a face lacks a counterpart: coarser places may find it
};

Pairing failed(bool isMissing, std::string why)
{
    return {{}, Error{ErrorKind::Contents, std::move(why)}, isMissing};
}

/// Faces at one place: those of the same winding come before those turned over.
class Candidates
{
public:
    void add(const MatchedFace& face)
    {
        (turnsOver(face.corners) ? m_over : m_same).push_back(face);
    }
    bool areSeveral() const { return best().size() > 1; }
    std::optional<MatchedFace> only() const
    {
        return best().size() == 1 ? std::optional(best().front()) : std::nullopt;
    }

private:
    const std::vector<MatchedFace>& best() const { return m_same.empty() ? m_over : m_same; }

    std::vector<MatchedFace> m_same;
    std::vector<MatchedFace> m_over;
};

Pairing pair(const TriangleMesh& mesh, const CornerPlaces& here, const CornerPlaces& there)
{
    std::unordered_map<Triangle, std::vector<std::uint32_t>, TriangleHash> others;
    others.reserve(there.size());
    for (std::uint32_t k = 0; k < there.size(); ++k) {
        others[sorted(there[k])].push_back(k);
    }
    Pairing pairing;
    pairing.match.resize(here.size());
    std::vector<bool> used(there.size());
    for (std::uint32_t k = 0; k < here.size(); ++k) {
        const std::string name = "face " + std::to_string(k) + " of the mesh has ";
        const auto found = others.find(sorted(here[k]));
        Candidates candidates;
        if (found != others.end()) {
            for (const std::uint32_t other : found->second) {
                candidates.add({faceId(other), *orderOf(here[k], there[other])});
            }
        }
        if (candidates.areSeveral()) {
            return failed(false, name + "several counterparts, which lie on each other");
        }
        const std::optional<MatchedFace> only = candidates.only();
        if (!only || used[indexOf(only->face)]) {
            return failed(true,
                          name + "no counterpart: no other face has its corners, the first at " +
                              text(mesh.corners(faceId(k))[0]));
        }
        used[indexOf(only->face)] = true;
        pairing.match[k] = *only;
    }
    return pairing;
}

Pairing pairExactly(const TriangleMesh& mesh, const TriangleMesh& other)
{
    Places places;
    const auto numbers = [&](const TriangleMesh& of) {
        std::vector<std::uint32_t> all(of.positions.size());
        std::ranges::transform(
            of.positions, all.begin(), [&](glm::vec3 p) { return places.numberOf(p); });
        return placesOf(of, all);
    };
    const CornerPlaces here = numbers(mesh);
    return pair(mesh, here, numbers(other));
}

Pairing pairNearly(const TriangleMesh& mesh, const TriangleMesh& other)
{
    const float distance = kTolerance * sizeOf(mesh);
    if (!(distance > 0) || !std::isfinite(distance)) {
        return failed(true, "the mesh has no extent");
    }
    const PointGrid grid(mesh.positions, distance);
    // Points of the mesh that lie together are one place: that of the first.
    std::vector<std::uint32_t> here(mesh.positions.size());
    Places places;
    std::unordered_map<std::uint32_t, std::uint32_t> firsts;
    for (std::uint32_t k = 0; k < here.size(); ++k) {
        here[k] = firsts.try_emplace(places.numberOf(mesh.positions[k]), k).first->second;
    }
    std::vector<std::uint32_t> there(other.positions.size());
    std::uint32_t nowhere = static_cast<std::uint32_t>(here.size()); // each a place of its own
    for (std::size_t k = 0; k < there.size(); ++k) {
        const auto nearest = grid.nearest(other.positions[k]);
        there[k] = nearest ? here[*nearest] : nowhere++;
    }
    return pair(mesh, placesOf(mesh, here), placesOf(other, there));
}

Status sameCounts(std::size_t mesh, std::size_t other)
{
    return mesh == other ? Status()
                         : contentsError("has " + std::to_string(other) + " faces, the mesh " +
                                         std::to_string(mesh));
}

} // namespace

Result<FaceMatch>
matchByPositions(const TriangleMesh& mesh, const TriangleMesh& other, Progress& progress)
{
    if (const Status counts = sameCounts(mesh.faceCount(), other.faceCount()); !counts) {
        return tl::unexpected(counts.error());
    }
    if (!progress.report(0)) {
        return cancelled();
    }
    Pairing pairing = pairExactly(mesh, other);
    if (!progress.report(0.5)) {
        return cancelled();
    }
    if (pairing.isMissing) {
        pairing = pairNearly(mesh, other);
    }
    if (pairing.error) {
        return tl::unexpected(*pairing.error);
    }
    return progress.report(1) ? Result<FaceMatch>(std::move(pairing.match)) : cancelled();
}

bool isIdentity(const FaceMatch& match)
{
    for (std::size_t k = 0; k < match.size(); ++k) {
        if (match[k] != MatchedFace{faceId(k)}) {
            return false;
        }
    }
    return true;
}

} // namespace trixel

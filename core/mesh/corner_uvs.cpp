// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/corner_uvs.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trixel {

namespace {

glm::vec2 placeOf(std::uint32_t number, std::span<const glm::vec2> uvs)
{
    return number < uvs.size() ? uvs[number] : glm::vec2(NAN);
}

/// Appends those of the triangles that one polygon was cut into.
void addCut(std::span<const Triangle> triangles,
            std::span<const std::uint32_t> corners,
            std::span<const std::uint32_t> numbers,
            std::span<const glm::vec2> uvs,
            std::vector<glm::vec2>& places)
{
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            const auto at = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
            places.push_back(placeOf(numbers[static_cast<std::size_t>(at)], uvs));
        }
    }
}

/// Nothing where no corner has a place.
std::vector<glm::vec2> unlessNone(std::vector<glm::vec2> places)
{
    const bool any = std::any_of(places.begin(), places.end(), [](glm::vec2 place) {
        return !std::isnan(place.x) || !std::isnan(place.y);
    });
    return any ? std::move(places) : std::vector<glm::vec2>();
}

} // namespace

std::vector<glm::vec2> cornerUvs(std::span<const Triangle> triangles,
                                 std::span<const PolygonList> parts,
                                 const std::vector<UvNumbers>& numbers,
                                 std::span<const glm::vec2> uvs)
{
    check(parts.size() == numbers.size(), "numbers for every part");
    std::vector<glm::vec2> places;
    places.reserve(3 * triangles.size());
    std::size_t triangle = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].allTriangles()) {
            for (const std::uint32_t number : numbers[p]) {
                places.push_back(placeOf(number, uvs));
            }
            triangle += numbers[p].size() / 3;
            continue;
        }
        std::size_t corner = 0;
        for (const std::uint32_t size : parts[p].sizes()) {
            addCut(triangles.subspan(triangle, size - 2),
                   std::span(parts[p].corners()).subspan(corner, size),
                   std::span(numbers[p]).subspan(corner, size),
                   uvs,
                   places);
            corner += size;
            triangle += size - 2;
        }
    }
    check(places.size() == 3 * triangles.size(), "a place for every corner");
    return unlessNone(std::move(places));
}

std::vector<glm::vec2> cornerUvsOfVertices(std::span<const Triangle> triangles,
                                           std::span<const glm::vec2> vertexUvs)
{
    std::vector<glm::vec2> places;
    places.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            check(vertex < vertexUvs.size(), "a place for every vertex");
            places.push_back(vertexUvs[vertex]);
        }
    }
    return unlessNone(std::move(places));
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/uv_mapping.h"

#include "core/base/check.h"
#include "core/footprint/chain_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace trixel {

namespace {

/// Rounding in files of few digits: so far beyond a tile's border still is on it.
constexpr double kOnBorder = 1e-4;

bool isFinite(const std::array<glm::vec2, 3>& uvs)
{
    return std::all_of(uvs.begin(), uvs.end(), [](glm::vec2 uv) {
        return std::isfinite(uv.x) && std::isfinite(uv.y);
    });
}

double doubledArea(const std::array<glm::vec2, 3>& uvs)
{
    const glm::dvec2 a = glm::dvec2(uvs[1]) - glm::dvec2(uvs[0]);
    const glm::dvec2 b = glm::dvec2(uvs[2]) - glm::dvec2(uvs[0]);
    return std::abs(a.x * b.y - a.y * b.x);
}

std::string pointText(glm::vec2 uv)
{
    std::array<char, 64> text{};
    std::snprintf(
        text.data(), text.size(), "(%g, %g)", static_cast<double>(uv.x), static_cast<double>(uv.y));
    return text.data();
}

/// The corner that is furthest out.
glm::vec2 furthestCorner(const std::array<glm::vec2, 3>& uvs)
{
    const auto out = [](glm::vec2 uv) { return std::max({-uv.x, uv.x - 1, -uv.y, uv.y - 1}); };
    return *std::max_element(
        uvs.begin(), uvs.end(), [&](glm::vec2 a, glm::vec2 b) { return out(a) < out(b); });
}

Status
checkReach(FaceId face, const std::array<glm::vec2, 3>& uvs, const std::vector<UdimTile>& tiles)
{
    const std::string name = "face " + std::to_string(indexOf(face));
    const auto reached = tilesOfFace(uvs);
    const bool single = tiles.size() == 1 && tiles.front() == UdimTile{};
    if (single && (!reached || *reached != tiles)) {
        return contentsError("the mesh's uvs leave the image: " + name + " reaches " +
                             pointText(furthestCorner(uvs)) +
                             ", expected 0 to 1 (or an image that repeats, or one of tiles)");
    }
    if (!reached) {
        return contentsError("the mesh's uvs leave all tiles: " + name + " reaches " +
                             pointText(furthestCorner(uvs)));
    }
    for (const UdimTile tile : *reached) {
        if (!std::binary_search(tiles.begin(), tiles.end(), tile)) {
            return contentsError("the mesh's uvs reach tile " + std::to_string(tile.number()) +
                                 " (" + name + "), and there is no image for it");
        }
    }
    return {};
}

} // namespace

std::optional<UdimTile> udimTile(int number)
{
    if (number < 1001 || number > 9999) {
        return std::nullopt;
    }
    return UdimTile{(number - 1001) % 10, (number - 1001) / 10};
}

std::optional<UdimTile> udimTileAt(glm::dvec2 st)
{
    const double column = std::floor(st.x);
    const double row = std::floor(st.y);
    if (!(column >= 0 && column <= 9 && row >= 0 && row <= 899)) {
        return std::nullopt;
    }
    return UdimTile{static_cast<int>(column), static_cast<int>(row)};
}

std::optional<std::vector<UdimTile>> tilesOfFace(const std::array<glm::vec2, 3>& uvs)
{
    const auto [left, right] = std::minmax({uvs[0].x, uvs[1].x, uvs[2].x});
    const auto [lower, upper] = std::minmax({uvs[0].y, uvs[1].y, uvs[2].y});
    const auto range = [](double low, double high) {
        const double first = std::floor(low + kOnBorder);
        return std::pair(first, std::max(first, std::ceil(high - kOnBorder) - 1));
    };
    if (!isFinite(uvs)) {
        return std::vector<UdimTile>();
    }
    const auto [firstColumn, lastColumn] = range(left, right);
    const auto [firstRow, lastRow] = range(lower, upper);
    if (firstColumn < 0 || lastColumn > 9 || firstRow < 0 || lastRow > 899) {
        return std::nullopt;
    }
    std::vector<UdimTile> tiles;
    for (int row = static_cast<int>(firstRow); row <= static_cast<int>(lastRow); ++row) {
        for (int column = static_cast<int>(firstColumn); column <= static_cast<int>(lastColumn);
             ++column) {
            tiles.push_back({column, row});
        }
    }
    return tiles;
}

UvMapping::UvMapping(const TriangleMesh& mesh)
    : m_mesh(mesh)
{
    check(mesh.hasUvs(), "a mesh with uvs");
}

ImagePlace UvMapping::at(FaceId face, glm::dvec2 uv, double step) const
{
    const auto corners = m_mesh.uvs(face);
    if (!isFinite(corners)) {
        return {};
    }
    const glm::dvec2 origin(corners[0]);
    const TextureDerivatives map{glm::dvec2(corners[1]) - origin, glm::dvec2(corners[2]) - origin};
    return {true, origin + uv.x * map.perU + uv.y * map.perV, chained({{step, 0}, {0, step}}, map)};
}

Status checkUvs(const TriangleMesh& mesh, const std::vector<UdimTile>& tiles, bool repeats)
{
    if (!mesh.hasUvs()) {
        return contentsError("the mesh has no uvs");
    }
    std::vector<UdimTile> sorted = tiles;
    std::sort(sorted.begin(), sorted.end());
    bool anyPlace = false;
    bool anyArea = false;
    for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
        const auto uvs = mesh.uvs(faceId(k));
        if (!isFinite(uvs)) {
            continue;
        }
        anyPlace = true;
        anyArea = anyArea || doubledArea(uvs) > 0;
        if (const Status reach = repeats ? Status() : checkReach(faceId(k), uvs, sorted); !reach) {
            return reach;
        }
    }
    if (!anyPlace) {
        return contentsError("the mesh has no uvs: no face has one at all its corners");
    }
    if (!anyArea) {
        return contentsError("the mesh's uvs are without area: every face's three lie on a line");
    }
    return {};
}

} // namespace trixel

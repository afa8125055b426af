// SPDX-License-Identifier: GPL-3.0-or-later
//
// Made tests/data/study once; the files are the data from then on, because what this computes
// differs between builds. Usage: make_study_data FOLDER
#include "core/io/ptx.h"
#include "core/study/test_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "study_content.h"

namespace trixel {
namespace {

constexpr int kQueries = 3000;

/// In [0, 1), the same with every standard library.
double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11U) * 0x1p-53;
}

TexelStore tileOf(glm::dvec3 (*content)(double x, double y))
{
    const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
    const std::array<std::byte, 3> black{};
    TexelStore store(kTileFaces, format, kTileLevel, black);
    for (std::uint32_t f = 0; f < kTileFaces; ++f) {
        const std::span<std::byte> bytes = store.writable(faceId(f));
        for (std::uint32_t t = 0; t < kTileLevel.texelCount(); ++t) {
            const TexelCoord coord = texelAt(kTileLevel, static_cast<TexelIndex>(t));
            const glm::dvec2 at = inTile(faceId(f), centroid(kTileLevel, coord)) *
                                  static_cast<double>(kTileLevel.resolution());
            const glm::dvec3 colour = content(at.x, at.y);
            const std::array<float, 3> values{static_cast<float>(colour.x),
                                              static_cast<float>(colour.y),
                                              static_cast<float>(colour.z)};
            encode(TexelType::UInt8, values, bytes.subspan(3 * std::size_t{t}, 3));
        }
    }
    return store;
}

/// A vector of the plane, in edges, as (u,v) of a face of the tile.
glm::dvec2 inFace(FaceId face, glm::dvec2 plane)
{
    const double v = plane.y / 0.86602540378443865;
    const glm::dvec2 uv(plane.x - v / 2, v);
    return indexOf(face) % 2 == 0 ? uv : -uv;
}

constexpr double kSine = 0.86602540378443865; // of 60 degrees

/// The Gaussian of a footprint in the plane, in texels.
struct Gaussian
{
    glm::dvec2 centre;
    double xx, xy, yy; ///< covariance
};

Gaussian gaussianOf(FaceId face, glm::vec2 uv, glm::vec2 w1, glm::vec2 w2)
{
    const auto inPlane = [](glm::dvec2 oblique) {
        return glm::dvec2(oblique.x + oblique.y / 2, oblique.y * kSine);
    };
    const double resolution = kTileLevel.resolution();
    const glm::dvec2 a = inPlane(glm::dvec2(w1)) * (resolution / 2);
    const glm::dvec2 b = inPlane(glm::dvec2(w2)) * (resolution / 2);
    return {inPlane(inTile(face, uv)) * resolution,
            a.x * a.x + b.x * b.x + 0.25,
            a.x * a.y + b.x * b.y,
            a.y * a.y + b.y * b.y + 0.25};
}

/// RGB of both tiles at every texel, ready for sums: cell x, cell y, half.
class Plane
{
public:
    Plane()
        : m_texels(2 * std::size_t{kSize} * kSize)
    {
    }

    void fill(const TexelStore& tile, std::size_t first)
    {
        for (std::uint32_t f = 0; f < kTileFaces; ++f) {
            for (std::uint32_t t = 0; t < kTileLevel.texelCount(); ++t) {
                const TexelCoord coord = texelAt(kTileLevel, static_cast<TexelIndex>(t));
                const glm::dvec2 at = inTile(faceId(f), centroid(kTileLevel, coord)) *
                                      static_cast<double>(kTileLevel.resolution());
                const bool upper = at.x - std::floor(at.x) > 0.5;
                std::array<float, 3> values{};
                decode(TexelType::UInt8, tile.face(faceId(f)).texel(t), values);
                auto& texel =
                    m_texels[index(static_cast<int>(at.x), static_cast<int>(at.y), upper)];
                std::ranges::copy(values, texel.begin() + static_cast<std::ptrdiff_t>(first));
            }
        }
    }

    /// The Gaussian-weighted mean over centroids, to more than six standard deviations.
    std::array<double, 6> mean(const Gaussian& g) const
    {
        constexpr double kReachSquared = 40;
        const double determinant = g.xx * g.yy - g.xy * g.xy;
        const double reachY = std::sqrt(kReachSquared * g.yy);
        std::array<double, 6> sum{};
        double weights = 0;
        const int firstRow = static_cast<int>(std::floor((g.centre.y - reachY) / kSine)) - 1;
        const int lastRow = static_cast<int>(std::ceil((g.centre.y + reachY) / kSine));
        for (int row = firstRow; row <= lastRow; ++row) {
            for (const bool upper : {false, true}) {
                const double third = upper ? 2.0 / 3.0 : 1.0 / 3.0;
                const double dy = (row + third) * kSine - g.centre.y;
                // Along a row: mean and variance of the Gaussian given its height.
                const double rest = kReachSquared - dy * dy / g.yy;
                if (rest < 0) {
                    continue;
                }
                const double middle = g.centre.x + g.xy / g.yy * dy;
                const double variance = determinant / g.yy;
                const double offset = third + (row + third) / 2; // centroid's x at cell 0
                const double half = std::sqrt(rest * variance);
                const int begin = static_cast<int>(std::ceil(middle - half - offset));
                const int end = static_cast<int>(std::floor(middle + half - offset));
                const double height = -0.5 * dy * dy / g.yy;
                for (int cell = begin; cell <= end; ++cell) {
                    const double dx = cell + offset - middle;
                    const double weight = std::exp(height - 0.5 * dx * dx / variance);
                    const auto& texel = m_texels[index(cell, row, upper)];
                    weights += weight;
                    for (std::size_t c = 0; c < 6; ++c) {
                        sum[c] += weight * texel[c];
                    }
                }
            }
        }
        for (double& value : sum) {
            value /= weights;
        }
        return sum;
    }

private:
    static constexpr int kSize = kTileRhombi * 64;

    static std::size_t index(int x, int y, bool upper)
    {
        const auto wrapped = [](int k) { return static_cast<std::size_t>(k & (kSize - 1)); };
        return 2 * (wrapped(x) + wrapped(y) * kSize) + (upper ? 1 : 0);
    }

    std::vector<std::array<float, 6>> m_texels;
};

void writeQueries(std::ostream& out, const Plane& plane)
{
    std::mt19937_64 random(20260711);
    const double resolution = kTileLevel.resolution();
    out << "face,u,v,uw1,vw1,uw2,vw2,natural0,natural1,natural2,hard0,hard1,hard2\n";
    for (int q = 0; q < kQueries; ++q) {
        const FaceId face = faceId(static_cast<std::size_t>(uniform(random) * kTileFaces));
        glm::dvec2 uv(uniform(random), uniform(random));
        uv = uv.x + uv.y > 1 ? 1.0 - uv : uv;
        const double width = 0.25 * std::pow(256.0, uniform(random)) / resolution;
        const double length = width * std::pow(64.0, uniform(random));
        const double angle = 6.283185307179586 * uniform(random);
        // Any pair of conjugate radii stands for the same ellipse.
        const double turn = 6.283185307179586 * uniform(random);
        const glm::dvec2 major = length * glm::dvec2(std::cos(angle), std::sin(angle));
        const glm::dvec2 minor = width * glm::dvec2(-std::sin(angle), std::cos(angle));
        const glm::vec2 centre(uv);
        const glm::vec2 w1 = inFace(face, std::cos(turn) * major + std::sin(turn) * minor);
        const glm::vec2 w2 = inFace(face, std::cos(turn) * minor - std::sin(turn) * major);
        out << std::setprecision(9) << indexOf(face) << ',' << centre.x << ',' << centre.y << ','
            << w1.x << ',' << w1.y << ',' << w2.x << ',' << w2.y;
        for (const double value : plane.mean(gaussianOf(face, centre, w1, w2))) {
            out << ',' << std::setprecision(8) << value;
        }
        out << '\n';
    }
}

Status writeTile(const std::string& path, const TexelStore& store)
{
    PtxContents contents{store, tileAdjacency(), {}, false};
    PtxWriteOptions options;
    options.mips = false;
    NoProgress progress;
    return writePtx(path, contents, options, progress);
}

int make(const std::string& folder)
{
    const TexelStore naturalTile = tileOf(naturalContent);
    const TexelStore hardTile = tileOf(hardEdgedContent);
    Plane plane;
    plane.fill(naturalTile, 0);
    plane.fill(hardTile, 3);
    const Status natural = writeTile(folder + "/natural.ptx", naturalTile);
    const Status hard = writeTile(folder + "/hard-edged.ptx", hardTile);
    std::ofstream queries(folder + "/queries.csv");
    writeQueries(queries, plane);
    if (!natural || !hard || !queries) {
        std::cerr << "could not be written\n";
        return 1;
    }
    return 0;
}

} // namespace
} // namespace trixel

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::cerr << "Usage: make_study_data FOLDER\n";
        return 2;
    }
    return trixel::make(argv[1]);
}

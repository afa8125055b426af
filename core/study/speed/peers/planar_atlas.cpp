// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/atlas.h"
#include "core/study/tile_picture.h"

#include <array>

namespace trixel {
namespace {

constexpr int kWidth = 1024;
constexpr int kHeight = 2048;
constexpr double kSine = 0.86602540378443865;
/// The oblique tile repeats along a row after its width, and exactly above itself after two of its
/// heights.
constexpr double kAcross = kTileRhombi;
constexpr double kUp = 2 * kTileRhombi * kSine;

class PlanarAtlas final : public Atlas
{
public:
    PlanarAtlas(const TilePicture& tile, const TestPatch& patch)
        : m_patch(patch)
        , m_values(3 * std::size_t{kWidth} * kHeight)
    {
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto mean = pixel(tile, x, y);
                std::ranges::copy(mean, m_values.begin() + 3 * (std::ptrdiff_t{y} * kWidth + x));
            }
        }
    }

    peers::Picture picture() const override
    {
        return {kWidth, kHeight, 3, m_values.data(), true, true};
    }
    std::string about() const override { return "a periodic picture of the tile, 1024 × 2048"; }

protected:
    glm::dvec2 position(FaceId face, glm::dvec2 uv) const override
    {
        return inPicture(inTile(tileFace(face, m_patch), uv, m_patch.faces));
    }
    glm::dvec2 vector(FaceId face, glm::dvec2 w) const override
    {
        const FaceId half = faceId(indexOf(face) % 2); // vectors know no place
        return inPicture(inTile(half, w, m_patch.faces) - inTile(half, {0, 0}, m_patch.faces));
    }

private:
    static glm::dvec2 inPicture(glm::dvec2 oblique)
    {
        return {(oblique.x + oblique.y / 2) / kAcross, oblique.y * kSine / kUp};
    }

    static std::array<float, 3> pixel(const TilePicture& tile, int x, int y)
    {
        constexpr int kPoints = 4;
        std::array<float, 3> sum{};
        for (int j = 0; j < kPoints; ++j) {
            for (int i = 0; i < kPoints; ++i) {
                const double across = kAcross * (x + (i + 0.5) / kPoints) / kWidth;
                const double up = kUp * (y + (j + 0.5) / kPoints) / kHeight / kSine;
                const glm::dvec2 oblique(across - up / 2, up);
                const auto colour =
                    tile.colour(oblique * static_cast<double>(kTileLevel.resolution()));
                for (std::size_t c = 0; c < sum.size(); ++c) {
                    sum[c] += colour[c] / (kPoints * kPoints);
                }
            }
        }
        return sum;
    }

    TestPatch m_patch;
    std::vector<float> m_values;
};

} // namespace

std::unique_ptr<const Atlas>
makePlanarAtlas(const TestData& data, TestContent content, const TestPatch& patch)
{
    return std::make_unique<PlanarAtlas>(TilePicture(data.tiles[static_cast<std::size_t>(content)]),
                                         patch);
}

} // namespace trixel

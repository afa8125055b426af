// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/face_map.h"
#include "core/filter/query_ellipse.h"
#include "core/study/speed/peers/atlas.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trixel {
namespace {

constexpr int kBorder = 2;
constexpr std::uint64_t kMostPixels = std::uint64_t{64} << 20U;

/// The texel of the face at a point, brought inside.
const float* texelAtPoint(const FilterScene& scene, FaceId face, glm::dvec2 uv)
{
    const Level level = scene.level(face);
    return scene.mips()
        .texels(face, level)
        .texel(texelIndex(level, texelAt(level, broughtInside(uv))));
}

class FaceAtlas final : public Atlas
{
public:
    FaceAtlas(const FilterScene& scene, int perTexel)
        : m_perTexel(perTexel)
        , m_channels(std::min(scene.channels(), kGroupChannels))
        , m_places(scene.faceCount())
    {
        place(scene);
    }

    std::uint64_t pixels() const { return std::uint64_t(m_width) * m_height; }

    void fill(const FilterScene& scene)
    {
        m_values.assign(pixels() * static_cast<std::size_t>(m_channels), 0.0F);
        for (std::size_t f = 0; f < scene.faceCount(); ++f) {
            fillFace(scene, faceId(f));
        }
    }

    peers::Picture picture() const override
    {
        return {static_cast<int>(m_width),
                static_cast<int>(m_height),
                m_channels,
                m_values.data(),
                false,
                false};
    }
    std::string about() const override
    {
        return "an atlas with each face in a square of its own, " + std::to_string(m_width) +
               " × " + std::to_string(m_height);
    }

protected:
    glm::dvec2 position(FaceId face, glm::dvec2 uv) const override
    {
        const Place& at = m_places[face];
        return (glm::dvec2(at.x, at.y) + double{kBorder} + double(at.size) * uv) / size();
    }
    glm::dvec2 vector(FaceId face, glm::dvec2 w) const override
    {
        return double(m_places[face].size) * w / size();
    }

private:
    struct Place
    {
        std::uint32_t x = 0, y = 0;
        std::uint32_t size = 0; ///< pixels of an edge, borders apart
    };

    glm::dvec2 size() const { return {m_width, m_height}; }

    /// Rows of squares, the largest first, in a picture about as wide as it is high.
    void place(const FilterScene& scene)
    {
        std::vector<FaceId> order(scene.faceCount());
        double area = 0;
        for (std::size_t f = 0; f < order.size(); ++f) {
            order[f] = faceId(f);
            const std::uint32_t edge =
                scene.level(faceId(f)).resolution() * static_cast<std::uint32_t>(m_perTexel);
            m_places[faceId(f)].size = edge;
            area += std::pow(edge + 2 * kBorder, 2);
        }
        std::ranges::stable_sort(
            order, std::ranges::greater{}, [&](FaceId f) { return m_places[f].size; });
        const auto wanted = static_cast<std::uint32_t>(std::ceil(std::sqrt(area)));
        std::uint32_t x = 0;
        std::uint32_t y = 0;
        std::uint32_t rowHeight = 0;
        for (const FaceId face : order) {
            const std::uint32_t side = m_places[face].size + 2 * kBorder;
            if (x > 0 && x + side > wanted) {
                x = 0;
                y += std::exchange(rowHeight, 0);
            }
            rowHeight = std::max(rowHeight, side);
            m_places[face].x = x;
            m_places[face].y = y;
            x += side;
            m_width = std::max(m_width, x);
            m_height = std::max(m_height, y + rowHeight);
        }
    }

    void fillFace(const FilterScene& scene, FaceId face)
    {
        const Place& at = m_places[face];
        const std::uint32_t side = at.size + 2 * kBorder;
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                const glm::dvec2 uv = (glm::dvec2(x, y) + 0.5 - double{kBorder}) / double(at.size);
                const float* texel = texelAtPoint(scene, face, uv);
                std::copy_n(texel,
                            m_channels,
                            m_values.begin() + static_cast<std::ptrdiff_t>(
                                                   (std::uint64_t(at.y + y) * m_width + at.x + x) *
                                                   static_cast<std::uint64_t>(m_channels)));
            }
        }
    }

    int m_perTexel;
    int m_channels;
    FaceMap<Place> m_places;
    std::uint32_t m_width = 1, m_height = 1;
    std::vector<float> m_values;
};

} // namespace

std::unique_ptr<const Atlas> makeFaceAtlas(const FilterScene& scene)
{
    for (const int perTexel : {2, 1}) {
        auto atlas = std::make_unique<FaceAtlas>(scene, perTexel);
        if (atlas->pixels() <= kMostPixels) {
            atlas->fill(scene);
            return atlas;
        }
    }
    return nullptr;
}

} // namespace trixel

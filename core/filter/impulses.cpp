// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/impulses.h"

#include "core/filter/query_filter.h"
#include "core/lattice/reduction.h"

#include <cstring>
#include <glm/vec2.hpp>
#include <utility>

namespace trixel {
namespace {

constexpr TexelFormat kFormat{TexelType::Float, kGroupChannels, std::nullopt};
constexpr std::size_t kTexelFloats = kGroupChannels;

/// The squares of pixels that hold the texels under a block: those stored the way it is itself, and
/// those of the other half of the packed square.
struct BlockSquares
{
    std::uint32_t side = 1;
    std::array<glm::uvec2, 2> begin{};

    BlockSquares(const TexelBlock& block, Level base)
        : side(base.resolution() / block.level.resolution())
    {
        const std::uint32_t x = block.pixel.x * side;
        const std::uint32_t y = block.pixel.y * side;
        begin = {glm::uvec2(x, y),
                 glm::uvec2(base.resolution() - y - side, base.resolution() - x - side)};
    }

    /// A single texel has none in the other half.
    std::span<const glm::uvec2> used() const { return std::span(begin).first(side == 1 ? 1 : 2); }

    void addRects(FaceId face, std::vector<TouchedRect>& rects) const
    {
        for (const glm::uvec2 at : used()) {
            rects.push_back({face,
                             static_cast<std::uint16_t>(at.x),
                             static_cast<std::uint16_t>(at.y),
                             static_cast<std::uint16_t>(side),
                             static_cast<std::uint16_t>(side),
                             false});
        }
    }
};

} // namespace

std::array<TexelBlock, 4> finerBlocks(const TexelBlock& block)
{
    const Level fine(block.level.log2() + 1);
    std::array<TexelBlock, 4> finer;
    const auto pixels = finerPixels(fine, block.pixel);
    for (std::size_t k = 0; k < finer.size(); ++k) {
        finer[k] = {block.face, fine, pixels[k]};
    }
    return finer;
}

Result<Impulses> Impulses::build(const std::shared_ptr<const FilterScene>& scene,
                                 Threads threads,
                                 Progress& progress)
{
    FaceMap<Level> levels(scene->faceCount());
    for (std::size_t f = 0; f < levels.size(); ++f) {
        levels[faceId(f)] = scene->level(faceId(f));
    }
    const std::array<float, kTexelFloats> zero{};
    Impulses impulses;
    impulses.m_zeroStore = TexelStore(kFormat, levels, std::as_bytes(std::span(zero)));
    const std::shared_ptr<const FilterSurface> surface(scene, &scene->surface());
    auto built = FilterScene::build(surface, impulses.m_zeroStore, threads, progress);
    if (!built) {
        return tl::unexpected(built.error());
    }
    impulses.m_zeroScene = std::move(*built);
    impulses.m_isHeld.resize(levels.size());
    impulses.forget();
    return impulses;
}

bool Impulses::fits(const FilterScene& scene) const
{
    if (&scene.surface() != &m_zeroScene.surface()) {
        return false;
    }
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        if (scene.level(faceId(f)) != m_zeroScene.level(faceId(f))) {
            return false;
        }
    }
    return true;
}

void Impulses::forget()
{
    m_store = m_zeroStore;
    m_scene = m_zeroScene;
    m_ones.clear();
    m_isHeld.assign(m_isHeld.size(), false);
    m_heldTexels = 0;
}

std::optional<std::array<double, kGroupChannels>> Impulses::answers(
    const FilterMethod& method, const FilterQueries& query, std::span<const TexelBlock> blocks)
{
    check(query.size() == 1 && blocks.size() <= kGroupChannels, "one query, four blocks at most");
    std::vector<TouchedRect> rects;
    const auto touch = [&](const TexelBlock& block, std::size_t channel, float value) {
        write(block, channel, value);
        BlockSquares(block, m_scene.level(block.face)).addRects(block.face, rects);
    };
    for (std::size_t k = 0; k < m_ones.size(); ++k) {
        touch(m_ones[k], k, 0.0F);
    }
    m_ones.assign(blocks.begin(), blocks.end());
    for (std::size_t k = 0; k < m_ones.size(); ++k) {
        touch(m_ones[k], k, 1.0F);
    }
    m_scene.update(m_store, rects);

    ResultArrays results(1, kGroupChannels);
    method.filter(m_scene, query, results.results());
    if (results.taps.front() == kRefusedTaps) {
        return std::nullopt;
    }
    std::array<double, kGroupChannels> answers{};
    for (std::size_t k = 0; k < answers.size(); ++k) {
        answers[k] = static_cast<double>(results.values[k]);
    }
    return answers;
}

/// The texels under a block lie in a triangle of the square stored as it is itself, and in a
/// smaller one of the square of the other half (`finerPixels`, applied level by level).
void Impulses::write(const TexelBlock& block, std::size_t channel, float value)
{
    const Level base = m_scene.level(block.face);
    const std::size_t r = base.resolution();
    if (!m_isHeld[indexOf(block.face)]) {
        m_isHeld[indexOf(block.face)] = true;
        m_heldTexels += base.texelCount();
    }
    const std::span<std::byte> bytes = m_store.writable(block.face);
    const BlockSquares squares(block, base);
    for (std::size_t half = 0; half < squares.used().size(); ++half) {
        for (std::uint32_t y = 0; y < squares.side; ++y) {
            for (std::uint32_t x = 0; x + y + half < squares.side; ++x) {
                // From the corner at the square's origin, or from the one opposite.
                const std::uint32_t px =
                    squares.begin[half].x + (half == 0 ? x : squares.side - 1 - x);
                const std::uint32_t py =
                    squares.begin[half].y + (half == 0 ? y : squares.side - 1 - y);
                const std::size_t at = (px + py * r) * kTexelFloats + channel;
                std::memcpy(bytes.data() + at * sizeof(float), &value, sizeof(float));
            }
        }
    }
}

} // namespace trixel

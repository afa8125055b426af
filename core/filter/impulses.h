// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// A texel of any level of a face: all base-level texels under it.
struct TexelBlock
{
    FaceId face{};
    Level level;
    PackedPixel pixel;

    bool operator==(const TexelBlock&) const = default;
};

/// The four blocks one level finer. \param block  below its face's own level
std::array<TexelBlock, 4> finerBlocks(const TexelBlock& block);

/// A scene of zeros in which up to four blocks at a time are 1, each in a channel of its own: what
/// a method answers there is how much it reads of them.
class Impulses
{
public:
    /// On the surface and at the levels of a scene, which lives on as long. Fails only when
    /// cancelled.
    static Result<Impulses>
    build(const std::shared_ptr<const FilterScene>& scene, Threads threads, Progress& progress);

    bool fits(const FilterScene& scene) const;

    /// The method's answers; nothing where it refuses the query.
    /// \param query   a single one
    /// \param blocks  at most four
    std::optional<std::array<double, kGroupChannels>> answers(const FilterMethod& method,
                                                              const FilterQueries& query,
                                                              std::span<const TexelBlock> blocks);

    /// Texels of faces that were written to and now take memory.
    std::uint64_t heldTexels() const { return m_heldTexels; }
    /// Gives that memory back.
    void forget();

    const FilterScene& scene() const { return m_scene; }

private:
    Impulses() = default;

    void write(const TexelBlock& block, std::size_t channel, float value);

    TexelStore m_zeroStore; ///< as it was at first
    FilterScene m_zeroScene;
    TexelStore m_store;
    FilterScene m_scene;
    std::vector<TexelBlock> m_ones; ///< block k is 1 in channel k
    std::vector<bool> m_isHeld;     ///< of each face
    std::uint64_t m_heldTexels = 0;
};

} // namespace trixel

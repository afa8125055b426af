// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plans → probes: which lines queries have, and where the probes of these lie. Included once per
// instruction set (see Highway).
#include "core/filter/probe_lanes_simd-inl.h"
#include "core/filter/probe_walk.h"

#include <cmath>
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>
#include <span>

#if defined(TRIXEL_PROBE_PLACE_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_PLACE_SIMD
#undef TRIXEL_PROBE_PLACE_SIMD
#else
#define TRIXEL_PROBE_PLACE_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The lines of one query.
struct QueryLines
{
    std::size_t first = 0, count = 0;
};

/// A line, its probes' weights and the pieces that these are in.
struct PlacedLine
{
    int fine = 0;         ///< number of the finer level
    float coarse = 0;     ///< weight of the coarser level
    float share = 1;      ///< of the answer
    std::size_t bell = 0; ///< place of the weights of either side's probes
    /// Each side's first piece, from which `PieceReads::next` leads on.
    std::int32_t first[2] = {-1, -1};
};

/// Where pieces find the vertices that their probes read.
struct PieceReads
{
    ConformingPyramid::Finest level;
    std::int32_t next = -1; ///< piece of the same side
};

/// Queries on their way from plans to answers, a batch at a time.
struct ProbeBatch
{
    QueryLines queries[ProbePlans::kSize];
    ProbeLine probed[WalkLines::kSize];
    PlacedLine lines[WalkLines::kSize];
    alignas(64) float bells[Pieces::kMostProbes]; ///< weights of lines' probes
    WalkLines walked;
    SideLanes sides;
    Pieces pieces;
    PieceReads reads[Pieces::kRoom]; ///< of the pieces
};

/// Tells what pieces read, from `begin` on, and hands them to their lines.
void linkPieces(const FilterScene& scene, std::size_t begin, ProbeBatch& batch)
{
    for (std::size_t k = batch.pieces.count; k > begin;) {
        --k;
        const std::size_t side = batch.pieces.side(k);
        PlacedLine& line = batch.lines[side / 2];
        const auto face = faceId(static_cast<std::size_t>(batch.pieces.face[k]));
        std::int32_t& first = line.first[side % 2];
        batch.reads[k] = {scene.pyramid().finest(face, Level(line.fine)), first};
        first = static_cast<std::int32_t>(k);
    }
}

/// Weights of probes: exp(-c x²) - exp(-c).
void weighProbes(double c, std::size_t count, float* places)
{
    const hn::ScalableTag<float> d;
    const auto falloff = hn::Set(d, static_cast<float>(-c));
    const auto pedestal = hn::Set(d, static_cast<float>(std::exp(-c)));
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto x = hn::Load(d, places + k);
        const auto bell = hn::Sub(hn::Exp(d, hn::Mul(falloff, hn::Mul(x, x))), pedestal);
        // Never nothing: at a border one probe may be all there is.
        hn::Store(hn::Max(bell, hn::Set(d, 1e-6F)), d, places + k);
    }
}

/// Where the probes of a side are, in supports.
void layPlaces(double support, std::size_t count, float* places)
{
    const hn::ScalableTag<float> d;
    const auto perSupport = hn::Set(d, static_cast<float>(1 / support));
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto number = hn::Iota(d, static_cast<float>(k) + 0.5F);
        hn::StoreU(hn::Min(hn::Mul(number, perSupport), hn::Set(d, 1.0F)), d, places + k);
    }
}

/// Places the probes of as many queries of a block as there is room for, from `first` on; returns
/// how many.
/// \param faces    of the block's queries
/// \param falloff  of the weights, see `ProbeLine`
std::size_t placeSome(const FilterScene& scene,
                      const ProbePlans& plans,
                      std::span<const FaceId> faces,
                      double falloff,
                      std::size_t first,
                      ProbeBatch& batch)
{
    std::size_t lines = 0;
    std::size_t perSides = 0;
    std::size_t count = 0;
    batch.walked.count = 0;
    batch.pieces.count = 0;
    for (; first + count < faces.size() && lines + kMostLines <= WalkLines::kSize &&
           2 * perSides + kMostLines * kRoomPerLine <= Pieces::kMostProbes;
         ++count) {
        const std::size_t plan = first + count;
        QueryLines& query = batch.queries[count];
        query = {lines, linesOf(plans, plan, faces[plan], batch.probed + lines)};
        for (std::size_t l = 0; l < query.count; ++l, ++lines) {
            const ProbeLine& line = batch.probed[lines];
            batch.walked.isCut[lines] = false;
            batch.lines[lines] = {static_cast<int>(plans.fine[plan]),
                                  static_cast<float>(plans.coarse[plan]),
                                  static_cast<float>(line.share),
                                  perSides};
            int perSide = 1;
            if (line.hasDirection()) {
                perSide = line.perSide();
                batch.walked.add(line, perSide, lines);
            } else {
                placeProbes(scene.surface(), line, 2 * lines, batch.pieces);
            }
            layPlaces(line.support, static_cast<std::size_t>(perSide), batch.bells + perSides);
            perSides += static_cast<std::size_t>(perSide);
        }
    }
    weighProbes(falloff, perSides, batch.bells);
    LineWalker(scene.surface(), batch.walked, batch.sides, batch.pieces).walk();
    linkPieces(scene, 0, batch);
    const std::size_t placed = batch.pieces.count;
    for (std::size_t l = 0; l < lines; ++l) {
        if (batch.walked.isCut[l]) {
            batch.lines[l].first[0] = batch.lines[l].first[1] = -1;
            placeProbes(scene.surface(), batch.probed[l], 2 * l, batch.pieces);
        }
    }
    linkPieces(scene, placed, batch);
    return count;
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_painter.h"

#include "core/base/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel {

namespace {

/// Texels for which another thread is worth starting: about two milliseconds of work. With less it
/// saves less than the wait for its start and end costs on a busy machine.
constexpr double kTexelsPerThread = 150'000;
constexpr std::size_t kPiecesAtATime = 4;
/// A texel on a limit surface takes so many times longer, at least when it is first reached.
constexpr double kLimitCost = 8;
constexpr double kTexelsOfTile = StrokeFace::kTileSide * StrokeFace::kTileSide;

RowRange within(RowRange rows, std::uint32_t begin, std::uint32_t end)
{
    return {std::max(rows.begin, begin), std::min(rows.end, end)};
}

/// Makes the rectangle hold another one, too. \param width  not 0
void extend(
    TouchedRect& rect, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height)
{
    const bool isFirst = rect.width == 0;
    const std::uint32_t left = isFirst ? x : std::min<std::uint32_t>(rect.x, x);
    const std::uint32_t top = isFirst ? y : std::min<std::uint32_t>(rect.y, y);
    const std::uint32_t right = std::max<std::uint32_t>(rect.x + rect.width, x + width);
    const std::uint32_t bottom = std::max<std::uint32_t>(rect.y + rect.height, y + height);
    rect.x = static_cast<std::uint16_t>(left);
    rect.y = static_cast<std::uint16_t>(top);
    rect.width = static_cast<std::uint16_t>(right - left);
    rect.height = static_cast<std::uint16_t>(bottom - top);
}

/// Grows the coverage of consecutive texels; false when all of them had enough already.
/// \param first  of the texels' places in the span
bool growCoverage(const Dab& dab,
                  Falloff falloff,
                  float flow,
                  const DabSpan& span,
                  std::uint32_t first,
                  std::span<float> coverage)
{
    // Plain values and no branches, so that the loop runs several texels at a time.
    const int count = static_cast<int>(coverage.size());
    const float start = span.start + static_cast<float>(first) * span.step;
    const float height = span.heightSquared;
    const float step = span.step;
    const float cap = dab.cap;
    float* const values = coverage.data();
    int grew = 0;
    for (int k = 0; k < count; ++k) {
        const float along = start + static_cast<float>(k) * step;
        const float strength = flow * falloff.at(std::sqrt(height + along * along));
        const float before = values[k];
        const float after = covered(before, cap, strength);
        grew |= after > before ? 1 : 0;
        values[k] = after;
    }
    return grew != 0;
}

bool facesAway(const LimitTexel& texel, const Dab& dab)
{
    return glm::dot(texel.normal, dab.normal) < kFacesAway; // no normal faces no way
}

/// The same by where the texels lie.
bool growCoverageAt(const Dab& dab,
                    Falloff falloff,
                    float flow,
                    std::span<const LimitTexel> texels,
                    std::span<float> coverage)
{
    const float inverse = 1.0F / dab.radius;
    int grew = 0;
    for (std::size_t k = 0; k < texels.size(); ++k) {
        if (facesAway(texels[k], dab)) {
            continue;
        }
        const glm::vec3 from = (texels[k].position - dab.centre) * inverse;
        const float strength = flow * falloff.at(std::sqrt(glm::dot(from, from)));
        const float before = coverage[k];
        const float after = covered(before, dab.cap, strength);
        grew |= after > before ? 1 : 0;
        coverage[k] = after;
    }
    return grew != 0;
}

} // namespace

DabPainter::DabPainter(
    TexelBlend blend, float hardness, float flow, Threads threads, std::optional<LimitTexels> limit)
    : m_blend(std::move(blend))
    , m_falloff(hardness)
    , m_flow(flow)
    , m_threads(threads)
    , m_limit(std::move(limit))
{
}

DabPainter::DabPainter(const TexelFormat& format,
                       std::span<const float> value,
                       float hardness,
                       float flow,
                       Threads threads,
                       std::optional<LimitTexels> limit)
    : DabPainter(TexelBlend(format, value), hardness, flow, threads, std::move(limit))
{
}

StrokeFace& DabPainter::strokeFace(FaceId face, const TexelStore& store)
{
    const auto [place, isNew] =
        m_placeOf.try_emplace(static_cast<std::uint32_t>(face), m_faces.size());
    if (isNew) {
        m_faces.emplace_back(face, store.face(face));
    }
    StrokeFace& found = m_faces[place->second];
    check(found.level() == store.face(face).level(), "levels stay during a stroke");
    return found;
}

DabPainter::Piece& DabPainter::nextPiece()
{
    if (m_pieceCount == m_pieces.size()) {
        m_pieces.emplace_back();
    }
    Piece& piece = m_pieces[m_pieceCount++];
    piece.segments.clear();
    piece.touched = {};
    piece.changes = false;
    piece.limit = nullptr;
    return piece;
}

void DabPainter::addPieces(FaceId face,
                           const Dab& dab,
                           const TriangleMesh& mesh,
                           const TexelStore& store)
{
    const Level level = store.face(face).level();
    const auto corners = mesh.corners(face);
    const HalfRaster lower(corners, level, TexelHalf::Lower, dab);
    const HalfRaster upper(corners, level, TexelHalf::Upper, dab);
    const RowRange lowerRows = lower.rows();
    const RowRange upperRows = upper.rows();
    if (lowerRows.isEmpty() && upperRows.isEmpty()) {
        return;
    }
    StrokeFace& strokeFace = this->strokeFace(face, store);
    const std::uint32_t side = strokeFace.tileSide();
    for (std::uint32_t tileY = 0; tileY < strokeFace.tilesPerRow(); ++tileY) {
        const RowRange lowerHere = within(lowerRows, tileY * side, (tileY + 1) * side);
        const RowRange upperHere = within(upperRows, tileY * side, (tileY + 1) * side);
        if (lowerHere.isEmpty() && upperHere.isEmpty()) {
            continue;
        }
        Piece& piece = nextPiece();
        piece.face = &strokeFace;
        piece.now = &store.face(face);
        piece.lower = lower;
        piece.upper = upper;
        piece.lowerRows = lowerHere;
        piece.upperRows = upperHere;
        piece.tileY = tileY;
    }
}

void DabPainter::addLimitPieces(FaceId face, const Dab& dab, const TexelStore& store)
{
    LimitFaceTexels& texels = m_limit->face(face, store.face(face).level());
    for (std::uint32_t tileY = 0; tileY < texels.tilesPerRow(); ++tileY) {
        bool isInReach = false;
        for (std::uint32_t tileX = 0; tileX < texels.tilesPerRow() && !isInReach; ++tileX) {
            isInReach = texels.isInReach(tileX, tileY, dab);
        }
        if (isInReach) {
            Piece& piece = nextPiece();
            piece.face = &strokeFace(face, store);
            piece.now = &store.face(face);
            piece.limit = &texels;
            piece.tileY = tileY;
        }
    }
}

void DabPainter::coverLimit(Piece& piece, const Dab& dab) const
{
    LimitSurface::Evaluator evaluator(m_limit->surface());
    for (std::uint32_t tileX = 0; tileX < piece.limit->tilesPerRow(); ++tileX) {
        if (piece.limit->isInReach(tileX, piece.tileY, dab)) {
            coverTile(piece, tileX, piece.limit->texels(tileX, piece.tileY, evaluator), dab);
        }
    }
}

void DabPainter::coverTile(Piece& piece,
                           std::uint32_t tileX,
                           std::span<const LimitTexel> texels,
                           const Dab& dab) const
{
    const std::uint32_t side = piece.face->tileSide();
    const float reach = dab.radius * dab.radius;
    for (std::uint32_t row = 0; row < side; ++row) {
        const auto line = texels.subspan(std::size_t{row} * side, side);
        const auto isInside = [&](const LimitTexel& texel) {
            const glm::vec3 from = texel.position - dab.centre;
            return glm::dot(from, from) < reach && !facesAway(texel, dab);
        };
        const auto first = std::ranges::find_if(line, isInside);
        if (first == line.end()) {
            continue;
        }
        const auto last = std::find_if(line.rbegin(), line.rend(), isInside).base();
        const auto begin = static_cast<std::uint32_t>(first - line.begin());
        const auto count = static_cast<std::uint32_t>(last - first);
        const StrokeTile& tile = piece.face->reach(tileX, piece.tileY, *piece.now);
        const auto coverage = tile.coverage().subspan(row * side + begin, count);
        if (growCoverageAt(dab, m_falloff, m_flow, line.subspan(begin, count), coverage)) {
            note(piece, tile, tileX * side + begin, piece.tileY * side + row, count);
        }
    }
}

void DabPainter::coverRow(Piece& piece,
                          const HalfRaster& half,
                          std::uint32_t row,
                          const Dab& dab) const
{
    const DabSpan span = half.span(row);
    const std::uint32_t side = piece.face->tileSide();
    for (std::uint32_t x = span.begin; x < span.end;) {
        const std::uint32_t tileX = x / side;
        const std::uint32_t count = std::min(span.end, (tileX + 1) * side) - x;
        const StrokeTile& tile = piece.face->reach(tileX, piece.tileY, *piece.now);
        const auto coverage = tile.coverage().subspan(row % side * side + x % side, count);
        if (growCoverage(dab, m_falloff, m_flow, span, x - span.begin, coverage)) {
            note(piece, tile, x, row, count);
        }
        x += count;
    }
}

void DabPainter::note(
    Piece& piece, const StrokeTile& tile, std::uint32_t x, std::uint32_t row, std::uint32_t count)
{
    extend(piece.touched, x, row, count, 1);
    const std::uint32_t side = piece.face->tileSide();
    const std::uint32_t resolution = piece.face->level().resolution();
    const Segment segment{&tile, row % side * side + x % side, row * resolution + x, count};
    if (side < resolution || piece.segments.empty()) {
        piece.segments.push_back(segment);
        return;
    }
    // All of the face is one tile: one segment from the first texel to the last.
    Segment& all = piece.segments.front();
    const std::uint32_t first = std::min(all.firstOfTile, segment.firstOfTile);
    const std::uint32_t end =
        std::max(all.firstOfTile + all.count, segment.firstOfTile + segment.count);
    all = {&tile, first, first, end - first};
}

void DabPainter::cover(Piece& piece, const Dab& dab) const
{
    if (piece.limit != nullptr) {
        coverLimit(piece, dab);
    } else {
        for (std::uint32_t row = piece.lowerRows.begin; row < piece.lowerRows.end; ++row) {
            coverRow(piece, piece.lower, row, dab);
        }
        for (std::uint32_t row = piece.upperRows.begin; row < piece.upperRows.end; ++row) {
            coverRow(piece, piece.upper, row, dab);
        }
    }
    // Only a constant face needs to know: spreading it out is what costs.
    piece.changes = !piece.segments.empty() && (!piece.now->isConstant() || changesAnything(piece));
}

/// Calls work(before, coverage, first texel of the face) for runs of texels of all segments, until
/// it returns false.
template <class Work>
void DabPainter::forEachRun(const Piece& piece, Work&& work) const
{
    for (const Segment& segment : piece.segments) {
        for (std::uint32_t done = 0; done < segment.count; done += StrokeFace::kRunTexels) {
            const std::uint32_t count = std::min(StrokeFace::kRunTexels, segment.count - done);
            const std::uint32_t first = segment.firstOfTile + done;
            const std::span<const float> coverage = segment.tile->coverage().subspan(first, count);
            const auto before = piece.face->before(*segment.tile, first, count);
            if (!work(before, coverage, segment.firstOfFace + done)) {
                return;
            }
        }
    }
}

bool DabPainter::changesAnything(const Piece& piece) const
{
    std::vector<std::byte> after(StrokeFace::kRunTexels * m_blend.format().texelBytes());
    bool same = true;
    forEachRun(piece, [&](auto before, auto coverage, std::uint32_t /*first*/) {
        const std::span<std::byte> texels = std::span(after).first(before.size());
        m_blend.blend(before, coverage, texels);
        same = std::ranges::equal(before, texels);
        return same;
    });
    return !same;
}

void DabPainter::blend(const Piece& piece) const
{
    const std::size_t texelBytes = m_blend.format().texelBytes();
    forEachRun(piece, [&](auto before, auto coverage, std::uint32_t first) {
        m_blend.blend(before, coverage, piece.texels.subspan(first * texelBytes, before.size()));
        return true;
    });
}

void DabPainter::touch(const Piece& piece, bool isSpreadNow)
{
    TouchedRect& rect = piece.face->touched;
    if (rect.width == 0) {
        m_touched.push_back(piece.face);
    }
    const TouchedRect& more = piece.touched;
    extend(rect, more.x, more.y, more.width, more.height);
    rect.face = piece.face->id();
    rect.wholeFace = rect.wholeFace || isSpreadNow;
}

void DabPainter::makeWritable(TexelStore& store)
{
    // The pieces of a face follow each other; one that changes makes all of them writable.
    for (std::size_t begin = 0; begin < m_pieceCount;) {
        std::size_t end = begin;
        bool changes = false;
        while (end < m_pieceCount && m_pieces[end].face == m_pieces[begin].face) {
            changes |= m_pieces[end++].changes;
        }
        const FaceId face = m_pieces[begin].face->id();
        const bool wasConstant = store.face(face).isConstant();
        const std::span<std::byte> texels = changes ? store.writable(face) : std::span<std::byte>();
        for (; begin < end; ++begin) {
            Piece& piece = m_pieces[begin];
            if (!changes) {
                piece.segments.clear();
            } else if (!piece.segments.empty()) {
                piece.texels = texels;
                touch(piece, wasConstant);
            }
        }
    }
}

double DabPainter::expectedTexels(const Piece& piece, const Dab& dab) const
{
    if (piece.limit == nullptr) {
        return (piece.lowerRows.end - piece.lowerRows.begin) * piece.lower.longestRow() * 0.5 +
               (piece.upperRows.end - piece.upperRows.begin) * piece.upper.longestRow() * 0.5;
    }
    double texels = 0;
    for (std::uint32_t tileX = 0; tileX < piece.limit->tilesPerRow(); ++tileX) {
        texels += piece.limit->isInReach(tileX, piece.tileY, dab) ? kTexelsOfTile : 0;
    }
    return texels * kLimitCost;
}

Threads DabPainter::threadsFor(double texels) const
{
    const double useful = std::clamp(texels / kTexelsPerThread, 1.0, 1024.0);
    return {std::min(m_threads.count, static_cast<unsigned>(useful))};
}

void DabPainter::paint(const Dab& dab,
                       const TriangleMesh& mesh,
                       std::span<const FaceId> faces,
                       TexelStore& store)
{
    check(store.format() == m_blend.format(), "the format the stroke began with");
    m_pieceCount = 0;
    for (const FaceId face : faces) {
        if (m_limit) {
            addLimitPieces(face, dab, store);
        } else {
            addPieces(face, dab, mesh, store);
        }
    }
    double texels = 0; // about: enough to choose how many threads to start
    for (std::size_t k = 0; k < m_pieceCount; ++k) {
        texels += expectedTexels(m_pieces[k], dab);
    }
    const Threads threads = threadsFor(texels);
    parallelFor(m_pieceCount, kPiecesAtATime, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            cover(m_pieces[k], dab);
        }
    });
    makeWritable(store);
    parallelFor(m_pieceCount, kPiecesAtATime, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            blend(m_pieces[k]);
        }
    });
}

std::vector<TouchedRect> DabPainter::takeTouched()
{
    std::vector<TouchedRect> touched;
    touched.reserve(m_touched.size());
    for (StrokeFace* face : m_touched) {
        touched.push_back(std::exchange(face->touched, {}));
    }
    std::ranges::sort(touched, {}, &TouchedRect::face);
    m_touched.clear();
    return touched;
}

TexelPatch DabPainter::finish(const TexelStore& store)
{
    TexelPatch patch;
    for (const StrokeFace& face : m_faces) {
        face.addTo(patch, store.face(face.id()));
    }
    m_touched.clear();
    m_placeOf.clear();
    m_faces.clear();
    return patch;
}

} // namespace trixel

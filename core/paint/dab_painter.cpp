// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/dab_painter.h"

#include "core/base/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace trixel {

namespace {

/// Texels below which starting a thread costs more than it saves.
constexpr double kTexelsPerThread = 16'384;
constexpr std::size_t kPiecesAtATime = 4;

RowRange within(RowRange rows, std::uint32_t begin, std::uint32_t end)
{
    return {std::max(rows.begin, begin), std::min(rows.end, end)};
}

/// Grows the coverage of consecutive texels; false when all of them had enough already.
/// \param first  of the texels' places in the span
bool growCoverage(const Dab& dab,
                  const Falloff& falloff,
                  float flow,
                  const DabSpan& span,
                  std::uint32_t first,
                  std::span<float> coverage)
{
    // In two loops without branches, so that either runs several texels at a time.
    std::array<float, StrokeFace::kTileSide> grown;
    for (std::size_t k = 0; k < coverage.size(); ++k) {
        const float along = span.start + static_cast<float>(first + k) * span.step;
        const float strength = flow * falloff.at(std::sqrt(span.heightSquared + along * along));
        grown[k] = covered(coverage[k], dab.cap, strength);
    }
    bool grew = false;
    for (std::size_t k = 0; k < coverage.size(); ++k) {
        grew |= grown[k] != coverage[k];
        coverage[k] = grown[k];
    }
    return grew;
}

} // namespace

DabPainter::DabPainter(const TexelFormat& format,
                       std::span<const float> value,
                       float hardness,
                       float flow,
                       Threads threads)
    : m_format(format)
    , m_blend(format, value)
    , m_falloff(hardness)
    , m_flow(flow)
    , m_threads(threads)
{
}

StrokeFace& DabPainter::strokeFace(FaceId face, const TexelStore& store)
{
    const auto [place, isNew] =
        m_placeOf.try_emplace(static_cast<std::uint32_t>(face), m_faces.size());
    if (isNew) {
        m_faces.push_back(std::make_unique<StrokeFace>(face, store.face(face)));
    }
    StrokeFace& found = *m_faces[place->second];
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
    piece.changes = false;
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

void DabPainter::coverRow(Piece& piece,
                          const HalfRaster& half,
                          std::uint32_t row,
                          const Dab& dab) const
{
    const DabSpan span = half.span(row);
    const std::uint32_t side = piece.face->tileSide();
    for (std::uint32_t x = span.begin; x < span.end;) {
        const std::uint32_t tileX = x / side;
        const std::uint32_t end = std::min(span.end, (tileX + 1) * side);
        StrokeTile& tile = piece.face->reach(tileX, piece.tileY, *piece.now);
        const std::span<float> coverage(
            tile.coverage.get() + std::size_t{row % side} * side + x % side, end - x);
        if (growCoverage(dab, m_falloff, m_flow, span, x - span.begin, coverage)) {
            piece.segments.push_back({&tile,
                                      static_cast<std::uint16_t>(x),
                                      static_cast<std::uint16_t>(row),
                                      static_cast<std::uint16_t>(end - x)});
        }
        x = end;
    }
}

void DabPainter::cover(Piece& piece, const Dab& dab) const
{
    for (std::uint32_t row = piece.lowerRows.begin; row < piece.lowerRows.end; ++row) {
        coverRow(piece, piece.lower, row, dab);
    }
    for (std::uint32_t row = piece.upperRows.begin; row < piece.upperRows.end; ++row) {
        coverRow(piece, piece.upper, row, dab);
    }
    // Only a constant face needs to know: spreading it out is what costs.
    piece.changes = !piece.segments.empty() && (!piece.now->isConstant() || changesAnything(piece));
}

bool DabPainter::changesAnything(const Piece& piece) const
{
    const std::uint32_t side = piece.face->tileSide();
    std::vector<std::byte> after(side * m_format.texelBytes());
    return std::ranges::any_of(piece.segments, [&](const Segment& segment) {
        const std::uint32_t x = segment.x % side;
        const std::uint32_t y = segment.y % side;
        const auto before = piece.face->before(*segment.tile, x, y, segment.count);
        const std::span<std::byte> texels = std::span(after).first(before.size());
        const std::span<const float> coverage(
            segment.tile->coverage.get() + std::size_t{y} * side + x, segment.count);
        m_blend.blend(before, coverage, texels);
        return !std::ranges::equal(before, texels);
    });
}

void DabPainter::blend(const Piece& piece) const
{
    const std::uint32_t side = piece.face->tileSide();
    const std::size_t texelBytes = m_format.texelBytes();
    for (const Segment& segment : piece.segments) {
        const std::uint32_t x = segment.x % side;
        const std::uint32_t y = segment.y % side;
        const std::size_t first =
            std::size_t{segment.y} * piece.face->level().resolution() + segment.x;
        m_blend.blend(piece.face->before(*segment.tile, x, y, segment.count),
                      {segment.tile->coverage.get() + std::size_t{y} * side + x, segment.count},
                      piece.texels.subspan(first * texelBytes, segment.count * texelBytes));
    }
}

void DabPainter::touch(const Piece& piece, bool wasSpreadNow)
{
    const auto id = static_cast<std::uint32_t>(piece.face->id());
    const auto [place, isNew] = m_touched.try_emplace(id);
    TouchedRect& rect = place->second;
    rect.face = piece.face->id();
    if (rect.wholeFace) {
        return;
    }
    if (wasSpreadNow) {
        const auto side = static_cast<std::uint16_t>(piece.face->level().resolution());
        rect = {rect.face, 0, 0, side, side, true};
        return;
    }
    for (const Segment& segment : piece.segments) {
        const bool first = rect.width == 0;
        const int left = first ? segment.x : std::min(rect.x, segment.x);
        const int top = first ? segment.y : std::min(rect.y, segment.y);
        const int right = std::max(first ? 0 : rect.x + rect.width, segment.x + segment.count);
        const int bottom = std::max(first ? 0 : rect.y + rect.height, segment.y + 1);
        rect = {rect.face,
                static_cast<std::uint16_t>(left),
                static_cast<std::uint16_t>(top),
                static_cast<std::uint16_t>(right - left),
                static_cast<std::uint16_t>(bottom - top),
                false};
    }
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
    check(store.format() == m_format, "the format the stroke began with");
    m_pieceCount = 0;
    for (const FaceId face : faces) {
        addPieces(face, dab, mesh, store);
    }
    double texels = 0; // an upper bound is good enough to choose how many threads to start
    for (std::size_t k = 0; k < m_pieceCount; ++k) {
        const Piece& piece = m_pieces[k];
        const double rows = std::max(piece.lowerRows.end, piece.upperRows.end) -
                            std::min(piece.lowerRows.begin, piece.upperRows.begin);
        texels += rows * piece.face->level().resolution();
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
    for (const auto& [face, rect] : m_touched) {
        touched.push_back(rect);
    }
    std::ranges::sort(touched, {}, &TouchedRect::face);
    m_touched.clear();
    return touched;
}

TexelPatch DabPainter::finish(const TexelStore& store)
{
    TexelPatch patch;
    for (const auto& face : m_faces) {
        face->addTo(patch, store.face(face->id()));
    }
    m_faces.clear();
    m_placeOf.clear();
    m_touched.clear();
    return patch;
}

} // namespace trixel

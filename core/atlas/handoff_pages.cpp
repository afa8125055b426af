// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_pages.h"

#include "core/atlas/handoff_sample_points.h"
#include "core/atlas/handoff_sampler.h"
#include "core/atlas/unfolded_place.h"
#include "core/lattice/edge_transfer.h"
#include "core/mesh/face_pieces.h"
#include "core/texture/face_vertices.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>

namespace trixel {

namespace {

class HandOffPainter
{
public:
    HandOffPainter(HandOffLayout& layout,
                   const FilterScene& scene,
                   const FilterMethod& method,
                   const TexelFormat& format,
                   const HandOffColors& colors)
        : m_layout(layout)
        , m_scene(scene)
        , m_sampler(scene, method, format)
        , m_format(format)
        , m_colors(colors)
        , m_owners(layout, scene.surface())
        , m_pages(emptyPages(layout.pages(), format, colors.pages))
    {
        for (Image& page : m_pages) {
            m_pixels.push_back(page.writable());
        }
    }

    /// Those samples of a piece that the face is the one to take.
    void sample(const FacePiece& piece)
    {
        const FaceId face = piece.face;
        const int n = m_layout.tile(face).intervals();
        const HandOffOwners::Border border = m_owners.border(face);
        std::vector<HandOffSample> samples;
        QueryArrays queries;
        HandOffSample sample = sampleOfNumber(piece.first, n);
        for (std::uint64_t k = 0; k < piece.count; ++k, sample = nextSample(sample, n)) {
            if (border.owns(sample, n)) {
                const glm::vec2 uv =
                    glm::vec2(static_cast<float>(sample.i), static_cast<float>(sample.j)) /
                    static_cast<float>(n);
                samples.push_back(sample);
                queries.add(face, uv, glm::vec2(0), glm::vec2(0));
            }
        }
        const ResultArrays answers = m_sampler.sampled(queries);
        std::vector<float> pixel(m_format.channels);
        for (std::size_t k = 0; k < samples.size(); ++k) {
            for (std::size_t c = 0; c < pixel.size(); ++c) {
                pixel[c] = m_colors.stored(c, answers.values[c * samples.size() + k]);
            }
            encode(m_format.type, pixel, at(face, samples[k]));
        }
    }

    void copyVertices(FaceId face)
    {
        const int n = m_layout.tile(face).intervals();
        for (std::uint8_t k = 0; k < 3; ++k) {
            const Corner owner = m_owners.vertexOwner({face, k});
            if (owner.face != face || owner.index != k) {
                const int other = m_layout.tile(owner.face).intervals();
                std::ranges::copy(at(owner.face, cornerSample(owner.index, other)),
                                  at(face, cornerSample(k, n)).begin());
            }
        }
    }

    void copyEdges(FaceId face)
    {
        for (const LocalEdge edge : {LocalEdge::E0, LocalEdge::E1, LocalEdge::E2}) {
            if (const auto owner = m_owners.edgeOwner(face, edge)) {
                copyEdge(face, edge, *owner);
            }
        }
    }

    /// Lays the edge along the diagonal that suits it best.
    void turn(FaceId face)
    {
        std::uint8_t best = 0;
        for (const std::uint8_t turn : {std::uint8_t{1}, std::uint8_t{2}}) {
            best = excess(face, turn) < excess(face, best) ? turn : best;
        }
        if (best == 0) {
            return;
        }
        const int n = m_layout.tile(face).intervals();
        std::vector<std::byte> samples;
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i + j <= n; ++i) {
                const auto sample = at(face, {i, j});
                samples.insert(samples.end(), sample.begin(), sample.end());
            }
        }
        m_layout.setTurn(face, best);
        const std::byte* from = samples.data();
        for (int j = 0; j <= n; ++j) {
            for (int i = 0; i + j <= n; ++i) {
                std::copy_n(from, m_format.texelBytes(), at(face, {i, j}).data());
                from += m_format.texelBytes();
            }
        }
    }

    /// What lies next to the diagonal, so that it interpolates as straight as the other edges.
    void straighten(FaceId face)
    {
        const int n = m_layout.tile(face).intervals();
        for (int i = 1; i <= n; ++i) {
            goOnStraight(face, {i, n + 1 - i});
        }
    }

    /// Pixels of a face's tile, its own among them, as `pad` counts them.
    std::uint64_t tilePixels(FaceId face) const
    {
        return sampleCount(m_layout.tile(face).intervals() + 3 * m_layout.tile(face).padding());
    }

    void pad(const FacePiece& piece)
    {
        const FaceId face = piece.face;
        const HandOffTile tile = m_layout.tile(face);
        const int n = tile.intervals();
        const int p = tile.padding();
        HandOffSample inTriangle = sampleOfNumber(piece.first, n + 3 * p);
        for (std::uint64_t k = 0; k < piece.count; ++k) {
            const int i = inTriangle.i - p;
            const int j = inTriangle.j - p;
            inTriangle = nextSample(inTriangle, n + 3 * p);
            const bool isOwn = i >= 0 && j >= 0 && i + j <= n;
            const bool isStraight = i >= 1 && j >= 1 && i + j == n + 1;
            if (!isOwn && !isStraight) {
                const HandOffSample sample = ofFace(face, {i, j});
                std::ranges::copy(nearestOwn(face, sample), at(face, sample).begin());
            }
        }
    }

    std::vector<Image> takePages() { return std::move(m_pages); }

private:
    std::span<std::byte> at(FaceId face, HandOffSample sample)
    {
        const std::uint32_t page = m_layout.place(face).page;
        const AtlasPixel pixel = m_layout.pixel(face, sample);
        const std::size_t bytes = m_format.texelBytes();
        return m_pixels[page].subspan(
            (std::size_t{pixel.y} * m_layout.pages()[page].width + pixel.x) * bytes, bytes);
    }
    std::vector<float> valueAt(FaceId face, HandOffSample sample)
    {
        std::vector<float> value(m_format.channels);
        decode(m_format.type, at(face, sample), value);
        return value;
    }

    void copyEdge(FaceId face, LocalEdge edge, const EdgeNeighbour& owner)
    {
        const int n = m_layout.tile(face).intervals();
        const int m = m_layout.tile(owner.face).intervals();
        for (int k = 1; k < n; ++k) {
            // As the owner counts along the edge, the other way round.
            const double along = double(m) - double(k) * m / n;
            const int before = std::min(static_cast<int>(along), m - 1);
            const auto part = static_cast<float>(along - before);
            std::vector<float> value = valueAt(owner.face, edgeSample(owner.edge, before, m));
            if (part > 0) {
                const auto next = valueAt(owner.face, edgeSample(owner.edge, before + 1, m));
                for (std::size_t c = 0; c < value.size(); ++c) {
                    value[c] = part == 1 ? next[c] : value[c] + part * (next[c] - value[c]);
                }
            }
            encode(m_format.type, value, at(face, edgeSample(edge, k, n)));
        }
    }

    /// A sample as the face counts, given as its tile does.
    HandOffSample ofFace(FaceId face, HandOffSample inTile) const
    {
        return turnedBack(inTile, m_layout.place(face).turn, m_layout.tile(face).intervals());
    }

    /// f(i,j) = f(i,j-1) + f(i-1,j) - f(i-1,j-1), in the tile, makes the bilinear cell across the
    /// diagonal flat.
    std::vector<float> straightOn(FaceId face, HandOffSample inTile, std::uint8_t turn)
    {
        const int n = m_layout.tile(face).intervals();
        const auto value = [&](int i, int j) {
            return valueAt(face, turnedBack({inTile.i + i, inTile.j + j}, turn, n));
        };
        std::vector<float> sum = value(-1, 0);
        const std::vector<float> below = value(0, -1);
        const std::vector<float> opposite = value(-1, -1);
        for (std::size_t c = 0; c < sum.size(); ++c) {
            sum[c] += below[c] - opposite[c];
        }
        return sum;
    }

    /// By how much a diagonal would miss going on straight at its ends, where nothing can take up
    /// what the type cannot hold. \pre the face is not turned yet
    float excess(FaceId face, std::uint8_t turn)
    {
        if (m_format.type == TexelType::Half || m_format.type == TexelType::Float) {
            return 0;
        }
        const int n = m_layout.tile(face).intervals();
        float largest = 0;
        for (const HandOffSample end : {HandOffSample{1, n}, HandOffSample{n, 1}}) {
            for (const float wanted : straightOn(face, end, turn)) {
                largest = std::max(largest, std::abs(wanted - std::clamp(wanted, 0.0F, 1.0F)));
            }
        }
        return largest;
    }

    /// Where the type cannot hold what would go on straight (beyond 1, next to a hard edge), the
    /// sample opposite takes up the rest, unless it is itself of an edge.
    void goOnStraight(FaceId face, HandOffSample inTile)
    {
        const std::uint8_t turn = m_layout.place(face).turn;
        const std::vector<float> wanted = straightOn(face, inTile, turn);
        const HandOffSample sample = ofFace(face, inTile);
        encode(m_format.type, wanted, at(face, sample));
        if (inTile.i >= 2 && inTile.j >= 2) {
            const std::vector<float> got = valueAt(face, sample);
            const HandOffSample opposite = ofFace(face, {inTile.i - 1, inTile.j - 1});
            std::vector<float> moved = valueAt(face, opposite);
            for (std::size_t c = 0; c < moved.size(); ++c) {
                moved[c] += wanted[c] - got[c];
            }
            encode(m_format.type, moved, at(face, opposite));
        }
    }

    /// Of the neighbour that a sample of the padding lies in; of the face itself beyond a border.
    std::span<const std::byte> nearestOwn(FaceId face, HandOffSample sample)
    {
        const double n = m_layout.tile(face).intervals();
        const SurfacePlace place =
            unfoldedPlace(m_scene.surface().adjacency(), face, glm::dvec2(sample.i, sample.j) / n);
        return at(place.face, nearestSample(place.uv, m_layout.tile(place.face).intervals()));
    }

    HandOffLayout& m_layout;
    const FilterScene& m_scene;
    HandOffSampler m_sampler;
    TexelFormat m_format;
    const HandOffColors& m_colors;
    HandOffOwners m_owners;
    std::vector<Image> m_pages;
    std::vector<std::span<std::byte>> m_pixels; ///< of each page
};

/// Looks along the edges of faces at what both sides show, from several threads.
class JumpMeter
{
public:
    JumpMeter(const HandOffLayout& layout,
              std::span<const Image> pages,
              const Adjacency& adjacency,
              int pointsPerInterval)
        : m_layout(layout)
        , m_pages(pages)
        , m_adjacency(adjacency)
        , m_pointsPerInterval(pointsPerInterval)
    {
    }

    /// Points along those edges of the face that the other side does not count.
    std::uint64_t points(FaceId face) const
    {
        std::uint64_t sum = 0;
        for (const LocalEdge edge : kLocalEdges) {
            sum += points(face, edge);
        }
        return sum;
    }

    void measure(const FacePiece& piece)
    {
        std::vector<float> values(3 * channels());
        const auto here = std::span(values).first(channels());
        const auto there = std::span(values).subspan(channels(), channels());
        const auto scratch = std::span(values).last(channels());
        const auto look = [&](FaceId at, glm::dvec2 uv, std::span<float> value) {
            bilinear(m_pages[m_layout.place(at).page], m_layout.position(at, uv), value, scratch);
        };
        double largest = 0;
        std::uint64_t first = piece.first; // of the edge
        std::uint64_t left = piece.count;
        for (const LocalEdge edge : kLocalEdges) {
            const std::uint64_t count = points(piece.face, edge);
            const auto next = m_adjacency.neighbour(piece.face, edge);
            for (; first < count && left > 0; ++first, --left) {
                const double t = static_cast<double>(first) / static_cast<double>(count - 1);
                look(piece.face, fromEdge(edge, {t, 0}), here);
                look(next->face, fromEdge(next->edge, {1 - t, 0}), there);
                for (std::size_t c = 0; c < here.size(); ++c) {
                    largest = std::max(largest, std::abs(double(here[c]) - double(there[c])));
                }
            }
            first -= std::min(first, count);
        }
        const std::lock_guard lock(m_mutex);
        m_largest = std::max(m_largest, largest);
    }

    double largest() const { return m_largest; }

private:
    std::size_t channels() const { return m_pages.empty() ? 0 : m_pages.front().format().channels; }

    std::uint64_t points(FaceId face, LocalEdge edge) const
    {
        const auto next = m_adjacency.neighbour(face, edge);
        if (!next || std::pair(next->face, next->edge) < std::pair(face, edge)) {
            return 0;
        }
        const int intervals =
            std::max(m_layout.tile(face).intervals(), m_layout.tile(next->face).intervals());
        return static_cast<std::uint64_t>(m_pointsPerInterval) *
                   static_cast<std::uint64_t>(intervals) +
               1;
    }

    const HandOffLayout& m_layout;
    std::span<const Image> m_pages;
    const Adjacency& m_adjacency;
    int m_pointsPerInterval;
    std::mutex m_mutex;
    double m_largest = 0;
};

} // namespace

FaceMap<std::uint32_t> handOffIntervals(const TexelStore& store,
                                        const FilterSurface& surface,
                                        const HandOffOptions& options)
{
    FaceMap<std::uint32_t> intervals(store.faceCount());
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const FaceId face = faceId(f);
        intervals[face] = isConstantAround(store, surface.rings(), face)
                              ? 1
                              : options.samplesPerTexel * store.face(face).level().resolution();
    }
    return intervals;
}

Result<std::vector<Image>> handOffPages(HandOffLayout& layout,
                                        const FilterScene& scene,
                                        const FilterMethod& method,
                                        const TexelFormat& format,
                                        const HandOffColors& colors,
                                        Threads threads,
                                        Progress& progress)
{
    check(layout.faceCount() == scene.faceCount(), "a layout of these faces");
    check(format.channels == scene.channels(), "pixels of as many channels");
    check(colors.scene.empty() || colors.scene.size() == format.channels,
          "a colour space for each channel");
    HandOffPainter painter(layout, scene, method, format, colors);
    const std::size_t faces = layout.faceCount();
    StageProgress sampling(progress, 0, 0.9);
    StageProgress vertices(progress, 0.9, 0.92);
    StageProgress edges(progress, 0.92, 0.95);
    StageProgress turns(progress, 0.95, 0.96);
    StageProgress diagonals(progress, 0.96, 0.98);
    StageProgress padding(progress, 0.98, 1);
    using Painter = HandOffPainter;
    const auto by = [&](auto step) { return std::bind_front(step, &painter); };
    const auto corners = [](FaceId) { return std::uint64_t{3}; };
    const auto alongEdges = [&](FaceId face) {
        return 3 * static_cast<std::uint64_t>(layout.tile(face).intervals());
    };
    const auto samples = [&](FaceId face) { return sampleCount(layout.tile(face).intervals()); };
    // Each step reads what the ones before have written.
    Status done = forFacePieces(faces, samples, threads, sampling, by(&Painter::sample));
    if (done) {
        done = forWholeFaces(faces, corners, threads, vertices, by(&Painter::copyVertices));
    }
    if (done) {
        done = forWholeFaces(faces, alongEdges, threads, edges, by(&Painter::copyEdges));
    }
    if (done) {
        done = forWholeFaces(faces, samples, threads, turns, by(&Painter::turn));
    }
    if (done) {
        done = forWholeFaces(faces, alongEdges, threads, diagonals, by(&Painter::straighten));
    }
    if (done) {
        done = forFacePieces(faces, by(&Painter::tilePixels), threads, padding, by(&Painter::pad));
    }
    if (!done) {
        return tl::unexpected(done.error());
    }
    return painter.takePages();
}

Result<HandOffReport> measureHandOff(const HandOffLayout& layout,
                                     std::span<const Image> pages,
                                     const Adjacency& adjacency,
                                     int pointsPerInterval,
                                     Threads threads,
                                     Progress& progress)
{
    JumpMeter meter(layout, pages, adjacency, pointsPerInterval);
    return forFacePieces(
               layout.faceCount(),
               [&](FaceId face) { return meter.points(face); },
               threads,
               progress,
               [&](const FacePiece& piece) { meter.measure(piece); })
        .map([&] { return HandOffReport{meter.largest()}; });
}

} // namespace trixel

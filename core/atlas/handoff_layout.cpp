// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_layout.h"

#include "core/atlas/atlas_packer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace trixel {

namespace {

constexpr std::size_t kMostPages = 65535;
/// Graphics cards compress textures in blocks of so many pixels.
constexpr std::uint32_t kBlock = 4;

std::uint32_t roundedUp(std::uint32_t size, const HandOffOptions& options)
{
    const std::uint32_t rounded =
        options.powerOfTwo ? std::bit_ceil(size) : (size + kBlock - 1) / kBlock * kBlock;
    return std::min(rounded, options.largestPage);
}

/// Finer faces first, those of one size in order of their numbers.
std::vector<FaceId> facesBySize(const FaceMap<std::uint32_t>& intervals)
{
    std::vector<FaceId> faces(intervals.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        faces[f] = faceId(f);
    }
    std::ranges::stable_sort(faces, std::greater(), [&](FaceId face) { return intervals[face]; });
    return faces;
}

/// A width with which one page would come out about square.
std::uint32_t pageWidth(std::span<const FaceId> faces,
                        const FaceMap<std::uint32_t>& intervals,
                        const HandOffOptions& options)
{
    double area = 0;
    for (const FaceId face : faces) {
        const double side = HandOffTile(intervals[face], options.padding).side();
        area += side * side / 2;
    }
    const std::uint32_t tile = HandOffTile(intervals[faces.front()], options.padding).side();
    const double square = std::ceil(std::sqrt(area) / tile) * tile;
    return square >= options.largestPage ? options.largestPage
                                         : roundedUp(static_cast<std::uint32_t>(square), options);
}

std::uint64_t samplesOf(std::uint64_t intervals)
{
    return (intervals + 1) * (intervals + 2) / 2;
}

} // namespace

Result<HandOffLayout> HandOffLayout::plan(FaceMap<std::uint32_t> intervals,
                                          const HandOffOptions& wanted)
{
    HandOffLayout layout;
    layout.m_options = wanted;
    HandOffOptions options = wanted;
    if (options.powerOfTwo) {
        options.largestPage = std::bit_floor(options.largestPage);
    }
    layout.m_places = FaceMap<HandOffPlace>(intervals.size());
    layout.m_intervals = std::move(intervals);
    const std::vector<FaceId> faces = facesBySize(layout.m_intervals);
    if (faces.empty()) {
        return layout;
    }
    if (const std::uint32_t side = layout.tile(faces.front()).side(); side > options.largestPage) {
        return contentsError("face " + std::to_string(indexOf(faces.front())) + " needs pages of " +
                             std::to_string(side) + " pixels, more than the " +
                             std::to_string(options.largestPage) + " allowed");
    }
    AtlasPacker packer(pageWidth(faces, layout.m_intervals, options), options.largestPage, true);
    for (std::size_t begin = 0; begin < faces.size();) {
        std::size_t end = begin;
        while (end < faces.size() &&
               layout.m_intervals[faces[end]] == layout.m_intervals[faces[begin]]) {
            ++end;
        }
        const std::uint32_t side = layout.tile(faces[begin]).side();
        const auto tiles = static_cast<std::uint32_t>((end - begin + 1) / 2);
        for (const AtlasGrid& grid : packer.place(tiles, side)) {
            for (std::uint32_t k = 0; k < grid.count; ++k) {
                for (std::size_t half = 0; half < 2; ++half) {
                    const std::size_t at = begin + 2 * std::size_t{grid.first + k} + half;
                    if (at < end) {
                        layout.m_places[faces[at]] = {grid.page,
                                                      {grid.origin.x + k % grid.perRow * side,
                                                       grid.origin.y + k / grid.perRow * side},
                                                      half == 0 ? HandOffSlot::First
                                                                : HandOffSlot::Second};
                    }
                }
            }
        }
        begin = end;
    }
    layout.m_pages = packer.pages();
    for (AtlasPage& page : layout.m_pages) {
        page.height = std::max(page.height, roundedUp(page.height, options));
    }
    if (layout.m_pages.size() > kMostPages) {
        return contentsError("the atlas needs " + std::to_string(layout.m_pages.size()) +
                             " pages, more than " + std::to_string(kMostPages));
    }
    return layout;
}

HandOffSample turned(HandOffSample sample, std::uint8_t turn, int intervals)
{
    const int k = intervals - sample.i - sample.j;
    return turn == 0 ? sample : turn == 1 ? HandOffSample{sample.j, k} : HandOffSample{k, sample.i};
}

HandOffSample turnedBack(HandOffSample sample, std::uint8_t turn, int intervals)
{
    return turned(sample, static_cast<std::uint8_t>((3 - turn) % 3), intervals);
}

AtlasPixel HandOffLayout::pixel(FaceId face, HandOffSample sample) const
{
    const HandOffPlace& at = m_places[face];
    const HandOffTile in = tile(face);
    const AtlasPixel inTile = in.pixel(at.slot, turned(sample, at.turn, in.intervals()));
    return {at.origin.x + inTile.x, at.origin.y + inTile.y};
}

glm::dvec2 HandOffLayout::position(FaceId face, glm::dvec2 uv) const
{
    const HandOffPlace& at = m_places[face];
    const double w = 1 - uv.x - uv.y;
    const glm::dvec2 inTile = at.turn == 0   ? uv
                              : at.turn == 1 ? glm::dvec2(uv.y, w)
                                             : glm::dvec2(w, uv.x);
    return glm::dvec2(at.origin.x, at.origin.y) + tile(face).position(at.slot, inTile);
}

std::uint64_t HandOffLayout::usefulSamples() const
{
    std::uint64_t samples = 0;
    for (const std::uint32_t intervals : m_intervals.values()) {
        samples += samplesOf(intervals);
    }
    return samples;
}

std::uint64_t HandOffLayout::allocatedPixels() const
{
    return std::accumulate(m_pages.begin(),
                           m_pages.end(),
                           std::uint64_t{0},
                           [](std::uint64_t pixels, const AtlasPage& page) {
                               return pixels + std::uint64_t{page.width} * page.height;
                           });
}

double HandOffLayout::occupancy() const
{
    const std::uint64_t allocated = allocatedPixels();
    return allocated == 0 ? 1.0
                          : static_cast<double>(usefulSamples()) / static_cast<double>(allocated);
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_order.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace trixel {

namespace {

constexpr std::size_t kGrain = 1U << 14U;
constexpr std::uint32_t kUnknown = 0xFFFFFFFFU;

/// A number whose order is that of the floats; below kUnknown.
std::uint32_t sortable(float value)
{
    constexpr std::uint32_t kSign = 0x80000000U;
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F); // -0 is 0
    return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

/// What a face is sorted by. Texels go as levels do; so do bytes, where constant faces come first.
std::uint32_t keyOf(const FaceFacts& facts, FaceColumn column, FaceId face)
{
    switch (column) {
    case FaceColumn::Face:
        return static_cast<std::uint32_t>(face);
    case FaceColumn::Level:
    case FaceColumn::Texels:
        return static_cast<std::uint32_t>(facts.figures.level(face).log2());
    case FaceColumn::Constant:
        return facts.figures.isConstant(face) ? 1 : 0;
    case FaceColumn::Bytes:
        // A face of one texel takes as much as a constant one.
        return facts.figures.isConstant(face)
                   ? 0
                   : static_cast<std::uint32_t>(facts.figures.level(face).log2());
    default: {
        const auto value = static_cast<float>(valueIn(facts, column, face));
        return std::isnan(value) ? kUnknown : sortable(value);
    }
    }
}

/// Key above, face below: all different, so that any sort keeps equal faces in order.
using Entry = std::uint64_t;

std::vector<Entry> entriesOf(const FaceFacts& facts, const FaceOrder& order, Threads threads)
{
    // Ranges write where they stand; what passes is moved together afterwards.
    const std::size_t faces = facts.figures.faceCount();
    std::vector<Entry> entries(faces);
    std::vector<std::size_t> counts((faces + kGrain - 1) / kGrain, 0);
    const auto fill = [&](std::size_t part) {
        std::size_t next = part * kGrain;
        for (std::size_t k = next; k < std::min(faces, (part + 1) * kGrain); ++k) {
            if (passes(order.filter, facts, faceId(k))) {
                const std::uint32_t key = keyOf(facts, order.by, faceId(k));
                const std::uint32_t turned = order.descending && key != kUnknown ? ~key - 1 : key;
                entries[next++] = Entry{turned} << 32U | k;
            }
        }
        counts[part] = next - part * kGrain;
    };
    parallelFor(counts.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part) {
            fill(part);
        }
    });
    auto end = entries.begin();
    for (std::size_t part = 0; part < counts.size(); ++part) {
        const auto from = entries.begin() + static_cast<std::ptrdiff_t>(part * kGrain);
        const auto to = from + static_cast<std::ptrdiff_t>(counts[part]);
        end = from == end ? to : std::move(from, to, end);
    }
    entries.erase(end, entries.end());
    return entries;
}

/// Halves side by side, then together.
void sortEntries(std::vector<Entry>& entries, Threads threads)
{
    if (threads.count < 2 || entries.size() < 2 * kGrain) {
        std::ranges::sort(entries);
        return;
    }
    const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(entries.size() / 2);
    parallelFor(2, 1, threads, [&](std::size_t begin, std::size_t end) {
        if (begin == 0) {
            std::ranges::sort(entries.begin(), middle);
        }
        if (end == 2) {
            std::ranges::sort(middle, entries.end());
        }
    });
    std::ranges::inplace_merge(entries, middle);
}

} // namespace

bool FaceOrder::asksForTexels() const
{
    return (by != FaceColumn::Face && by != FaceColumn::Jump) || filter.asksForTexels();
}

Result<FaceRows>
arrangeFaces(const FaceFacts& facts, const FaceOrder& order, Threads threads, Progress& progress)
{
    if (!progress.report(0)) {
        return cancelled();
    }
    std::vector<Entry> entries = entriesOf(facts, order, threads);
    if (!progress.report(0.3)) {
        return cancelled();
    }
    if (!std::ranges::is_sorted(entries)) {
        sortEntries(entries, threads);
    }
    if (!progress.report(0.9)) {
        return cancelled();
    }
    FaceRows rows(facts.figures.faceCount());
    rows.m_faces.resize(entries.size());
    for (std::size_t row = 0; row < entries.size(); ++row) {
        const auto face = static_cast<std::uint32_t>(entries[row]);
        rows.m_faces[row] = FaceId{face};
        rows.m_rowOf[face] = static_cast<std::uint32_t>(row);
    }
    return rows;
}

} // namespace trixel

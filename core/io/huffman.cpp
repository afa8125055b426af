// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/huffman.h"

#include "core/base/check.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace trixel {

namespace {

constexpr std::size_t kMaxSymbols = 288;
constexpr int kMaxCodeLength = 15;

constexpr std::size_t kMaxDepth = 32; // of a tree over fewer than 65536 uses

struct Entry
{
    std::uint16_t count;
    std::uint16_t symbol;
};

// Loops over all symbols are branch-free and store to ever new places: most symbols are not used,
// and counters of the same value in a row would wait for each other.
template <class Value>
std::size_t collectUsed(std::span<const Value> values,
                        std::array<std::uint16_t, kMaxSymbols + 1>& symbols)
{
    std::size_t size = 0;
    for (std::size_t symbol = 0; symbol < values.size(); ++symbol) {
        symbols[size] = static_cast<std::uint16_t>(symbol);
        size += values[symbol] != 0 ? 1 : 0;
    }
    return size;
}

// The used symbols by rising count; equal counts by symbol. Counts are mostly small, so a counting
// sort does nearly all the work.
std::size_t collectSorted(std::span<const std::uint16_t> counts,
                          std::array<Entry, kMaxSymbols + 1>& sorted)
{
    constexpr std::size_t kBuckets = 64;
    std::array<std::uint16_t, kMaxSymbols + 1> symbols;
    const std::size_t size = collectUsed(counts, symbols);
    const auto bucketOf = [&](std::size_t k) {
        return std::min<std::size_t>(counts[symbols[k]], kBuckets - 1);
    };
    std::array<std::uint16_t, kBuckets + 1> begins{};
    for (std::size_t k = 0; k < size; ++k) {
        ++begins[bucketOf(k) + 1];
    }
    for (std::size_t bucket = 1; bucket <= kBuckets; ++bucket) {
        begins[bucket] = static_cast<std::uint16_t>(begins[bucket] + begins[bucket - 1]);
    }
    const std::size_t frequent = begins[kBuckets - 1];
    for (std::size_t k = 0; k < size; ++k) {
        sorted[begins[bucketOf(k)]++] = {counts[symbols[k]], symbols[k]};
    }
    if (size - frequent > 1) {
        std::ranges::stable_sort(
            std::span(sorted).subspan(frequent, size - frequent), {}, &Entry::count);
    }
    return size;
}

// Joins the two lightest trees again and again. Both queues, of leaves and of joined trees, rise in
// weight, so each step looks at their heads only. On return parents[k] is the tree that joined tree
// number k was joined into.
// \param leaves  one more entry than there are leaves, to be used as a mark
void joinTrees(std::span<Entry> leaves, std::span<std::uint16_t> parents)
{
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    const std::size_t leafCount = leaves.size() - 1;
    std::array<std::uint32_t, kMaxSymbols + 1> leafWeights;
    std::array<std::uint32_t, kMaxSymbols + 1> weights;
    for (std::size_t k = 0; k < leafCount; ++k) {
        leafWeights[k] = leaves[k].count;
    }
    leafWeights[leafCount] = kNone;
    weights[0] = kNone;
    std::size_t leaf = 0;
    std::size_t tree = 0;
    for (std::size_t next = 0; next + 1 < leafCount; ++next) {
        std::uint32_t weight = 0;
        for (int half = 0; half < 2; ++half) {
            const std::uint32_t leafWeight = leafWeights[leaf];
            const std::uint32_t treeWeight = weights[tree];
            const bool takeTree = treeWeight < leafWeight;
            weight += takeTree ? treeWeight : leafWeight;
            parents[tree] = static_cast<std::uint16_t>(next); // until the tree is taken
            tree += takeTree ? 1 : 0;
            leaf += takeTree ? 0 : 1;
            // The tree being made has no weight yet and cannot be taken.
        }
        weights[next] = weight;
        weights[next + 1] = kNone;
    }
}

// How many leaves lie at each depth. A level that is not all trees is filled up with leaves.
std::array<std::uint16_t, kMaxDepth> leavesAtDepths(std::span<std::uint16_t> parents)
{
    std::array<std::uint16_t, kMaxDepth + 1> treesAt{};
    std::span<std::uint16_t> depths = parents; // each tree's parent comes after it
    depths.back() = 0;
    treesAt[0] = 1;
    for (std::size_t k = parents.size() - 1; k-- > 0;) {
        depths[k] = static_cast<std::uint16_t>(depths[parents[k]] + 1);
        ++treesAt[depths[k]];
    }
    std::array<std::uint16_t, kMaxDepth> leavesAt{};
    for (std::size_t depth = 0; depth + 1 < kMaxDepth && treesAt[depth] > 0; ++depth) {
        leavesAt[depth + 1] = static_cast<std::uint16_t>(2 * treesAt[depth] - treesAt[depth + 1]);
    }
    return leavesAt;
}

} // namespace

void huffmanLengths(std::span<const std::uint16_t> counts,
                    int maxLength,
                    std::span<std::uint8_t> lengths)
{
    check(counts.size() <= kMaxSymbols && lengths.size() == counts.size(), "a length a symbol");
    check((std::size_t{1} << maxLength) >= counts.size(), "codes for all symbols");
    std::array<Entry, kMaxSymbols + 1> sorted;
    const std::size_t size = collectSorted(counts, sorted);
    std::ranges::fill(lengths, std::uint8_t{0});
    if (size < 2) {
        for (std::size_t k = 0; k < size; ++k) {
            lengths[sorted[k].symbol] = 1;
        }
        return;
    }
    for (;;) {
        std::array<std::uint16_t, kMaxSymbols + 1> parents;
        joinTrees(std::span(sorted).first(size + 1), parents);
        const auto leavesAt = leavesAtDepths(std::span(parents).first(size - 1));
        std::size_t next = size; // the most frequent symbols have the shortest codes
        for (std::size_t depth = 1; next > 0 && depth <= static_cast<std::size_t>(maxLength);
             ++depth) {
            for (std::size_t k = 0; k < leavesAt[depth]; ++k) {
                lengths[sorted[--next].symbol] = static_cast<std::uint8_t>(depth);
            }
        }
        if (next == 0) {
            return;
        }
        // Too deep: counts closer to each other make a flatter tree.
        for (Entry& leaf : std::span(sorted).first(size)) {
            leaf.count = static_cast<std::uint16_t>((leaf.count + 1) / 2);
        }
    }
}

void huffmanCodes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes)
{
    check(lengths.size() <= kMaxSymbols && codes.size() >= lengths.size(), "a code a symbol");
    std::array<std::uint16_t, kMaxSymbols + 1> symbols;
    const std::size_t size = collectUsed(lengths, symbols);
    std::array<std::uint16_t, kMaxCodeLength + 1> ofLength{};
    for (std::size_t k = 0; k < size; ++k) {
        ++ofLength[lengths[symbols[k]]];
    }
    std::array<std::uint32_t, kMaxCodeLength + 2> next{};
    for (std::size_t length = 1; length <= kMaxCodeLength; ++length) {
        next[length + 1] = (next[length] + ofLength[length]) << 1U;
    }
    // Reversed to 16 bits by swapping ever larger halves, then moved down to the code's length.
    const auto reversed = [](std::uint32_t code, unsigned length) {
        code = (code & 0x5555U) << 1U | (code >> 1U & 0x5555U);
        code = (code & 0x3333U) << 2U | (code >> 2U & 0x3333U);
        code = (code & 0x0F0FU) << 4U | (code >> 4U & 0x0F0FU);
        code = (code & 0x00FFU) << 8U | (code >> 8U & 0x00FFU);
        return static_cast<std::uint16_t>(code >> (16U - length));
    };
    for (std::size_t k = 0; k < size; ++k) {
        const std::uint8_t length = lengths[symbols[k]];
        codes[symbols[k]] = reversed(next[length]++, length);
    }
}

} // namespace trixel

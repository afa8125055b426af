// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/small_deflate.h"

#include "core/base/check.h"
#include "core/io/huffman.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <libdeflate.h>

namespace trixel {

namespace {

constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kMaxMatch = 258;
constexpr std::size_t kMinMatch = 4;
// Shorter matches from farther away cost more than the literals they stand for.
constexpr std::size_t kFarMinMatch = 5;
constexpr std::size_t kFar = 32;

std::uint32_t load32(const std::byte* from)
{
    std::uint32_t value;
    std::memcpy(&value, from, sizeof(value));
    return value;
}

// Symbol and extra bits of a length of 3 to 258 or a distance of 1 to 32768 (RFC 1951, 3.2.5).
struct Slot
{
    std::uint16_t symbol;
    std::uint8_t extraBits;
    std::uint16_t extra;
};

constexpr Slot lengthSlot(std::size_t length)
{
    const auto above = static_cast<std::uint32_t>(length - 3);
    if (length == kMaxMatch) {
        return {285, 0, 0};
    }
    if (above < 8) {
        return {static_cast<std::uint16_t>(257 + above), 0, 0};
    }
    const auto bits = static_cast<std::uint32_t>(std::bit_width(above)) - 3;
    return {static_cast<std::uint16_t>(257 + 4 * bits + (above >> bits)),
            static_cast<std::uint8_t>(bits),
            static_cast<std::uint16_t>(above & ((1U << bits) - 1))};
}

constexpr Slot distanceSlot(std::size_t distance)
{
    const auto above = static_cast<std::uint32_t>(distance - 1);
    if (above < 4) {
        return {static_cast<std::uint16_t>(above), 0, 0};
    }
    const auto bits = static_cast<std::uint32_t>(std::bit_width(above)) - 2;
    return {static_cast<std::uint16_t>(2 * bits + (above >> bits)),
            static_cast<std::uint8_t>(bits),
            static_cast<std::uint16_t>(above & ((1U << bits) - 1))};
}

// Lowest bit first, as DEFLATE counts them. What is put is kept until flushed, up to 56 bits.
class BitWriter
{
public:
    explicit BitWriter(std::byte* to)
        : m_to(to)
    {
    }

    void put(std::uint32_t bits, unsigned count)
    {
        m_bits |= std::uint64_t{bits} << m_count;
        m_count += count;
    }

    /// Writes whole bytes, and scribbles over up to eight bytes of room without asking how many.
    void flush()
    {
        std::memcpy(m_to, &m_bits, sizeof(m_bits));
        m_to += m_count / 8;
        m_bits >>= m_count & ~7U;
        m_count %= 8;
    }

    /// Fills up the last byte; the end of what was written.
    std::byte* finish()
    {
        flush();
        return m_to + (m_count > 0 ? 1 : 0);
    }

private:
    std::byte* m_to;
    std::uint64_t m_bits = 0;
    unsigned m_count = 0;
};

// The two codes of a block.
struct Codes
{
    std::array<std::uint8_t, 288> literalLengths;
    std::array<std::uint8_t, 30> distanceLengths;
    std::array<std::uint16_t, 288> literals;
    std::array<std::uint16_t, 30> distances;
};

Codes makeFixedCodes()
{
    Codes codes{};
    for (std::size_t k = 0; k < codes.literalLengths.size(); ++k) {
        codes.literalLengths[k] = k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8;
    }
    codes.distanceLengths.fill(5);
    huffmanCodes(codes.literalLengths, codes.literals);
    huffmanCodes(codes.distanceLengths, codes.distances);
    return codes;
}

const Codes kFixedCodes = makeFixedCodes();

template <std::size_t kCount>
std::uint32_t bitsOf(const std::array<std::uint16_t, kCount>& counts, const std::uint8_t* lengths)
{
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < kCount; ++k) {
        bits += std::uint32_t{counts[k]} * lengths[k];
    }
    return bits;
}

// The description of two codes at the head of a block: their lengths, repeats written short, in a
// code of their own (RFC 1951, 3.2.7).
class CodeLengths
{
public:
    CodeLengths(const Codes& codes)
    {
        m_literals = used(std::span(codes.literalLengths).first(286), 257);
        m_distances = used(codes.distanceLengths, 1);
        std::array<std::uint8_t, 286 + 30 + 8> lengths;
        std::copy_n(codes.literalLengths.begin(), m_literals, lengths.begin());
        std::copy_n(codes.distanceLengths.begin(), m_distances, lengths.begin() + m_literals);
        const auto size = static_cast<std::size_t>(m_literals + m_distances);
        std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(size), 8, kMark);
        shorten(std::span(lengths).first(size));
        huffmanLengths(m_counts, 7, m_lengths);
        while (m_lengths[kOrder[static_cast<std::size_t>(m_written - 1)]] == 0) {
            --m_written;
        }
    }

    std::uint32_t bits() const
    {
        return 14 + 3 * static_cast<std::uint32_t>(m_written) + bitsOf(m_counts, m_lengths.data()) +
               2U * m_counts[16] + 3U * m_counts[17] + 7U * m_counts[18];
    }

    void write(BitWriter& out) const
    {
        std::array<std::uint16_t, 19> codes;
        huffmanCodes(m_lengths, codes);
        out.put(static_cast<std::uint32_t>(m_literals - 257), 5);
        out.put(static_cast<std::uint32_t>(m_distances - 1), 5);
        out.put(static_cast<std::uint32_t>(m_written - 4), 4);
        out.flush();
        for (int k = 0; k < m_written; ++k) {
            out.put(m_lengths[kOrder[static_cast<std::size_t>(k)]], 3);
            out.flush();
        }
        for (std::size_t k = 0; k < m_itemCount; ++k) {
            const Item item = m_items[k];
            out.put(codes[item.symbol], m_lengths[item.symbol]);
            if (item.symbol >= 16) {
                out.put(item.extra, item.symbol == 16 ? 2 : item.symbol == 17 ? 3 : 7);
            }
            out.flush();
        }
    }

private:
    static constexpr std::array<std::uint8_t, 19> kOrder{
        16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

    static constexpr std::uint8_t kMark = 0xFF;

    struct Item
    {
        std::uint8_t symbol; // a length, or 16 … 18 for repeats
        std::uint8_t extra;
    };

    static int used(std::span<const std::uint8_t> lengths, int least)
    {
        int count = static_cast<int>(lengths.size());
        while (count > least && lengths[static_cast<std::size_t>(count - 1)] == 0) {
            --count;
        }
        return count;
    }

    void add(std::size_t symbol, std::size_t extra)
    {
        m_items[m_itemCount++] = {static_cast<std::uint8_t>(symbol),
                                  static_cast<std::uint8_t>(extra)};
        ++m_counts[symbol];
    }

    // Eight marks, which are no lengths, follow the lengths and end every run.
    void shorten(std::span<const std::uint8_t> lengths)
    {
        const std::uint8_t* end = lengths.data() + lengths.size();
        for (const std::uint8_t* at = lengths.data(); at < end;) {
            const std::uint8_t* next = at + 1;
            if (*at == 0) {
                next = afterZeros(at);
                addZeros(static_cast<std::size_t>(next - at));
            } else {
                while (*next == *at) {
                    ++next;
                }
                addRepeats(*at, static_cast<std::size_t>(next - at));
            }
            at = next;
        }
    }

    static const std::uint8_t* afterZeros(const std::uint8_t* at)
    {
        for (;; at += 8) {
            std::uint64_t eight;
            std::memcpy(&eight, at, sizeof(eight));
            if (eight != 0) {
                return at + std::countr_zero(eight) / 8;
            }
        }
    }

    void addZeros(std::size_t run)
    {
        for (; run >= 11; run -= std::min<std::size_t>(run, 138)) {
            add(18, std::min<std::size_t>(run, 138) - 11);
        }
        if (run >= 3) {
            add(17, run - 3);
            return;
        }
        for (; run > 0; --run) {
            add(0, 0);
        }
    }

    void addRepeats(std::uint8_t length, std::size_t run)
    {
        add(length, 0);
        for (--run; run >= 3; run -= std::min<std::size_t>(run, 6)) {
            add(16, std::min<std::size_t>(run, 6) - 3);
        }
        for (; run > 0; --run) {
            add(length, 0);
        }
    }

    std::array<Item, 286 + 30> m_items;
    std::size_t m_itemCount = 0;
    std::array<std::uint16_t, 19> m_counts{};
    std::array<std::uint8_t, 19> m_lengths;
    int m_literals = 0;
    int m_distances = 0;
    int m_written = 19;
};

template <class Tokens>
void writeTokens(const Tokens& tokens, const Codes& codes, BitWriter& out)
{
    int pending = 0; // literals since the last flush; three of up to 15 bits fit
    for (const auto& token : tokens) {
        if (token.distance == 0) {
            out.put(codes.literals[token.literalOrLength],
                    codes.literalLengths[token.literalOrLength]);
            if (++pending == 3) {
                out.flush();
                pending = 0;
            }
            continue;
        }
        out.flush();
        pending = 0;
        const Slot length = lengthSlot(token.literalOrLength);
        out.put(codes.literals[length.symbol], codes.literalLengths[length.symbol]);
        out.put(length.extra, length.extraBits);
        const Slot distance = distanceSlot(token.distance);
        out.put(codes.distances[distance.symbol], codes.distanceLengths[distance.symbol]);
        out.put(distance.extra, distance.extraBits);
        out.flush();
    }
    out.flush();
    out.put(codes.literals[kEndOfBlock], codes.literalLengths[kEndOfBlock]);
}

std::byte* writeStored(std::span<const std::byte> bytes, std::byte* to)
{
    const auto size = static_cast<std::uint16_t>(bytes.size());
    const auto inverse = static_cast<std::uint16_t>(~size);
    *to++ = std::byte{1}; // last block, stored
    std::memcpy(to, &size, 2);
    std::memcpy(to + 2, &inverse, 2);
    std::memcpy(to + 4, bytes.data(), bytes.size());
    return to + 4 + bytes.size();
}

} // namespace

// Greedy: the last place where the next four bytes were met.
void SmallDeflater::findTokens(std::span<const std::byte> bytes)
{
    m_literalCounts.fill(0);
    m_distanceCounts.fill(0);
    m_tokenCount = 0;
    m_extraBits = 0;
    const std::byte* data = bytes.data();
    const std::size_t size = bytes.size();
    if (m_base > ~std::uint32_t{0} - 2 * kMaxBytes) {
        m_lastAt.fill(0);
        m_base = 1;
    }
    const auto literal = [&](std::size_t at) {
        const auto value = static_cast<std::uint16_t>(data[at]);
        m_tokens[m_tokenCount++] = {value, 0};
        ++m_literalCounts[value];
    };
    std::size_t at = 0;
    while (at + kMinMatch <= size) {
        const std::uint32_t word = load32(data + at);
        std::uint32_t& last = m_lastAt[(word * 0x9E3779B1U) >> (32U - kHashBits)];
        const std::uint32_t before = last;
        last = m_base + static_cast<std::uint32_t>(at);
        if (before < m_base || load32(data + (before - m_base)) != word) {
            literal(at++);
            continue;
        }
        const std::size_t from = before - m_base;
        const std::size_t longest = std::min(size - at, kMaxMatch);
        std::size_t length = kMinMatch;
        while (length < longest && data[from + length] == data[at + length]) {
            ++length;
        }
        if (length < kFarMinMatch && at - from > kFar) {
            literal(at++);
            continue;
        }
        const Slot lengthCode = lengthSlot(length);
        const Slot distanceCode = distanceSlot(at - from);
        ++m_literalCounts[lengthCode.symbol];
        ++m_distanceCounts[distanceCode.symbol];
        m_extraBits += std::uint32_t{lengthCode.extraBits} + distanceCode.extraBits;
        m_tokens[m_tokenCount++] = {static_cast<std::uint16_t>(length),
                                    static_cast<std::uint16_t>(at - from)};
        at += length;
    }
    while (at < size) {
        literal(at++);
    }
    ++m_literalCounts[kEndOfBlock];
    m_base += static_cast<std::uint32_t>(size);
}

std::size_t SmallDeflater::zip(std::span<const std::byte> bytes, std::span<std::byte> out)
{
    check(!bytes.empty() && bytes.size() <= kMaxBytes, "a short stretch of bytes");
    check(out.size() >= roomFor(bytes.size()), "room for the stream");
    findTokens(bytes);

    Codes codes;
    huffmanLengths(m_literalCounts, 15, std::span(codes.literalLengths).first(kLiterals));
    codes.distanceLengths.fill(0);
    if (m_tokenCount < bytes.size()) { // else all are literals
        huffmanLengths(m_distanceCounts, 15, codes.distanceLengths);
    }
    const CodeLengths head(codes);
    const std::uint32_t dynamicBits = 3 + head.bits() + m_extraBits +
                                      bitsOf(m_literalCounts, codes.literalLengths.data()) +
                                      bitsOf(m_distanceCounts, codes.distanceLengths.data());
    const std::uint32_t fixedBits = 3 + m_extraBits +
                                    bitsOf(m_literalCounts, kFixedCodes.literalLengths.data()) +
                                    bitsOf(m_distanceCounts, kFixedCodes.distanceLengths.data());
    const auto storedBits = static_cast<std::uint32_t>(8 * (5 + bytes.size()));

    std::byte* to = out.data();
    *to++ = std::byte{0x78}; // DEFLATE with a window of 32 KiB
    *to++ = std::byte{0x9C}; // default effort, and the check bits
    const std::span<const Token> tokens = std::span(m_tokens).first(m_tokenCount);
    if (storedBits <= std::min(dynamicBits, fixedBits)) {
        to = writeStored(bytes, to);
    } else {
        BitWriter writer(to);
        const bool isFixed = fixedBits <= dynamicBits;
        writer.put(isFixed ? 0b011 : 0b101, 3); // last block, and its kind
        if (!isFixed) {
            huffmanCodes(std::span(codes.literalLengths).first(kLiterals), codes.literals);
            huffmanCodes(codes.distanceLengths, codes.distances);
            head.write(writer);
        }
        writeTokens(tokens, isFixed ? kFixedCodes : codes, writer);
        to = writer.finish();
    }
    const std::uint32_t sum = libdeflate_adler32(1, bytes.data(), bytes.size());
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        *to++ = static_cast<std::byte>(sum >> shift & 0xFFU);
    }
    return static_cast<std::size_t>(to - out.data());
}

} // namespace trixel

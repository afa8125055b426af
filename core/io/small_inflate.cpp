// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/small_inflate.h"

#include <algorithm>
#include <cstring>
#include <libdeflate.h>

namespace trixel {

namespace {

constexpr int kEndOfBlock = 256;
constexpr std::array<std::uint8_t, 19> kLengthOrder{
    16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

std::uint32_t reversed16(std::uint32_t code)
{
    code = (code & 0x5555U) << 1U | (code >> 1U & 0x5555U);
    code = (code & 0x3333U) << 2U | (code >> 2U & 0x3333U);
    code = (code & 0x0F0FU) << 4U | (code >> 4U & 0x0F0FU);
    return (code & 0x00FFU) << 8U | (code >> 8U & 0x00FFU);
}

} // namespace

class SmallInflater::Bits
{
public:
    explicit Bits(std::span<const std::byte> bytes)
        : m_next(bytes.data())
        , m_end(bytes.data() + bytes.size())
    {
    }

    /// Makes at least 48 bits ready. Past the end of the input they are zeros, and counted.
    void refill()
    {
        if (m_count >= 48) {
            return;
        }
        if (m_end - m_next >= 8) {
            std::uint64_t more;
            std::memcpy(&more, m_next, sizeof(more));
            m_bits |= more << m_count;
            m_next += (63 - m_count) / 8;
            m_count |= 56U;
            return;
        }
        while (m_count <= 56) {
            if (m_next < m_end) {
                m_bits |= static_cast<std::uint64_t>(*m_next++) << m_count;
            } else {
                m_made += 8;
            }
            m_count += 8;
        }
    }

    std::uint32_t peek(unsigned count) const
    {
        return static_cast<std::uint32_t>(m_bits & ((std::uint64_t{1} << count) - 1));
    }
    void drop(unsigned count)
    {
        m_bits >>= count;
        m_count -= count;
    }
    std::uint32_t take(unsigned count)
    {
        const std::uint32_t bits = peek(count);
        drop(count);
        return bits;
    }

    /// Whether more was taken than there is.
    bool isOverrun() const { return m_made > m_count; }

    /// Goes on at the next whole byte; the bytes that were not taken, none when overrun.
    std::span<const std::byte> rest()
    {
        if (isOverrun()) {
            return {};
        }
        m_next -= (m_count - m_made) / 8;
        m_bits = 0;
        m_count = 0;
        m_made = 0;
        return {m_next, m_end};
    }
    void skip(std::size_t bytes) { m_next += bytes; }

private:
    const std::byte* m_next;
    const std::byte* m_end;
    std::uint64_t m_bits = 0;
    unsigned m_count = 0; ///< bits ready
    unsigned m_made = 0;  ///< of which zeros from past the end
};

// False when the lengths make more codes than there is room for, or leave room; only a single code
// of one bit, or none at all, may be incomplete.
bool SmallInflater::makeCode(std::span<const std::uint8_t> lengths, Code& code)
{
    // Most symbols have no code; they are sorted out without a branch and without counting them,
    // since increments of one counter wait for each other.
    std::array<std::uint16_t, kMaxSymbols + 1> symbols;
    std::size_t used = 0;
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
        symbols[used] = static_cast<std::uint16_t>(symbol);
        used += lengths[symbol] != 0 ? 1 : 0;
    }
    code.counts.fill(0);
    for (std::size_t k = 0; k < used; ++k) {
        ++code.counts[lengths[symbols[k]]];
    }
    std::array<std::uint16_t, 17> begins{};
    std::array<std::uint32_t, 17> next{};
    std::uint32_t room = 1U << 15U;
    code.longest = 0;
    for (unsigned length = 1; length <= 15; ++length) {
        const std::uint32_t taken = std::uint32_t{code.counts[length]} << (15 - length);
        if (taken > room) {
            return false;
        }
        room -= taken;
        code.longest = code.counts[length] > 0 ? length : code.longest;
        begins[length + 1] = static_cast<std::uint16_t>(begins[length] + code.counts[length]);
        next[length + 1] = (next[length] + code.counts[length]) << 1U;
    }
    if (room > 0 && !(used == 0 || (used == 1 && code.counts[1] == 1))) {
        return false;
    }
    code.tableBits = std::clamp(code.longest, 1U, kTableBits);
    const std::size_t tableSize = std::size_t{1} << code.tableBits;
    if (room > 0 || code.longest > kTableBits) {
        std::fill_n(code.table.begin(), tableSize, std::uint16_t{0});
    }
    for (std::size_t k = 0; k < used; ++k) {
        const std::uint16_t symbol = symbols[k];
        const unsigned length = lengths[symbol];
        code.symbols[begins[length]++] = symbol;
        const std::uint32_t bits = reversed16(next[length]++) >> (16 - length);
        if (length <= kTableBits) {
            const auto entry = static_cast<std::uint16_t>(std::uint32_t{symbol} << 4U | length);
            for (std::size_t place = bits; place < tableSize; place += std::size_t{1} << length) {
                code.table[place] = entry;
            }
        }
    }
    return true;
}

// The next symbol, or -1 where no code matches. At least 15 bits must be ready.
inline int SmallInflater::decode(const Code& code, Bits& bits)
{
    const std::uint16_t entry = code.table[bits.peek(code.tableBits)];
    if (entry == 0) [[unlikely]] {
        return decodeLong(code, bits);
    }
    bits.drop(entry & 15U);
    return entry >> 4U;
}

// Codes of one length are consecutive numbers, and those of the next length follow on.
int SmallInflater::decodeLong(const Code& code, Bits& bits)
{
    int value = 0;
    int first = 0;
    int index = 0;
    for (unsigned length = 1; length <= code.longest; ++length) {
        value |= static_cast<int>(bits.take(1));
        const int count = code.counts[length];
        if (value - first < count) {
            return code.symbols[static_cast<std::size_t>(index + value - first)];
        }
        index += count;
        first = (first + count) << 1;
        value <<= 1;
    }
    return -1;
}

bool SmallInflater::readCodes(Bits& shared)
{
    Bits bits = shared; // bytes that are stored could change a shared one, as far as compilers know
    bits.refill();
    const std::size_t literals = bits.take(5) + 257;
    const std::size_t distances = bits.take(5) + 1;
    const std::size_t written = bits.take(4) + 4;
    if (literals > 286 || distances > 30) {
        return false;
    }
    std::array<std::uint8_t, 19> lengthLengths{};
    for (std::size_t k = 0; k < written; ++k) {
        bits.refill();
        lengthLengths[kLengthOrder[k]] = static_cast<std::uint8_t>(bits.take(3));
    }
    const bool isSingle = std::ranges::count(lengthLengths, 0) == 18;
    if (isSingle || !makeCode(lengthLengths, m_lengths)) {
        return false;
    }
    std::array<std::uint8_t, 286 + 30> lengths;
    const std::size_t total = literals + distances;
    for (std::size_t k = 0; k < total;) {
        bits.refill();
        const int symbol = decode(m_lengths, bits);
        if (symbol < 0 || bits.isOverrun()) {
            return false;
        }
        if (symbol < 16) {
            lengths[k++] = static_cast<std::uint8_t>(symbol);
            continue;
        }
        if (symbol == 16 && k == 0) {
            return false;
        }
        const std::uint8_t repeated = symbol == 16 ? lengths[k - 1] : std::uint8_t{0};
        const std::size_t run = symbol == 16   ? 3 + bits.take(2)
                                : symbol == 17 ? 3 + bits.take(3)
                                               : 11 + bits.take(7);
        if (run > total - k) {
            return false;
        }
        std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(k), run, repeated);
        k += run;
    }
    shared = bits;
    return lengths[kEndOfBlock] != 0 && makeCode(std::span(lengths).first(literals), m_literals) &&
           makeCode(std::span(lengths).subspan(literals, distances), m_distances);
}

void SmallInflater::setFixedCodes()
{
    std::array<std::uint8_t, kMaxSymbols> literals;
    for (std::size_t k = 0; k < literals.size(); ++k) {
        literals[k] = k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8;
    }
    std::array<std::uint8_t, 32> distances;
    distances.fill(5);
    (void)makeCode(literals, m_literals); // complete by definition
    (void)makeCode(distances, m_distances);
}

bool SmallInflater::copyStored(Bits& bits, std::span<std::byte> out, std::size_t& at)
{
    const std::span<const std::byte> rest = bits.rest();
    if (rest.size() < 4) {
        return false;
    }
    std::uint16_t size;
    std::uint16_t inverse;
    std::memcpy(&size, rest.data(), 2);
    std::memcpy(&inverse, rest.data() + 2, 2);
    if (static_cast<std::uint16_t>(~size) != inverse || size > rest.size() - 4 ||
        size > out.size() - at) {
        return false;
    }
    std::ranges::copy(rest.subspan(4, size), out.begin() + static_cast<std::ptrdiff_t>(at));
    at += size;
    bits.skip(4U + size);
    return true;
}

bool SmallInflater::inflateBlock(Bits& shared, std::span<std::byte> out, std::size_t& end)
{
    Bits bits = shared; // see readCodes
    std::size_t at = end;
    for (;;) {
        bits.refill();
        const int symbol = decode(m_literals, bits);
        if (symbol < 0 || bits.isOverrun()) {
            return false;
        }
        if (symbol < kEndOfBlock) {
            if (at == out.size()) {
                return false;
            }
            out[at++] = static_cast<std::byte>(symbol);
            continue;
        }
        if (symbol == kEndOfBlock) {
            shared = bits;
            end = at;
            return true;
        }
        // Lengths and distances are counted out as RFC 1951, 3.2.5, lists them.
        const auto slot = static_cast<unsigned>(symbol - 257);
        if (slot > 28) {
            return false;
        }
        std::size_t length = 3 + slot;
        if (slot == 28) {
            length = 258;
        } else if (slot >= 8) {
            const unsigned extra = slot / 4 - 1;
            length = 3 + ((4 + slot % 4) << extra) + bits.take(extra);
        }
        bits.refill();
        const int distanceSymbol = decode(m_distances, bits);
        if (distanceSymbol < 0 || distanceSymbol > 29) {
            return false;
        }
        const auto distanceSlot = static_cast<unsigned>(distanceSymbol);
        std::size_t distance = 1 + distanceSlot;
        if (distanceSlot >= 4) {
            const unsigned extra = distanceSlot / 2 - 1;
            distance = 1 + (std::size_t{2 + distanceSlot % 2} << extra) + bits.take(extra);
        }
        if (bits.isOverrun() || distance > at || length > out.size() - at) {
            return false;
        }
        for (std::size_t k = 0; k < length; ++k, ++at) { // may overlap what it writes
            out[at] = out[at - distance];
        }
    }
}

bool SmallInflater::unzip(std::span<const std::byte> zipped, std::span<std::byte> out)
{
    constexpr std::size_t kHeadBytes = 2;
    if (zipped.size() < kHeadBytes) {
        return false;
    }
    const auto method = static_cast<unsigned>(zipped[0]);
    const auto flags = static_cast<unsigned>(zipped[1]);
    const bool hasDictionary = (flags & 0x20U) != 0;
    if ((method & 15U) != 8 || method >> 4U > 7 || (method * 256 + flags) % 31 != 0 ||
        hasDictionary) {
        return false;
    }
    Bits bits(zipped.subspan(kHeadBytes));
    std::size_t at = 0;
    for (bool isLast = false; !isLast;) {
        bits.refill();
        isLast = bits.take(1) != 0;
        const std::uint32_t kind = bits.take(2);
        bool sound = false;
        if (kind == 0) {
            sound = copyStored(bits, out, at);
        } else if (kind == 1) {
            setFixedCodes();
            sound = inflateBlock(bits, out, at);
        } else if (kind == 2) {
            sound = readCodes(bits) && inflateBlock(bits, out, at);
        }
        if (!sound || bits.isOverrun()) {
            return false;
        }
    }
    const std::span<const std::byte> rest = bits.rest();
    if (at != out.size() || rest.size() < 4) {
        return false;
    }
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        sum = sum << 8U | static_cast<std::uint32_t>(rest[k]);
    }
    return sum == libdeflate_adler32(1, out.data(), out.size());
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/byte_scanner.h"
#include "core/mesh/ply_header.h"
#include "core/mesh/text_scanner.h"

#include <cmath>
#include <limits>
#include <optional>

namespace trixel {

// The values of a PLY file one after the other, from text or from binary data. Both sources have
// the same functions; a value that is missing or wrong is nothing, and `expected` then says what
// stood there.

class PlyTextSource
{
public:
    PlyTextSource(std::string_view data, std::size_t firstLine)
        : m_scanner(data, firstLine)
    {
    }

    static std::size_t leastBytes(const PlyProperty& /*property*/) { return 2; } // "0 "
    static std::size_t leastBytes(PlyType /*type*/) { return 2; }

    /// Bytes left, and one for the last line's end, which may be missing.
    std::size_t room() const { return m_scanner.rest().size() + 1; }

    void beginRow()
    {
        m_scanner.skipEmptyLines();
        m_before = m_scanner;
    }
    Status endRow()
    {
        if (!m_scanner.atLineEnd()) {
            return m_scanner.expected("the end of the line");
        }
        m_scanner.skipLine();
        return {};
    }

    std::optional<float> coordinate(PlyType /*type*/)
    {
        m_before = m_scanner;
        return m_scanner.finiteFloat();
    }
    /// NaN for a number that is not finite or does not fit a float.
    std::optional<float> anyNumber(PlyType type)
    {
        if (const auto value = coordinate(type)) {
            return value;
        }
        m_scanner = m_before;
        return m_scanner.skipNumber() ? std::optional(std::numeric_limits<float>::quiet_NaN())
                                      : std::nullopt;
    }
    std::optional<std::int64_t> integer(PlyType /*type*/)
    {
        m_before = m_scanner;
        return m_scanner.integer();
    }
    bool skip(PlyType /*type*/, std::size_t count)
    {
        bool numbers = true;
        for (std::size_t i = 0; i < count && numbers; ++i) {
            m_before = m_scanner;
            numbers = m_scanner.skipNumber();
        }
        return numbers;
    }

    /// About the value read last.
    tl::unexpected<Error> expected(const std::string& what) { return m_before.expected(what); }

    Status expectEnd()
    {
        return m_scanner.skipEmptyLines() ? Status(m_scanner.expected("the end of the file"))
                                          : Status();
    }

private:
    TextScanner m_scanner;
    TextScanner m_before = m_scanner;
};

class PlyBinarySource
{
public:
    PlyBinarySource(std::string_view data, std::endian order, std::size_t firstOffset)
        : m_scanner(data, order, firstOffset)
    {
    }

    static std::size_t leastBytes(const PlyProperty& property)
    {
        return byteSizeOf(property.listLengthType.value_or(property.type));
    }
    static std::size_t leastBytes(PlyType type) { return byteSizeOf(type); }

    std::size_t room() const { return m_scanner.left(); }

    void beginRow() {}
    Status endRow() { return {}; }

    std::optional<float> coordinate(PlyType type)
    {
        const auto value = number<double>(type);
        if (!value || !(std::abs(*value) <= double{std::numeric_limits<float>::max()})) {
            return std::nullopt;
        }
        return static_cast<float>(*value);
    }
    std::optional<float> anyNumber(PlyType type)
    {
        const auto value = number<double>(type);
        if (!value) {
            return std::nullopt;
        }
        const bool fits = std::abs(*value) <= double{std::numeric_limits<float>::max()};
        return fits ? static_cast<float>(*value) : std::numeric_limits<float>::quiet_NaN();
    }
    std::optional<std::int64_t> integer(PlyType type) { return number<std::int64_t>(type); }
    bool skip(PlyType type, std::size_t count)
    {
        m_lastType.reset();
        m_last = m_scanner;
        if (count > m_scanner.left() / byteSizeOf(type)) {
            return false;
        }
        m_scanner.skip(count * byteSizeOf(type));
        return true;
    }

    tl::unexpected<Error> expected(const std::string& what)
    {
        return m_last.expected(what, found());
    }

    Status expectEnd()
    {
        if (m_scanner.left() > 0) {
            return m_scanner.expected("the end of the file",
                                      std::to_string(m_scanner.left()) + " bytes more");
        }
        return {};
    }

private:
    template <class Number, class Stored>
    std::optional<Number> numberAs()
    {
        return m_scanner.has(sizeof(Stored))
                   ? std::optional(static_cast<Number>(m_scanner.read<Stored>()))
                   : std::nullopt;
    }

    template <class Number>
    std::optional<Number> number(PlyType type)
    {
        m_lastType = type;
        m_last = m_scanner;
        switch (type) {
        case PlyType::Int8:
            return numberAs<Number, std::int8_t>();
        case PlyType::Uint8:
            return numberAs<Number, std::uint8_t>();
        case PlyType::Int16:
            return numberAs<Number, std::int16_t>();
        case PlyType::Uint16:
            return numberAs<Number, std::uint16_t>();
        case PlyType::Int32:
            return numberAs<Number, std::int32_t>();
        case PlyType::Uint32:
            return numberAs<Number, std::uint32_t>();
        case PlyType::Float:
            return numberAs<Number, float>();
        case PlyType::Double:
            return numberAs<Number, double>();
        }
        return std::nullopt;
    }

    // What stood where the last value was read.
    std::string found()
    {
        m_scanner = m_last;
        const auto value = m_lastType ? number<double>(*m_lastType) : std::nullopt;
        if (!value) {
            return "the end of the file";
        }
        const bool isWhole = *value == std::floor(*value) && std::abs(*value) < 1e15;
        return isWhole ? std::to_string(static_cast<std::int64_t>(*value)) : std::to_string(*value);
    }

    ByteScanner m_scanner;
    ByteScanner m_last = m_scanner;
    std::optional<PlyType> m_lastType; // nothing where values were skipped
};

} // namespace trixel

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
        const auto value = number(type);
        if (!value || std::abs(*value) > std::numeric_limits<float>::max() || std::isnan(*value)) {
            return std::nullopt;
        }
        return static_cast<float>(*value);
    }
    std::optional<std::int64_t> integer(PlyType type)
    {
        const auto value = number(type);
        return value ? std::optional(static_cast<std::int64_t>(*value)) : std::nullopt;
    }
    bool skip(PlyType type, std::size_t count)
    {
        m_offset = m_scanner.offset();
        m_last.reset();
        if (count > m_scanner.left() / byteSizeOf(type)) {
            return false;
        }
        m_scanner.skip(count * byteSizeOf(type));
        return true;
    }

    tl::unexpected<Error> expected(const std::string& what);

    Status expectEnd()
    {
        if (m_scanner.left() > 0) {
            return m_scanner.expected("the end of the file",
                                      std::to_string(m_scanner.left()) + " bytes more");
        }
        return {};
    }

private:
    template <class T>
    std::optional<double> numberAs()
    {
        m_offset = m_scanner.offset();
        m_last.reset();
        if (m_scanner.has(sizeof(T))) {
            m_last = static_cast<double>(m_scanner.read<T>());
        }
        return m_last;
    }
    std::optional<double> number(PlyType type);

    ByteScanner m_scanner;
    std::size_t m_offset = 0;
    std::optional<double> m_last; // nothing where the file ended
};

inline std::optional<double> PlyBinarySource::number(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
        return numberAs<std::int8_t>();
    case PlyType::Uint8:
        return numberAs<std::uint8_t>();
    case PlyType::Int16:
        return numberAs<std::int16_t>();
    case PlyType::Uint16:
        return numberAs<std::uint16_t>();
    case PlyType::Int32:
        return numberAs<std::int32_t>();
    case PlyType::Uint32:
        return numberAs<std::uint32_t>();
    case PlyType::Float:
        return numberAs<float>();
    case PlyType::Double:
        return numberAs<double>();
    }
    return std::nullopt;
}

inline tl::unexpected<Error> PlyBinarySource::expected(const std::string& what)
{
    std::string found = "the end of the file";
    if (m_last) {
        const bool whole = *m_last == std::floor(*m_last) && std::abs(*m_last) < 1e15;
        found =
            whole ? std::to_string(static_cast<std::int64_t>(*m_last)) : std::to_string(*m_last);
    }
    return ByteScanner::expectedAt(m_offset, what, found);
}

} // namespace trixel

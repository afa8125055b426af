// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace trixel {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

/// Bytes of a value in a binary file.
std::size_t byteSizeOf(PlyType type);

constexpr bool isInteger(PlyType type)
{
    return type != PlyType::Float && type != PlyType::Double;
}

struct PlyProperty
{
    std::string_view name;
    PlyType type = PlyType::Float;         ///< of the value, or of a list's values
    std::optional<PlyType> listLengthType; ///< an integer type; nothing for a single value
    std::size_t line = 0;                  ///< of the header

    bool isList() const { return listLengthType.has_value(); }
};

struct PlyElement
{
    std::string_view name;
    std::size_t rows = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0; ///< of the header
};

/// What a PLY file says about itself. Refers to the text it was parsed from.
struct PlyHeader
{
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements; ///< in the order of their data
    std::string_view data;            ///< all that follows the header
    std::size_t dataLine = 0;         ///< number of the data's first line
};

/// Checks the header as such; what a mesh needs is for the reader to check.
Result<PlyHeader> parsePlyHeader(std::string_view bytes);

} // namespace trixel

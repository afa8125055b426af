// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace trixel {

/// What a line of an OBJ file is about.
enum class ObjStatement : std::uint8_t { Vertex, Texture, Normal, Face, Tag, Skipped, Unknown };

/// By the line's first word. Words of two letters and more that the specification does not know are
/// skipped, as they are by other programs.
ObjStatement objStatementOf(std::string_view keyword);

} // namespace trixel

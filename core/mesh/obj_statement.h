// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace trixel {

/// What a line of an OBJ file is about.
enum class ObjStatement : std::uint8_t { Vertex, Texture, Normal, Face, Skipped, Unknown };

/// By the line's first word.
ObjStatement objStatementOf(std::string_view keyword);

} // namespace trixel

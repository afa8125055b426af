// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mesh/text_scanner.h"

#include <cstddef>

namespace trixel {

/// First word of an OFF file: [ST][C][N]OFF, perhaps followed by BINARY.
struct OffHeader
{
    bool textureCoordinates = false; ///< two numbers more a vertex
    bool colours = false;            ///< up to four numbers more a vertex
    bool normals = false;            ///< three numbers more a vertex
    bool binary = false;             ///< the counts follow in binary, on the next line
};

/// Reads the header's words, if there are any, and leaves the scanner behind them; for a binary
/// file at its data.
Result<OffHeader> parseOffHeader(TextScanner& scanner);

} // namespace trixel

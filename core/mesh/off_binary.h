// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/mesh/off_header.h"
#include "core/mesh/triangle_mesh.h"

namespace trixel {

/// Data of a binary OFF file. Geomview, whose format it is, writes big-endian, four floats a colour
/// and a counted colour after each face; OpenMesh writes little-endian, three or four integers a
/// colour or none, and no count. The layout that uses up the file exactly is taken.
/// \param offset  of the data in its file, for messages
Result<TriangleMesh> parseBinaryOff(const OffHeader& header,
                                    std::string_view data,
                                    std::size_t offset,
                                    Progress& progress);

} // namespace trixel

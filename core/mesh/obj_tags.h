// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tags of subdivision in OBJ files: "t crease 2/1/0 4 7 2.5", "t corner 1/1/0 4 10". After the name
// come how many integers, numbers and words follow; vertices are counted from 0, unlike those of
// faces. OpenSubdiv's shapes and several exporters write them.
#pragma once

#include "core/base/result.h"
#include "core/mesh/text_scanner.h"
#include "core/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace trixel {

/// What the tags of some lines say, in their order, and where.
struct ObjTags
{
    Sharpness sharpness;
    std::vector<std::size_t> creaseLines; ///< one a crease
};

/// Reads a tag from behind the 't' to the end of its line. Creases are of two vertices and one
/// sharpness, corners of one vertex and one sharpness; sharpness is 0 or more, above kSharp it
/// counts as that. Tags of other names are skipped, if as much follows as they say.
/// Fails with the line, what was expected and what was found.
/// \param vertexCount  of the whole file
Status readObjTag(TextScanner& scanner, std::int64_t vertexCount, ObjTags& tags);

/// What tags say together of a mesh: where they speak of the same edge or vertex, the last one
/// counts; what is not sharp is left out. Fails, naming the line, on a crease between vertices that
/// share no edge.
/// \param parts  in the order of the file
Result<Sharpness> gatherTags(const TriangleMesh& mesh, std::span<const ObjTags> parts);

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mapping/mapping.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace trixel {

/// A tile of an image that is spread over several files: 1001 is the unit square, 1002 the one to
/// its right, 1011 the one above it; ten in a row.
struct UdimTile
{
    int column = 0; ///< [0, 9]
    int row = 0;    ///< >= 0

    int number() const { return 1001 + column + 10 * row; }
    bool operator==(const UdimTile&) const = default;
    auto operator<=>(const UdimTile&) const = default;
};

/// The tile of a number; nothing for one outside 1001 to 9999.
std::optional<UdimTile> udimTile(int number);
/// The tile that a point lies in; nothing where there can be none.
std::optional<UdimTile> udimTileAt(glm::dvec2 st);

/// The tiles that the box of a face's uvs reaches into by more than rounding; nothing where no
/// tiles could be.
std::optional<std::vector<UdimTile>> tilesOfFace(const std::array<glm::vec2, 3>& uvs);

/// By the mesh's own uvs. Faces without are not reached.
class UvMapping final : public Mapping
{
public:
    /// The mesh has uvs (checked) and outlives this.
    explicit UvMapping(const TriangleMesh& mesh);

    ImagePlace at(FaceId face, glm::dvec2 uv, double step) const override;

private:
    const TriangleMesh& m_mesh;
};

/// Fails, in one sentence that names the first face at fault, if uvs are missing, if all of them
/// are without area, or if they reach beyond what is there.
/// \param tiles    that there is an image for; one of number 1001 for a single image
/// \param repeats  a single image goes on in all directions: nothing is beyond it
Status checkUvs(const TriangleMesh& mesh, const std::vector<UdimTile>& tiles, bool repeats);

} // namespace trixel

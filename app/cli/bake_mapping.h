// SPDX-License-Identifier: GPL-3.0-or-later
//
// How `bake` lays an image onto the mesh, as its options say.
#pragma once

#include "app/cli/bake_images.h"
#include "core/mapping/mapping.h"
#include "core/mesh/surface.h"

#include <memory>
#include <optional>
#include <string>

namespace trixel::app {

struct BakeMappingArguments
{
    std::string name = "uv";
    std::optional<std::string> origin, right, up; ///< planar
    std::optional<std::string> centre;            ///< sphere
    std::string turn = "0";                       ///< sphere
    std::string axis = "0,1,0";                   ///< sphere
    std::optional<std::string> corners;           ///< quad
    std::optional<std::string> cameras, camera;   ///< camera
    bool frontOnly = false;                       ///< planar, quad
    bool visibleOnly = false;                     ///< planar, quad
    bool everything = false;                      ///< camera
};

void addMappingOptions(CLI::App& verb, BakeMappingArguments& arguments);

/// Refuses what is unusable before anything is read.
Result<MappingKind> mappingKind(const BakeMappingArguments& arguments);

/// Whether the uvs can be checked is another matter (`checkUvs`): that takes the images' tiles.
/// \param surface  outlives the mapping
Result<std::unique_ptr<const Mapping>>
makeMapping(MappingKind kind, const BakeMappingArguments& arguments, const Surface& surface);

} // namespace trixel::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/level.h"
#include "core/base/result.h"
#include "core/layers/layer.h"
#include "core/texture/texel_format.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace trixel {

/// What a .ptx holds, told without reading a single texel.
struct PtxSummary
{
    struct Item
    {
        std::string key;
        std::uint8_t type = 0;   ///< 0 string, 1 int8, 2 int16, 3 int32, 4 float, 5 double
        std::uint64_t count = 0; ///< values; of a string, its bytes
        std::string text;        ///< the value of a string
    };

    TexelFormat format; ///< of what is shown: of a project with layers, that of its base
    std::vector<LayerSettings> layers; ///< bottom to top
    std::uint32_t faceCount = 0;
    int levelCount = 0; ///< stored levels; 1 without reductions
    std::array<std::uint32_t, Level::kMax + 1> facesOfLevel{};
    std::uint32_t constantFaces = 0;
    std::uint32_t editedFaces = 0; ///< replaced by edits appended to the file
    std::uint64_t texelCount = 0;  ///< 4^n a face, constant or not
    std::uint64_t fileBytes = 0;
    std::uint64_t texelBytes = 0; ///< in memory, constant faces as one texel; with all layers
    std::vector<Item> metadata;
    bool carriesMesh = false; ///< the metadata have the mesh
    bool isProject = false;   ///< the metadata make it a .trixel project
};

/// Errors name the file, the place in it, what was expected and what was found.
Result<PtxSummary> summarisePtx(const std::filesystem::path& path);

} // namespace trixel

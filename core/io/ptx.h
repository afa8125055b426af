// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading and writing .ptx (Ptex) files of triangle meshes.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_store.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace trixel {

/// One metadata item; the alternative held is its Ptex type (0 string … 5 double).
struct PtxMetadata
{
    using Value = std::variant<std::string,
                               std::vector<std::int8_t>,
                               std::vector<std::int16_t>,
                               std::vector<std::int32_t>,
                               std::vector<float>,
                               std::vector<double>>;
    std::string key; ///< 1 to 254 characters
    Value value;

    bool operator==(const PtxMetadata&) const = default;
};

/// What a .ptx of a triangle mesh holds, at full resolution, edits folded in.
struct PtxContents
{
    TexelStore texels;
    Adjacency adjacency;
    std::vector<PtxMetadata> metadata;
    bool hasMips = true; ///< whether reduced levels were stored
};

struct PtxWriteOptions
{
    bool mips = true;
    Threads threads = Threads::all();
};

/// Reads a whole file; every byte is checked before it is used.
Result<PtxContents> readPtx(const std::filesystem::path& path, Progress& progress);
Result<PtxContents> parsePtx(std::string_view bytes, Progress& progress);

/// Writes a file through `commitFile`: what was written is read again and compared before it takes
/// its name. Identical contents give identical bytes, whatever the number of threads.
Status writePtx(const std::filesystem::path& path,
                const PtxContents& contents,
                const PtxWriteOptions& options,
                Progress& progress);

} // namespace trixel

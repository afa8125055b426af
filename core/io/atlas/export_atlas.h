// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces as images that other programs read: packed to the bit, or sampled anew for plain uvs. All
// files of an export take their names together at its end.
#pragma once

#include "core/atlas/handoff_layout.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/image/color_space.h"
#include "core/io/image/image_worker.h"
#include "core/io/project.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trixel {

/// What both kinds of atlas have in common.
struct AtlasImageOptions
{
    /// Of the pages; empty for the one that holds the texels' and that the file can hold.
    std::optional<TexelType> type;
    /// What each channel means; empty for what the project says (`channelColors`), and if it does
    /// not, sRGB where the texels are integers, linear where not.
    std::vector<ColorSpace> colors;
    Threads threads = Threads::all();
};

struct PackedExportOptions
{
    AtlasOptions layout;
    AtlasImageOptions image;
};

struct HandOffExportOptions
{
    HandOffOptions layout;
    AtlasImageOptions image;
    /// What a sample is: the value of this method where the footprint is a point.
    MethodChoice method{"exact", std::nullopt};
    /// Ending of the textures beside a mesh: "png", "tif" or "exr". A .glb has PNG in it.
    std::string imageEnding = "png";
};

/// What will be written, to be shown before.
struct AtlasEstimate
{
    std::vector<AtlasPage> pages;
    std::vector<std::string> files; ///< in the order they are written
    TexelFormat format;             ///< of the pages
    double occupancy = 1;           ///< useful pixels in parts of all
    /// The same in the other packing (bands or shelves); packed atlases only.
    std::optional<double> otherOccupancy;

    std::uint64_t pixels() const;
    /// In memory; what the file takes depends on how well it compresses.
    std::uint64_t bytes() const { return pixels() * format.texelBytes(); }
};

/// A packed atlas as it is planned: to be told of, and then written, without planning twice.
/// Writes NAME.exr, .tif or .png (NAME.0, NAME.1 … where there are several pages), NAME.json with
/// what a shader needs and what `readPackedAtlas` needs, NAME.glsl with the address function.
class PackedExport
{
public:
    /// Errors: those of the arguments. The project is kept, as a cheap copy.
    static Result<PackedExport> plan(const std::filesystem::path& path,
                                     const Project& project,
                                     const PackedExportOptions& options);

    /// The other packing is planned for this, too.
    AtlasEstimate estimate() const;
    /// In the order they are written.
    std::vector<std::string> files() const;

    /// Errors name the file; nothing that was there is touched then, nor when it is cancelled.
    Status write(const ImageWorker& worker, Progress& progress) const;

private:
    struct Plan;
    explicit PackedExport(std::shared_ptr<const Plan> plan);

    std::shared_ptr<const Plan> m_plan;
};

/// What `exportPackedAtlas` would write. Errors: those of its arguments.
Result<AtlasEstimate> estimatePackedAtlas(const std::filesystem::path& path,
                                          const Project& project,
                                          const PackedExportOptions& options);

/// Plans a packed atlas and writes it.
Status exportPackedAtlas(const ImageWorker& worker,
                         const std::filesystem::path& path,
                         const Project& project,
                         const PackedExportOptions& options,
                         Progress& progress);

/// What a packed atlas holds.
struct ReadAtlas
{
    TexelStore texels;              ///< of the type they had when it was written
    std::vector<ColorSpace> colors; ///< what each channel means
};

/// Takes the faces of a packed atlas back.
/// \param path  of its JSON file. Errors name the file and the place.
Result<ReadAtlas> readPackedAtlas(const ImageWorker& worker,
                                  const std::filesystem::path& path,
                                  Threads threads,
                                  Progress& progress);

/// Of an export that is done.
struct HandOffOutcome
{
    double largestJump = 0; ///< see `HandOffReport`
};

/// A mesh with uvs and the textures it wears, as it is planned: to be told of, and then written,
/// without planning twice. Writes NAME.glb with all in it, NAME.obj with NAME.mtl and textures, or
/// NAME.ply (one page only) with its texture. In a .glb colours are sRGB, whatever they are in the
/// project: glTF takes base colours for nothing else. Raw channels pass.
class HandOffExport
{
public:
    /// Errors: those of the arguments. The project is kept, as a cheap copy.
    static Result<HandOffExport> plan(const std::filesystem::path& path,
                                      const Project& project,
                                      const HandOffExportOptions& options);

    AtlasEstimate estimate() const;
    /// In the order they are written.
    std::vector<std::string> files() const;

    /// Errors name the file; nothing that was there is touched then, nor when it is cancelled.
    Result<HandOffOutcome> write(const ImageWorker& worker, Progress& progress) const;

private:
    struct Plan;
    explicit HandOffExport(std::shared_ptr<const Plan> plan);

    std::shared_ptr<const Plan> m_plan;
};

/// What `exportHandOff` would write.
Result<AtlasEstimate> estimateHandOff(const std::filesystem::path& path,
                                      const Project& project,
                                      const HandOffExportOptions& options);

/// Plans a hand-off and writes it.
Result<HandOffOutcome> exportHandOff(const ImageWorker& worker,
                                     const std::filesystem::path& path,
                                     const Project& project,
                                     const HandOffExportOptions& options,
                                     Progress& progress);

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the exports of both kinds of atlas share.
#pragma once

#include "core/io/atlas/export_atlas.h"
#include "core/io/image/write_image.h"
#include "core/io/staged_files.h"

namespace trixel {

/// In small letters, without the dot.
std::string endingOf(const std::filesystem::path& path);

/// The type of pages that hold texels of a type in a file of an ending: the least that loses
/// nothing, or what comes nearest to it (PNG has no floats: they become uint16).
TexelType pageType(const std::string& ending, TexelType texels);

/// The format of pages and what their channels mean.
struct PageKind
{
    TexelFormat format;
    std::vector<ColorSpace> colors;
};
/// Colours are those of the options; else what the project says of its channels; else sRGB where
/// the texels are integers, linear where not. Fails if there are some for another number of
/// channels.
Result<PageKind>
pageKind(const std::string& ending, const Project& project, const AtlasImageOptions& options);

/// STEM.ending, or STEM.0.ending, STEM.1.ending … of several.
std::vector<std::string>
pageNames(const std::string& stem, const std::string& ending, std::size_t count);

/// Fails, in the words of `checkImageTarget`, if such pages cannot be written.
Status checkPages(const std::filesystem::path& folder,
                  const std::vector<std::string>& names,
                  std::span<const AtlasPage> pages,
                  const TexelFormat& format);

/// Fails, naming it, if one of the files must not be replaced.
Status checkReplaceable(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Writes each image to its path.
Status writePages(const ImageWorker& worker,
                  const std::vector<std::filesystem::path>& paths,
                  std::span<const Image> pages,
                  const ImageWriteOptions& options,
                  Progress& progress);

/// Writes a text as a file.
Status writeText(const std::filesystem::path& path, std::string_view text);

} // namespace trixel

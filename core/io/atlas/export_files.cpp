// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/atlas/export_files.h"

#include "core/io/channel_colors.h"
#include "core/io/commit_file.h"

#include <algorithm>
#include <cctype>

namespace trixel {

std::uint64_t AtlasEstimate::pixels() const
{
    std::uint64_t sum = 0;
    for (const AtlasPage& page : pages) {
        sum += std::uint64_t{page.width} * page.height;
    }
    return sum;
}

std::string endingOf(const std::filesystem::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(
        ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending.empty() ? ending : ending.substr(1);
}

TexelType pageType(const std::string& ending, TexelType texels)
{
    if (ending == "png") {
        return texels == TexelType::UInt8 ? TexelType::UInt8 : TexelType::UInt16;
    }
    if (ending == "exr") {
        const bool isShort = texels == TexelType::UInt8 || texels == TexelType::Half;
        return isShort ? TexelType::Half : TexelType::Float;
    }
    return texels == TexelType::Half ? TexelType::Float : texels;
}

Result<PageKind>
pageKind(const std::string& ending, const Project& project, const AtlasImageOptions& options)
{
    const TexelFormat& texels = project.texels.format();
    PageKind kind{texels, options.colors};
    kind.format.type = options.type.value_or(pageType(ending, texels.type));
    if (kind.colors.empty()) {
        const bool integers = texels.type == TexelType::UInt8 || texels.type == TexelType::UInt16;
        kind.colors = channelColors(project).value_or(uniformColors(
            integers ? ColorSpace::SRgb : ColorSpace::Linear, texels.channels, texels.alpha));
    }
    if (kind.colors.size() != texels.channels) {
        return contentsError("expected a colour space for each of " +
                             std::to_string(texels.channels) + " channels, found " +
                             std::to_string(kind.colors.size()));
    }
    return kind;
}

std::vector<std::string>
pageNames(const std::string& stem, const std::string& ending, std::size_t count)
{
    std::vector<std::string> names;
    for (std::size_t k = 0; k < count; ++k) {
        std::string name = stem;
        if (count > 1) {
            name.append(".").append(std::to_string(k));
        }
        names.push_back(name.append(".").append(ending));
    }
    return names;
}

Status checkPages(const std::filesystem::path& folder,
                  const std::vector<std::string>& names,
                  std::span<const AtlasPage> pages,
                  const TexelFormat& format)
{
    for (std::size_t k = 0; k < pages.size(); ++k) {
        if (Status usable =
                checkImageTarget(folder / names[k], format, pages[k].width, pages[k].height, false);
            !usable) {
            return usable;
        }
    }
    return {};
}

Status checkReplaceable(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
    for (const std::string& name : names) {
        if (Status free = checkReplaceable(folder / name); !free) {
            return free;
        }
    }
    return {};
}

Status writePages(const ImageWorker& worker,
                  const std::vector<std::filesystem::path>& paths,
                  std::span<const Image> pages,
                  const ImageWriteOptions& options,
                  Progress& progress)
{
    for (std::size_t k = 0; k < pages.size(); ++k) {
        const auto part = [&](std::size_t done) {
            return static_cast<double>(done) / static_cast<double>(pages.size());
        };
        StageProgress stage(progress, part(k), part(k + 1));
        if (Status written = writeImage(worker, paths[k], pages.subspan(k, 1), options, stage);
            !written) {
            return written;
        }
    }
    return {};
}

Status writeText(const std::filesystem::path& path, std::string_view text)
{
    return commitFile(
        path,
        [&](FileWriter& file) { return file.write(text); },
        [](const std::filesystem::path&) { return Status(); });
}

} // namespace trixel

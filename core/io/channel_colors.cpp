// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/channel_colors.h"

#include "core/base/check.h"
#include "core/io/ptx_metadata.h"

#include <string>
#include <variant>

namespace trixel {

namespace {

constexpr const char* kChannelColorsKey = "TrixelChannelColors";

} // namespace

std::optional<std::vector<ColorSpace>> channelColors(const Project& project)
{
    const PtxMetadata* item = findMetadata(project.metadata, kChannelColorsKey);
    const auto* text = item ? std::get_if<std::string>(&item->value) : nullptr;
    auto colors = text ? colorSpacesFromText(*text) : std::nullopt;
    const bool fits = colors && colors->size() == project.texels.format().channels;
    return fits ? std::move(colors) : std::nullopt;
}

void forgetChannelColors(Project& project)
{
    removeMetadata(project.metadata, kChannelColorsKey);
}

void declareChannelColors(Project& project, const std::vector<ColorSpace>& colors)
{
    check(colors.size() == project.texels.format().channels, "a colour space for each channel");
    forgetChannelColors(project);
    project.metadata.push_back({kChannelColorsKey, toText(colors)});
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/color_space.h"
#include "core/io/project.h"

#include <optional>
#include <vector>

namespace trixel {

/// What a project says its channels mean, one each; nothing where it does not say, and its numbers
/// are taken as they are.
std::optional<std::vector<ColorSpace>> channelColors(const Project& project);

/// Of a project whose channels are no longer those that were declared.
void forgetChannelColors(Project& project);

/// \param colors  one for each channel (checked); they go into the project's metadata
void declareChannelColors(Project& project, const std::vector<ColorSpace>& colors);

} // namespace trixel

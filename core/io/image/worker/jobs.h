// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two jobs of the worker. Both throw std::runtime_error with a sentence on what is wrong.
#pragma once

#include <nlohmann/json.hpp>

namespace trixel::worker {

/// Reads kInputDescriptor into kOutputDescriptor, whose size it sets, and answers width, height,
/// type, channels, alpha (-1 for none) and colors.
/// \param job  reader, fileBytes, coarserLevels (sizes), keepsAlpha (colours stay multiplied by
/// opacity), limits
nlohmann::json decodeImage(const nlohmann::json& job);

/// Encodes the pixels of kInputDescriptor into the file kOutputDescriptor.
/// \param job  writer, levels (width and height of each), type, channels, alpha, names, colors,
///             tile (0 for rows), texture, compression, threads
nlohmann::json encodeImage(const nlohmann::json& job);

} // namespace trixel::worker

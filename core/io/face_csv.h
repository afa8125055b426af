// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of faces as text.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/face_filter.h"

#include <filesystem>
#include <span>
#include <string>

namespace trixel {

/// The names of the columns, a line.
std::string faceTableHeader(char separator);

/// Adds one face as a line: numbers as short as they can be read back exactly, constant as 1 or 0,
/// nothing where nothing is known.
void appendFaceRow(std::string& text, const FaceFacts& facts, FaceId face, char separator);

/// Writes faces as comma-separated values, a header line first. The file is whole or not there.
/// Errors: cancelled; the file (Path).
Status writeFaceCsv(const FaceFacts& facts,
                    std::span<const FaceId> faces,
                    const std::filesystem::path& path,
                    Progress& progress);

} // namespace trixel

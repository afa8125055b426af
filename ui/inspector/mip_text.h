// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/io/ptx_reductions.h"
#include "core/texture/mip_comparison.h"

#include <span>

namespace trixel::ui {

class MipFocus;

/// The words and numbers of the panel of mips.

QString levelText(Level level);      ///< "Level 5"
QString resolutionText(Level level); ///< "32 × 32"
QString texelCountText(Level level); ///< "1,024"
QString texelText(TexelCoord texel); ///< "(3, 1) upper"

/// How the level is kept in a .ptx; there is a face. "stored", "computed", "average", "constant".
QString keepingText(PtxKeeping keeping);
/// One sentence on what that means.
QString keepingTip(PtxKeeping keeping);
PtxKeeping keepingOf(const MipFocus& focus, Level level);

/// Bytes that the project's texels take at the level: the stores keep a face's own level only.
std::uint64_t memoryBytes(const MipFocus& focus, Level level);
QString bytesText(double bytes); ///< "3.1 kB"
/// Of the level's block; "…" until it is measured.
QString fileBytesText(const MipFocus& focus, Level level);

/// Box less right, a channel a number in stored units: "+3  -1  0".
QString differenceText(TexelType type, std::span<const float> right, std::span<const float> box);
/// The same in parts of 255, of the channel that differs most: "+1.33".
QString partsText(double difference);

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that a worker finds open when it begins. Its only argument is the job as JSON.
#pragma once

namespace trixel {

inline constexpr int kInputDescriptor = 3;  ///< the image file, or the pixels to encode
inline constexpr int kOutputDescriptor = 4; ///< memory for the pixels, or for the encoded file
inline constexpr int kReplyDescriptor = 5;  ///< the answer as JSON
inline constexpr int kFirstFreeDescriptor = 6;

} // namespace trixel

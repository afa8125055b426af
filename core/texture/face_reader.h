// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/base/level.h"
#include "core/base/result.h"

#include <cstddef>
#include <span>

namespace trixel {

/// Reads single faces from where they lie, a file as a rule. Called from several threads at once.
class FaceReader
{
public:
    virtual ~FaceReader() = default;

    /// Fills in the texels of a face at its own level, or at a coarser one as it is stored.
    /// \param texels  4^n texels of that level, in packed order
    /// \return        false if the level is not stored; a face's own level always is. Errors are
    ///                whole sentences that name the file, the face and the cause; what `texels`
    ///                then holds is unspecified.
    virtual Result<bool> read(FaceId face, Level level, std::span<std::byte> texels) const = 0;

    /// Whether `read` would find a coarser level stored; costs nothing.
    virtual bool stores(FaceId face, Level level) const = 0;

    /// One texel: the mean of the face as the file keeps it. Valid as long as the reader.
    virtual std::span<const std::byte> mean(FaceId face) const = 0;
};

} // namespace trixel

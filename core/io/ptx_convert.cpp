// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_convert.h"

#include "core/io/ptx.h"
#include "core/texture/convert.h"

namespace trixel {

Status convertPtx(const std::filesystem::path& from,
                  const std::filesystem::path& to,
                  const PtxConvertOptions& options,
                  Progress& progress)
{
    StageProgress reading(progress, 0, 0.3);
    auto contents = readPtx(from, reading);
    if (!contents) {
        return tl::unexpected(contents.error());
    }
    if (options.type) {
        StageProgress converting(progress, 0.3, 0.4);
        auto texels = converted(contents->texels, *options.type, Threads::all(), converting);
        if (!texels) {
            return tl::unexpected(texels.error());
        }
        contents->texels = std::move(*texels);
    }
    StageProgress writing(progress, 0.4, 1);
    return writePtx(to, *contents, {.mips = options.mips}, writing);
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/open_paint.h"

#include "core/io/layered_texels.h"
#include "core/io/layers_metadata.h"
#include "core/layers/compose.h"

#include <utility>

namespace trixel {

Result<OpenedPaint> openPaint(PtxFile file,
                              const std::string& name,
                              std::span<const PtxMetadata> metadata,
                              const OpenOptions& options,
                              MemoryBudget& budget,
                              Progress& progress)
{
    auto settings = layersOf(metadata);
    if (!settings) {
        return tl::unexpected(settings.error());
    }
    if (settings->empty()) {
        return openTexels(std::move(file), name, options, budget, progress)
            .map([](OpenedTexels&& opened) {
                return OpenedPaint{std::move(opened.texels), std::move(opened.faces), {}};
            });
    }
    StageProgress reading(progress, 0, 0.7);
    auto layers = readLayers(file, std::move(*settings), budget, Threads::all(), reading);
    if (!layers) {
        return tl::unexpected(layers.error());
    }
    StageProgress composing(progress, 0.7, 1);
    return composed(std::move(*layers), Threads::all(), composing).map([](Layered&& layered) {
        return OpenedPaint{std::move(layered.shown), nullptr, std::move(layered.layers)};
    });
}

} // namespace trixel

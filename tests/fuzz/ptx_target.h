// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/layered_texels.h"
#include "core/io/layers_metadata.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_reader.h"
#include "core/io/ptx_stored_faces.h"

#include <string_view>

namespace trixel {

/// Reads every face when it is asked for, the coarser levels first.
inline void readPtxFaceByFace(std::string_view bytes, std::uint64_t most)
{
    MemoryBudget budget(most);
    auto file = PtxFile::open(memorySource(bytes), budget);
    if (!file) {
        return;
    }
    NoProgress progress;
    const auto opened = openTexels(
        std::move(*file), "fuzz", {.wholeBytes = 0, .cacheBytes = most / 4}, budget, progress);
    if (!opened) {
        return;
    }
    std::uint64_t left = most;
    for (std::uint32_t f = 0; f < opened->texels.faceCount(); ++f) {
        const FaceTexels& face = opened->texels.face(faceId(f));
        if (face.byteCount() > left) {
            continue;
        }
        left -= face.byteCount();
        for (int log2 = 0; log2 < face.level().log2(); ++log2) {
            (void)face.storedLevel(Level(log2));
        }
        (void)face.pinned();
    }
    (void)opened->texels.checkWhole();
}

/// Takes the texels for those of layers, if the metadata name some.
inline void
readLayersOfPtx(const PtxFile& file, std::span<const PtxMetadata> metadata, std::uint64_t most)
{
    auto settings = layersOf(metadata);
    if (settings && !settings->empty()) {
        NoProgress progress;
        MemoryBudget budget(most);
        (void)readLayers(file, std::move(*settings), budget, Threads{1}, progress);
    }
}

/// Reads everything there is to read of a .ptx: every level of every face, metadata, links, mesh,
/// layers.
inline void readAllOfPtx(std::string_view bytes)
{
    constexpr std::uint64_t kBudgetBytes = std::uint64_t{4} << 20U;
    MemoryBudget budget(kBudgetBytes);
    const auto file = PtxFile::open(memorySource(bytes), budget);
    if (!file) {
        return;
    }
    NoProgress progress;
    const auto contents = readContents(*file, budget, progress);
    if (contents && carriesMesh(contents->metadata)) {
        (void)meshOf(contents->metadata, file->faceCount());
    }
    if (contents) {
        readLayersOfPtx(*file, contents->metadata, kBudgetBytes);
    }
    readPtxFaceByFace(bytes, kBudgetBytes);
    PtxDecoder decoder;
    std::uint64_t left = kBudgetBytes;
    for (std::uint32_t face = 0; face < file->faceCount(); ++face) {
        for (int reduction = 1; reduction < file->levelCount(); ++reduction) {
            const std::uint64_t size =
                std::uint64_t{file->info(faceId(face)).level().coarser(reduction).texelCount()} *
                file->format().texelBytes();
            if (!file->block(faceId(face), reduction) || size > left) {
                continue;
            }
            left -= size;
            (void)file->texels(faceId(face), reduction, decoder);
        }
    }
}

} // namespace trixel

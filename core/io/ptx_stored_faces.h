// SPDX-License-Identifier: GPL-3.0-or-later
//
// A .ptx whose texels are read face by face when they are asked for.
//
// What is checked when: header, face infos, constant values, level tables, edits, metadata, and
// that every block lies inside the file and no face is larger than the format allows, when the file
// is opened (`PtxFile::open`); the block of a face when it is read. The file is kept open and read
// with plain reads: cut short, changed or gone (on a network) it gives faults of single faces,
// never a signal. A file that is replaced by a rename, as every save of Trixel's is, stays readable
// to whoever opened it before.
#pragma once

#include "core/io/memory_budget.h"
#include "core/io/ptx_file.h"
#include "core/texture/stored_faces.h"
#include "core/texture/texel_store.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace trixel {

/// How much of a file is read when it is opened, and kept of what is read later.
struct OpenOptions
{
    /// Files whose texels take no more bytes than this in memory are read whole: faults are then
    /// told before anything is shown.
    std::uint64_t wholeBytes = std::uint64_t{256} << 20U;
    /// See `StoredFaces`.
    std::uint64_t cacheBytes = StoredFaces::kDefaultBudget;
};

/// The texels of a file, and what reads those that are not in memory.
struct OpenedTexels
{
    TexelStore texels;
    std::shared_ptr<StoredFaces> faces; ///< null when all is in memory
};

/// Reads faces of a .ptx, and the reductions that it stores; with alpha these are stored
/// premultiplied and are given out as they were before that.
class PtxFaceReader final : public FaceReader
{
public:
    /// \param name  of the file, for errors
    PtxFaceReader(PtxFile file, std::string name);

    Result<bool> read(FaceId face, Level level, std::span<std::byte> texels) const override;
    bool stores(FaceId face, Level level) const override;
    std::span<const std::byte> mean(FaceId face) const override;

private:
    std::unique_ptr<PtxDecoder> takeDecoder() const;
    void giveBack(std::unique_ptr<PtxDecoder> decoder, std::size_t used) const;

    PtxFile m_file;
    std::string m_name;
    mutable std::mutex m_mutex;
    mutable std::vector<std::unique_ptr<PtxDecoder>> m_decoders; ///< that nobody works with
};

/// The texels of every face at full resolution: read now (as `readTexels` does), or face by face
/// when asked for.
/// \param file  is kept open if need be
/// \param name  of the file, for faults that are met later
Result<OpenedTexels> openTexels(PtxFile file,
                                const std::string& name,
                                const OpenOptions& options,
                                MemoryBudget& budget,
                                Progress& progress);

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The process that decodes and encodes images: what it is asked, and what may become of it.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/image/job_memory.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace trixel {

/// What decoding one image may take, and how large it may be.
struct ImageLimits
{
    std::int64_t mostPixelsAcross = 1 << 17;           ///< in width, and in height
    std::uint64_t mostBytes = std::uint64_t{2} << 30U; ///< of decoded pixels
    int mostChannels = 64;
    /// Decoded bytes a byte of the file, asked of images above 64 MB: more is a bomb.
    std::uint64_t mostBytesPerByte = 10'000;
    std::uint64_t memoryBytes = std::uint64_t{6} << 30U; ///< of the process, libraries and all
    std::chrono::seconds processorTime{60};
    std::chrono::seconds wallTime{240};
};

/// The program `trixel-images`. One process for each job, so that whatever a file does to a decoder
/// ends with it.
class ImageWorker
{
public:
    /// Where the environment variable TRIXEL_IMAGES says; else beside the program that runs, or in
    /// lib/trixel where that was installed.
    ImageWorker();
    explicit ImageWorker(std::filesystem::path program);

    /// Runs one job and returns its answer, a JSON object. Errors: what the job says in its "error"
    /// (Contents); that it crashed, or ran out of memory or time (Contents); that the program is
    /// not there (Path). Cancelled when `progress` says so; the process is gone then.
    /// \param input, output  what the job reads and fills
    Result<nlohmann::json> run(const nlohmann::json& job,
                               const Descriptor& input,
                               const Descriptor& output,
                               const ImageLimits& limits,
                               Progress& progress) const;

private:
    std::filesystem::path m_program;
};

} // namespace trixel

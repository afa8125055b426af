// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random access to the bytes of a file or of memory, a stretch at a time.
#pragma once

#include "core/base/result.h"
#include "core/io/buffer.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace trixel {

class ByteSource
{
public:
    virtual ~ByteSource() = default;

    virtual std::uint64_t size() const = 0;

    /// The bytes [offset, offset + count), which must lie inside the source (checked). They stay
    /// valid as long as the source and until `scratch` is used again. May be called from several
    /// threads, each with a scratch buffer of its own.
    virtual Result<std::span<const std::byte>>
    view(std::uint64_t offset, std::size_t count, Buffer& scratch) const = 0;

    /// Fails when the bytes were changed since the source was opened, as far as can be told: by the
    /// size of a file and the time when it was last written to. A file that takes the place of
    /// another one (as `commitFile` does it) is no change: a source goes on reading the old one.
    virtual Status checkUnchanged() const { return {}; }
};

/// Reads stretch after stretch; where they follow each other, many at a time.
class ReadAhead
{
public:
    /// As ByteSource::view; valid until the next call.
    Result<std::span<const std::byte>>
    view(const ByteSource& source, std::uint64_t offset, std::size_t count);

private:
    Buffer m_buffer;
    const ByteSource* m_source = nullptr;
    std::uint64_t m_begin = 0;
    std::span<const std::byte> m_bytes;
};

/// Bytes that lie in memory; `bytes` must outlive the source.
std::unique_ptr<ByteSource> memorySource(std::string_view bytes);

/// A regular file, read where asked and when asked. Errors (kind Path) name the file and the
/// cause: missing, a directory, not readable.
Result<std::unique_ptr<ByteSource>> fileSource(const std::filesystem::path& path);

} // namespace trixel

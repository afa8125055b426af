// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/byte_source.h"

#include "core/base/check.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace trixel {

namespace {

class MemorySource final : public ByteSource
{
public:
    explicit MemorySource(std::string_view bytes)
        : m_bytes(std::as_bytes(std::span(bytes)))
    {
    }

    std::uint64_t size() const override { return m_bytes.size(); }

    Result<std::span<const std::byte>>
    view(std::uint64_t offset, std::size_t count, Buffer& /*scratch*/) const override
    {
        check(offset <= m_bytes.size() && count <= m_bytes.size() - offset, "bytes of the source");
        return m_bytes.subspan(offset, count);
    }

private:
    std::span<const std::byte> m_bytes;
};

// Plain reads rather than a mapping: a file cut short meanwhile is an error, not a signal.
class FileSource final : public ByteSource
{
public:
    FileSource(std::string name, int fd, const struct stat& status)
        : m_name(std::move(name))
        , m_fd(fd)
        , m_size(static_cast<std::uint64_t>(status.st_size))
        , m_written(status.st_mtim)
    {
    }
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;
    ~FileSource() override { ::close(m_fd); }

    std::uint64_t size() const override { return m_size; }

    Result<std::span<const std::byte>>
    view(std::uint64_t offset, std::size_t count, Buffer& scratch) const override
    {
        check(offset <= m_size && count <= m_size - offset, "bytes of the source");
        const std::span<std::byte> bytes = scratch.first(count);
        for (std::size_t done = 0; done < count;) {
            const ssize_t got =
                ::pread(m_fd, bytes.data() + done, count - done, static_cast<off_t>(offset + done));
            if (got > 0) {
                done += static_cast<std::size_t>(got);
            } else if (got == 0) {
                return pathError(m_name + ": became shorter while it was read");
            } else if (errno != EINTR) {
                return pathError(m_name + ": cannot be read: " + std::strerror(errno));
            }
        }
        return bytes;
    }

    Status checkUnchanged() const override
    {
        struct stat now
        {
        };
        if (::fstat(m_fd, &now) != 0) {
            return pathError(m_name + ": cannot be read: " + std::strerror(errno));
        }
        if (static_cast<std::uint64_t>(now.st_size) != m_size ||
            now.st_mtim.tv_sec != m_written.tv_sec || now.st_mtim.tv_nsec != m_written.tv_nsec) {
            return pathError(m_name + ": was changed by another program after it was opened");
        }
        return {};
    }

private:
    std::string m_name;
    int m_fd;
    std::uint64_t m_size;
    timespec m_written;
};

} // namespace

Result<std::span<const std::byte>>
ReadAhead::view(const ByteSource& source, std::uint64_t offset, std::size_t count)
{
    constexpr std::uint64_t kAheadBytes = std::uint64_t{256} << 10U;
    const std::uint64_t end = m_begin + m_bytes.size();
    const bool known = m_source == &source && offset >= m_begin && offset <= end;
    if (known && count <= end - offset) {
        return m_bytes.subspan(offset - m_begin, count);
    }
    // Only a request that continues the last one promises more of its kind.
    const std::uint64_t ahead =
        known ? std::min(kAheadBytes, source.size() - std::min(source.size(), offset)) : 0;
    auto bytes = source.view(offset, std::max<std::uint64_t>(count, ahead), m_buffer);
    if (!bytes) {
        m_source = nullptr;
        return bytes;
    }
    m_source = &source;
    m_begin = offset;
    m_bytes = *bytes;
    return m_bytes.first(count);
}

std::unique_ptr<ByteSource> memorySource(std::string_view bytes)
{
    return std::make_unique<MemorySource>(bytes);
}

Result<std::unique_ptr<ByteSource>> fileSource(const std::filesystem::path& path)
{
    // Not blocking: opening a pipe nobody writes to must not hang.
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) {
        return pathError(path.string() + ": cannot be opened: " + std::strerror(errno));
    }
    struct stat status
    {
    };
    if (::fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(fd);
        return pathError(path.string() + (S_ISDIR(status.st_mode) ? ": is a directory, not a file"
                                                                  : ": is not a regular file"));
    }
    return std::make_unique<FileSource>(path.string(), fd, status);
}

} // namespace trixel

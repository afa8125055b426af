// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace trixel {
namespace {

class FileDescriptor
{
public:
    explicit FileDescriptor(int number)
        : m_number(number)
    {
    }
    ~FileDescriptor()
    {
        if (m_number >= 0) {
            ::close(m_number);
        }
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    int number() const { return m_number; }

private:
    int m_number;
};

tl::unexpected<Error> refused(const std::filesystem::path& path, const std::string& cause)
{
    return pathError(path.string() + ": cannot be read: " + cause);
}

tl::unexpected<Error> refused(const std::filesystem::path& path, int errorNumber)
{
    return refused(path, std::string(std::strerror(errorNumber)));
}

// Fills `bytes`; a file that shrinks meanwhile is an error, one that grows is cut at its old size.
Status readAll(int file, const std::filesystem::path& path, std::string& bytes)
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(file, bytes.data() + done, bytes.size() - done);
        if (got > 0) {
            done += static_cast<std::size_t>(got);
        } else if (got == 0) {
            return refused(path, "it became shorter while it was read");
        } else if (errno != EINTR) {
            return refused(path, errno);
        }
    }
    return {};
}

} // namespace

Result<std::string> readFile(const std::filesystem::path& path, std::uint64_t maxBytes)
{
    // Without O_NONBLOCK, opening a pipe nobody writes to would wait for ever.
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status = {};
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0) {
        return refused(path, errno);
    }
    if (S_ISDIR(status.st_mode)) {
        return refused(path, "it is a directory");
    }
    if (!S_ISREG(status.st_mode)) {
        return refused(path, "it is not a regular file");
    }
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > maxBytes) {
        return refused(path,
                       "it has " + std::to_string(size) + " bytes, more than the limit of " +
                           std::to_string(maxBytes));
    }
    try {
        std::string bytes(size, '\0');
        return readAll(file.number(), path, bytes).map([&] { return std::move(bytes); });
    } catch (const std::exception&) { // bad_alloc, length_error
        return refused(path, "its " + std::to_string(size) + " bytes do not fit into memory");
    }
}

} // namespace trixel

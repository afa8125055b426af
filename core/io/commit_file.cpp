// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/commit_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace trixel {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> failed(const fs::path& path, const char* what, int error)
{
    return pathError(path.string() + ": " + what + ": " + std::strerror(error));
}

class FileDescriptor
{
public:
    explicit FileDescriptor(int fd)
        : m_fd(fd)
    {
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor()
    {
        if (m_fd >= 0) {
            ::close(m_fd);
        }
    }

    int get() const { return m_fd; }
    bool isOpen() const { return m_fd >= 0; }
    /// The outcome of closing, which some file systems use to tell of failed writes.
    bool close() { return ::close(std::exchange(m_fd, -1)) == 0; }

private:
    int m_fd;
};

// Removes the file when it goes out of scope, unless it got its name by then.
class TemporaryFile
{
public:
    explicit TemporaryFile(fs::path path)
        : m_path(std::move(path))
    {
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (!m_path.empty()) {
            ::unlink(m_path.c_str());
        }
    }

    const fs::path& path() const { return m_path; }
    bool renameTo(const fs::path& target)
    {
        if (::rename(m_path.c_str(), target.c_str()) != 0) {
            return false;
        }
        m_path.clear();
        return true;
    }

private:
    fs::path m_path;
};

class DescriptorWriter final : public FileWriter
{
public:
    DescriptorWriter(int fd, const fs::path& target)
        : m_fd(fd)
        , m_target(target)
    {
    }

    Status write(std::span<const std::byte> bytes) override
    {
        // Linux writes at most 2 GiB at once; smaller pieces also meet a full disk sooner.
        constexpr std::size_t kPieceBytes = std::size_t{64} << 20U;
        while (!bytes.empty()) {
            const std::size_t piece = std::min(bytes.size(), kPieceBytes);
            const ssize_t done = ::write(m_fd, bytes.data(), piece);
            if (done > 0) {
                bytes = bytes.subspan(static_cast<std::size_t>(done));
            } else if (done == 0 || errno != EINTR) {
                return failed(m_target, "cannot be written", done == 0 ? ENOSPC : errno);
            }
        }
        return {};
    }

private:
    int m_fd;
    const fs::path& m_target;
};

// What a link points to, so that the link stays and its target is replaced.
fs::path targetOf(const fs::path& path)
{
    std::error_code error;
    fs::path target = fs::is_symlink(path, error) ? fs::canonical(path, error) : path;
    return error ? path : target;
}

// The mode of the file that will be replaced; nothing if there is none.
Result<std::optional<mode_t>> replaceableMode(const fs::path& path)
{
    struct stat status
    {
    };
    if (::stat(path.c_str(), &status) != 0) {
        if (errno == ENOENT) {
            return std::nullopt;
        }
        return failed(path, "cannot be written", errno);
    }
    if (S_ISDIR(status.st_mode)) {
        return pathError(path.string() + ": is a directory, not a file");
    }
    if (!S_ISREG(status.st_mode)) {
        return pathError(path.string() + ": is not a regular file");
    }
    // The superuser may write anything; a file without any write permission is meant to stay.
    if ((status.st_mode & 0222U) == 0 || ::access(path.c_str(), W_OK) != 0) {
        return pathError(path.string() + ": is read-only");
    }
    return status.st_mode & 0777U;
}

fs::path folderOf(const fs::path& path)
{
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path temporaryName(const fs::path& target)
{
    std::random_device random;
    // A long name plus the suffix could exceed what the file system allows.
    std::string name = ".";
    name += target.filename().string().substr(0, 200);
    name += '.';
    name += std::to_string(random());
    name += ".tmp";
    return folderOf(target) / name;
}

int createTemporary(const fs::path& target, fs::path& path)
{
    for (int attempt = 0; attempt < 100; ++attempt) {
        path = temporaryName(target);
        const int fd = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) {
            return fd;
        }
    }
    return -1;
}

Status syncFolder(const fs::path& target)
{
    const FileDescriptor folder(
        ::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder.isOpen()) {
        // A folder that may be written but not read cannot be synced.
        return errno == EACCES ? Status() : failed(target, "its folder cannot be opened", errno);
    }
    // Some file systems cannot sync folders and say so by EINVAL.
    if (::fsync(folder.get()) != 0 && errno != EINVAL) {
        return failed(target, "was replaced, but its folder cannot be synced to disk", errno);
    }
    return {};
}

Status fill(FileDescriptor& file,
            const fs::path& target,
            std::optional<mode_t> mode,
            const std::function<Status(FileWriter&)>& write)
{
    if (mode) {
        (void)::fchmod(file.get(), *mode); // a file system without modes is no reason to fail
    }
    DescriptorWriter writer(file.get(), target);
    if (Status status = write(writer); !status) {
        return status;
    }
    // Never tried again: after a failed sync the kernel takes the lost pages for written.
    if (::fsync(file.get()) != 0) {
        return failed(target, "cannot be synced to disk", errno);
    }
    if (!file.close()) {
        return failed(target, "cannot be written", errno);
    }
    return {};
}

Status copyInto(FileWriter& file, const fs::path& from)
{
    const FileDescriptor source(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
    if (!source.isOpen()) {
        return failed(from, "cannot be read", errno);
    }
    std::vector<std::byte> bytes(std::size_t{1} << 20U);
    while (true) {
        const ssize_t count = ::read(source.get(), bytes.data(), bytes.size());
        if (count == 0) {
            return {};
        }
        if (count < 0 && errno != EINTR) {
            return failed(from, "cannot be read", errno);
        }
        const auto some =
            std::span(bytes).first(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (Status written = file.write(some); !written) {
            return written;
        }
    }
}

/// One of several files, made ready to take its name by a rename alone.
struct ReadyFile
{
    fs::path target; ///< no link
    std::optional<mode_t> mode;
    fs::path from;
    std::unique_ptr<TemporaryFile> copy; ///< where `from` is one
};

/// A link may lead to another folder, even one of another file system: a copy goes there first.
Status makeReady(ReadyFile& file, const fs::path& named)
{
    if (folderOf(file.target) == folderOf(named)) {
        if (file.mode) {
            (void)::chmod(file.from.c_str(), *file.mode);
        }
        return {};
    }
    fs::path path;
    FileDescriptor descriptor(createTemporary(file.target, path));
    if (!descriptor.isOpen()) {
        return failed(file.target, "cannot be written into its folder", errno);
    }
    file.copy = std::make_unique<TemporaryFile>(path);
    return fill(descriptor, file.target, file.mode, [&](FileWriter& writer) {
        return copyInto(writer, file.from);
    });
}

bool takeName(ReadyFile& file)
{
    return file.copy ? file.copy->renameTo(file.target)
                     : ::rename(file.from.c_str(), file.target.c_str()) == 0;
}

} // namespace

Status commitFile(const fs::path& path,
                  const std::function<Status(FileWriter&)>& write,
                  const std::function<Status(const fs::path& written)>& verify)
{
    if (!path.has_filename()) {
        return pathError(path.string() + ": is not the name of a file");
    }
    const fs::path target = targetOf(path);
    const auto mode = replaceableMode(target);
    if (!mode) {
        return tl::unexpected(mode.error());
    }
    fs::path temporaryPath;
    FileDescriptor file(createTemporary(target, temporaryPath));
    if (!file.isOpen()) {
        return failed(path, "cannot be written into its folder", errno);
    }
    TemporaryFile temporary(temporaryPath);
    if (Status status = fill(file, target, *mode, write); !status) {
        return status;
    }
    if (Status status = verify(temporary.path()); !status) {
        return status.error().kind == ErrorKind::Cancelled
                   ? status
                   : Status(prefixed(target.string() + ": what was written reads back differently",
                                     status.error()));
    }
    if (!temporary.renameTo(target)) {
        return failed(target, "cannot be replaced", errno);
    }
    return syncFolder(target);
}

Status checkReplaceable(const fs::path& path)
{
    return replaceableMode(targetOf(path)).map([](const auto& /*mode*/) {});
}

Status commitWritten(std::span<const WrittenFile> files)
{
    std::vector<ReadyFile> ready;
    for (const WrittenFile& file : files) {
        const fs::path target = targetOf(file.target);
        const auto mode = replaceableMode(target);
        if (!mode) {
            return tl::unexpected(mode.error());
        }
        ready.push_back({target, *mode, file.written, nullptr});
    }
    for (std::size_t k = 0; k < ready.size(); ++k) {
        if (Status done = makeReady(ready[k], files[k].target); !done) {
            return done;
        }
    }
    for (ReadyFile& file : ready) {
        if (!takeName(file)) {
            return failed(file.target, "cannot be replaced", errno);
        }
    }
    std::set<fs::path> synced;
    for (const ReadyFile& file : ready) {
        if (synced.insert(folderOf(file.target)).second) {
            if (Status done = syncFolder(file.target); !done) {
                return done;
            }
        }
    }
    return {};
}

} // namespace trixel

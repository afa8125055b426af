// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/image/job_memory.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trixel {

namespace {

tl::unexpected<Error> failed(const std::string& what)
{
    return contentsError(what + ": " + std::strerror(errno));
}

Result<std::shared_ptr<std::byte>> map(int fd, std::uint64_t bytes, int flags)
{
    void* address =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, flags, fd, 0); // NOLINT(hicpp-signed-*)
    if (address == MAP_FAILED) {                                      // NOLINT: the system's macro
        return failed(std::to_string(bytes) + " bytes of memory cannot be had");
    }
    return std::shared_ptr<std::byte>(static_cast<std::byte*>(address),
                                      [bytes](std::byte* at) { ::munmap(at, bytes); });
}

} // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept
{
    if (this != &other) {
        close();
        m_fd = other.m_fd;
        other.m_fd = -1;
    }
    return *this;
}

void Descriptor::close()
{
    if (m_fd >= 0) {
        ::close(m_fd);
    }
    m_fd = -1;
}

Result<Descriptor> makeJobMemory(std::uint64_t bytes)
{
    Descriptor memory(::memfd_create("trixel-image", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory.isOpen() || ::ftruncate(memory.get(), static_cast<off_t>(bytes)) != 0) {
        return failed(std::to_string(bytes) + " bytes of memory cannot be had");
    }
    return memory;
}

Result<std::shared_ptr<std::byte>> mapShared(const Descriptor& memory, std::uint64_t bytes)
{
    return map(memory.get(), bytes, MAP_SHARED);
}

Result<std::shared_ptr<std::byte>> mapSealed(const Descriptor& memory, std::uint64_t bytes)
{
    // Sealed first and measured then: what shrinks after being measured would end this program.
    if (::fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE) != 0) {
        return failed("the pixels cannot be sealed");
    }
    const auto size = jobMemorySize(memory);
    if (!size) {
        return tl::unexpected(size.error());
    }
    if (*size != bytes) {
        return contentsError("the decoder handed over " + std::to_string(*size) +
                             " bytes, expected " + std::to_string(bytes));
    }
    return map(memory.get(), bytes, MAP_PRIVATE);
}

Result<std::uint64_t> jobMemorySize(const Descriptor& memory)
{
    struct stat status
    {
    };
    if (::fstat(memory.get(), &status) != 0) {
        return failed("its size cannot be told");
    }
    return static_cast<std::uint64_t>(status.st_size);
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace trixel {

/// A file descriptor that is closed when it goes out of scope.
class Descriptor
{
public:
    explicit Descriptor(int fd = -1)
        : m_fd(fd)
    {
    }
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept
        : m_fd(other.m_fd)
    {
        other.m_fd = -1;
    }
    Descriptor& operator=(Descriptor&& other) noexcept;

    int get() const { return m_fd; }
    bool isOpen() const { return m_fd >= 0; }
    void close();

private:
    int m_fd;
};

/// A piece of memory that is a file, so that two processes can hand it to each other without a
/// copy.
Result<Descriptor> makeJobMemory(std::uint64_t bytes);

/// The bytes of such a file, writable and shared with whoever has it open.
/// \param bytes  its size, not 0
Result<std::shared_ptr<std::byte>> mapShared(const Descriptor& memory, std::uint64_t bytes);

/// The bytes of such a file as our own: nobody changes it or its size from now on, and what is
/// written to them stays here.
/// \param bytes  its size, not 0; fails if it has another
Result<std::shared_ptr<std::byte>> mapSealed(const Descriptor& memory, std::uint64_t bytes);

/// How large such a file is.
Result<std::uint64_t> jobMemorySize(const Descriptor& memory);

} // namespace trixel

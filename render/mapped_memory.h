// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory for buffers of a graphics driver that is a program.
#pragma once

#include <cstddef>

namespace trixel::render {

class Gl;

/// Whole pages that the system makes, cleared, where they are first touched: however large, having
/// them takes no time.
class MappedMemory
{
public:
    MappedMemory() = default;
    ~MappedMemory();
    MappedMemory(const MappedMemory&) = delete;
    MappedMemory& operator=(const MappedMemory&) = delete;

    /// Room for so many bytes; what was there stays, but maybe elsewhere.
    /// \return  false, and nothing changes, where there is not so much
    bool resize(std::size_t bytes);
    void* data() const { return m_data; }
    /// Lets it be until the program ends: something may read it yet.
    void leave() { m_data = nullptr; }

private:
    void* m_data = nullptr;
    std::size_t m_bytes = 0;
};

/// Whether buffers of the current context are better made of `MappedMemory`: a rasteriser that is a
/// program clears what it allocates, all at once (0.4 ms a MiB with llvmpipe), and can take memory
/// that is given to it (GL_AMD_pinned_memory).
bool takesMappedMemory(Gl& gl);

} // namespace trixel::render

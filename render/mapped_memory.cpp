// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mapped_memory.h"

#include "render/gl.h"

#include <algorithm>
#include <string_view>
#include <sys/mman.h>

namespace trixel::render {

MappedMemory::~MappedMemory()
{
    if (m_data != nullptr) {
        munmap(m_data, m_bytes);
    }
}

bool MappedMemory::resize(std::size_t bytes)
{
    bytes = std::max<std::size_t>(bytes, 1);
    void* made = m_data != nullptr ? mremap(m_data, m_bytes, bytes, MREMAP_MAYMOVE)
                                   : mmap(nullptr,
                                          bytes,
                                          PROT_READ | PROT_WRITE,
                                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                                          -1,
                                          0);
    if (made == MAP_FAILED) {
        return false;
    }
    m_data = made;
    m_bytes = bytes;
    return true;
}

bool takesMappedMemory(Gl& gl)
{
    const QOpenGLContext* context = QOpenGLContext::currentContext();
    const auto* name = reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER));
    return name != nullptr && std::string_view(name).starts_with("llvmpipe") &&
           context != nullptr && context->hasExtension("GL_AMD_pinned_memory");
}

} // namespace trixel::render

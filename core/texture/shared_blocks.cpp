// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/shared_blocks.h"

#include <algorithm>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace trixel {
namespace {

/// Room for floats, in large pages as far as it fills them: filters read it at random places, and
/// each page has to be looked up.
std::shared_ptr<float[]> makeRoom(std::size_t size)
{
    constexpr std::size_t kLargePage = std::size_t{1} << 21;
    const std::size_t bytes = size * sizeof(float);
    if (bytes < kLargePage) {
        return std::shared_ptr<float[]>(new float[size]);
    }
    constexpr std::align_val_t kAlignment{kLargePage};
    void* room = ::operator new[](bytes, kAlignment);
#ifdef __linux__
    // Refused, it is as good as it was.
    static_cast<void>(madvise(room, bytes / kLargePage * kLargePage, MADV_HUGEPAGE));
#endif
    return {static_cast<float*>(room), [](float* it) { ::operator delete[](it, kAlignment); }};
}

} // namespace

float* SharedBlocks::renew(FaceId face, Level level, bool constant, std::size_t size)
{
    release(face);
    if (m_unused.empty()) {
        m_unused.push_back(static_cast<std::uint32_t>(m_blocks.size()));
        m_blocks.emplace_back();
    }
    const std::uint32_t number = m_unused.back();
    m_unused.pop_back();
    m_blockOf[indexOf(face)] = number;
    m_blocks[number] = {level, constant, 1, size, makeRoom(size)};
    return m_blocks[number].values.get();
}

void SharedBlocks::share(FaceId face, FaceId with)
{
    check(m_blockOf[indexOf(with)] != kNone, "a block to share");
    ++m_blocks[m_blockOf[indexOf(with)]].users;
    release(face);
    m_blockOf[indexOf(face)] = m_blockOf[indexOf(with)];
}

float* SharedBlocks::writable(FaceId face)
{
    Block& own = m_blocks[m_blockOf[indexOf(face)]];
    if (own.users == 1 && own.values.use_count() == 1) {
        return own.values.get();
    }
    const Block shared = own;
    float* values = renew(face, shared.level, shared.constant, shared.size);
    std::copy_n(shared.values.get(), shared.size, values);
    return values;
}

void SharedBlocks::release(FaceId face)
{
    const std::uint32_t number = m_blockOf[indexOf(face)];
    if (number != kNone && --m_blocks[number].users == 0) {
        m_blocks[number].values.reset();
        m_blocks[number].size = 0;
        m_unused.push_back(number);
    }
}

std::size_t SharedBlocks::memoryBytes() const
{
    std::size_t bytes = m_blockOf.size() * sizeof(std::uint32_t) + m_blocks.size() * sizeof(Block);
    for (const Block& block : m_blocks) {
        bytes += block.size * sizeof(float);
    }
    return bytes;
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_texels.h"

#include <algorithm>
#include <cstring>

namespace trixel {

namespace {

bool allAlike(std::span<const std::byte> texels, std::size_t texelBytes)
{
    // Shifted by one texel the bytes equal themselves exactly when all texels are alike.
    return std::memcmp(texels.data(), texels.data() + texelBytes, texels.size() - texelBytes) == 0;
}

void spread(std::span<const std::byte> texel, std::span<std::byte> texels)
{
    std::memcpy(texels.data(), texel.data(), texel.size());
    // Doubling copies: log n calls instead of one a texel.
    for (std::size_t done = texel.size(); done < texels.size();) {
        const std::size_t next = std::min(done, texels.size() - done);
        std::memcpy(texels.data() + done, texels.data(), next);
        done += next;
    }
}

} // namespace

FaceTexels::FaceTexels(Level level, bool constant, std::size_t texelBytes)
    : m_texelBytes(static_cast<std::uint32_t>(texelBytes))
    , m_level(level)
    , m_constant(constant)
{
    check(texelBytes > 0, "a texel has bytes");
    const std::size_t bytes = texelBytes * (constant ? 1 : level.texelCount());
    m_words = std::make_shared_for_overwrite<std::uint64_t[]>((bytes + 7) / 8);
}

FaceTexels FaceTexels::constant(Level level, std::span<const std::byte> texel)
{
    FaceTexels face(level, true, texel.size());
    std::memcpy(face.data(), texel.data(), texel.size());
    return face;
}

FaceTexels FaceTexels::full(Level level, std::size_t texelBytes, std::span<const std::byte> texels)
{
    check(texels.size() == texelBytes * level.texelCount(), "4^n texels");
    FaceTexels face(level, false, texelBytes);
    std::memcpy(face.data(), texels.data(), texels.size());
    return face;
}

FaceTexels FaceTexels::atLevel(Level level) const
{
    check(m_constant, "a face of one value");
    FaceTexels face = *this;
    face.m_level = level;
    return face;
}

std::span<const std::byte> FaceTexels::bytes() const
{
    return {data(), std::size_t{m_texelBytes} * (m_constant ? 1 : m_level.texelCount())};
}

std::span<std::byte> FaceTexels::writable()
{
    check(m_words != nullptr, "a face with texels");
    if (m_constant) {
        FaceTexels face(m_level, false, m_texelBytes);
        spread(bytes(), {face.data(), std::size_t{m_texelBytes} * m_level.texelCount()});
        *this = std::move(face);
    } else if (m_words.use_count() > 1) {
        *this = full(m_level, m_texelBytes, bytes());
    }
    return {data(), std::size_t{m_texelBytes} * m_level.texelCount()};
}

FaceTexels FaceTexels::collapsed() const
{
    if (m_constant || !allAlike(bytes(), m_texelBytes)) {
        return *this;
    }
    return constant(m_level, bytes().first(m_texelBytes));
}

bool FaceTexels::operator==(const FaceTexels& other) const
{
    if (m_level != other.m_level || m_texelBytes != other.m_texelBytes) {
        return false;
    }
    if (m_words == other.m_words) {
        return true;
    }
    const FaceTexels a = collapsed();
    const FaceTexels b = other.collapsed();
    return a.m_constant == b.m_constant && std::ranges::equal(a.bytes(), b.bytes());
}

} // namespace trixel

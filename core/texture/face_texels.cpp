// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_texels.h"

#include "core/texture/stored_faces.h"

#include <algorithm>
#include <cstring>
#include <utility>

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
    m_held = std::make_shared_for_overwrite<std::uint64_t[]>((byteCount() + 7) / 8);
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

FaceTexels FaceTexels::stored(std::shared_ptr<StoredFace> face, Level level, std::size_t texelBytes)
{
    FaceTexels result;
    result.m_held = std::move(face);
    result.m_texelBytes = static_cast<std::uint32_t>(texelBytes);
    result.m_level = level;
    result.m_constant = false;
    result.m_stored = true;
    return result;
}

StoredFace& FaceTexels::record() const
{
    return *static_cast<StoredFace*>(m_held.get());
}

std::span<const std::byte> FaceTexels::bytes() const
{
    return {m_stored ? record().hold() : data(), byteCount()};
}

std::span<std::byte> FaceTexels::writable()
{
    check(m_held != nullptr, "a face with texels");
    if (m_constant) {
        FaceTexels face(m_level, false, m_texelBytes);
        spread(bytes(), {face.data(), face.byteCount()});
        face.m_damaged = m_damaged;
        *this = std::move(face);
    } else if (m_stored || m_held.use_count() > 1) {
        const FaceTexels shared = pinned();
        *this = full(m_level, m_texelBytes, shared.bytes());
        m_damaged = shared.m_damaged;
    }
    return {data(), byteCount()};
}

FaceTexels FaceTexels::collapsed() const
{
    if (m_constant) {
        return *this;
    }
    const FaceTexels here = pinned();
    if (!allAlike(here.bytes(), m_texelBytes)) {
        return *this;
    }
    FaceTexels one = constant(m_level, here.bytes().first(m_texelBytes));
    one.m_damaged = here.m_damaged;
    return one;
}

bool FaceTexels::isLoaded() const
{
    return !m_stored || record().isHeld();
}

FaceTexels FaceTexels::pinned() const
{
    if (!m_stored) {
        return *this;
    }
    FaceTexels face = *this;
    face.m_held = record().pin();
    face.m_stored = false;
    face.m_damaged = record().isDamaged();
    return face;
}

FaceTexels FaceTexels::released() const
{
    return isLoaded() && m_stored ? record().anew() : *this;
}

std::optional<std::span<const std::byte>> FaceTexels::mean() const
{
    if (m_stored) {
        return record().mean();
    }
    return m_constant ? std::optional(bytes()) : std::nullopt;
}

bool FaceTexels::hasStoredLevel(Level level) const
{
    return m_constant || (m_stored && level <= m_level && record().stores(level));
}

std::optional<FaceTexels> FaceTexels::storedLevel(Level level) const
{
    check(level <= m_level, "a level that the face has");
    if (m_constant) {
        return atLevel(level);
    }
    return hasStoredLevel(level) ? record().coarser(level) : std::nullopt;
}

bool FaceTexels::isDamaged() const
{
    return m_stored ? record().isDamaged() : m_damaged;
}

bool FaceTexels::operator==(const FaceTexels& other) const
{
    if (m_level != other.m_level || m_texelBytes != other.m_texelBytes) {
        return false;
    }
    if (m_held == other.m_held) {
        return true;
    }
    const FaceTexels a = collapsed().pinned();
    const FaceTexels b = other.collapsed().pinned();
    return a.m_constant == b.m_constant && std::ranges::equal(a.bytes(), b.bytes());
}

} // namespace trixel

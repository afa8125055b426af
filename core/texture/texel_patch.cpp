// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_patch.h"

#include "core/base/check.h"

#include <algorithm>
#include <utility>

namespace trixel {

namespace {

void swapRuns(TexelPatch::Texels& part, std::span<std::byte> texels, std::size_t texelBytes)
{
    auto value = part.values.begin();
    for (const TexelPatch::Run& run : part.runs) {
        const std::size_t first = run.first * texelBytes;
        const std::size_t size = run.count * texelBytes;
        check(first + size <= texels.size(), "run inside the face");
        std::ranges::swap_ranges(texels.subspan(first, size), std::span(value, size));
        value += static_cast<std::ptrdiff_t>(size);
    }
}

} // namespace

void TexelPatch::addTexels(FaceId face,
                           std::span<const Run> runs,
                           std::span<const std::byte> before)
{
    std::uint64_t count = 0;
    std::uint64_t end = 0;
    for (const Run& run : runs) {
        check(run.count > 0 && (count == 0 || run.first > end), "runs apart and ascending");
        end = std::uint64_t{run.first} + run.count;
        count += run.count;
    }
    check(count > 0 && before.size() % count == 0, "the bytes of every texel");
    m_faces.push_back(face);
    m_texels.push_back({face, {runs.begin(), runs.end()}, {before.begin(), before.end()}});
}

void TexelPatch::addFace(FaceId face, FaceTexels before)
{
    m_faces.push_back(face);
    m_whole.push_back({face, std::move(before)});
}

void TexelPatch::swap(TexelStore& store)
{
    const std::size_t texelBytes = store.format().texelBytes();
    for (Texels& part : m_texels) {
        swapRuns(part, store.writable(part.face), texelBytes);
    }
    for (Whole& part : m_whole) {
        part.texels = store.exchange(part.face, std::move(part.texels));
    }
}

void TexelPatch::collapseFaces(TexelStore& store)
{
    for (const Whole& part : m_whole) {
        store.exchange(part.face, store.face(part.face).collapsed());
    }
    std::vector<Texels> kept;
    for (Texels& part : m_texels) {
        FaceTexels one = store.face(part.face).collapsed();
        if (!one.isConstant()) {
            kept.push_back(std::move(part));
            continue;
        }
        // Taken back in place, the face is what it was before the change.
        swapRuns(part, store.writable(part.face), store.format().texelBytes());
        m_whole.push_back({part.face, store.exchange(part.face, std::move(one))});
    }
    m_texels = std::move(kept);
}

std::size_t TexelPatch::byteSize() const
{
    std::size_t bytes = m_faces.size() * sizeof(FaceId) + m_texels.size() * sizeof(Texels) +
                        m_whole.size() * sizeof(Whole);
    for (const Texels& part : m_texels) {
        bytes += part.runs.size() * sizeof(Run) + part.values.size();
    }
    for (std::size_t k = 0; k < m_whole.size(); ++k) {
        const FaceTexels& texels = m_whole[k].texels;
        const bool seen = k > 0 && texels.sharesBytesWith(m_whole[k - 1].texels);
        bytes += seen || texels.isStored() ? 0 : texels.byteCount();
    }
    return bytes;
}

} // namespace trixel

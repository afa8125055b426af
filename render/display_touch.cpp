// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels that changed: sent at once, and only they.
#include "core/lattice/texel.h"
#include "core/texture/reduced_texel.h"
#include "render/display_texels.h"

#include <algorithm>

namespace trixel::render {

namespace {

/// Rows of a rectangle closer than this are sent in one go: a call costs more than some texels.
constexpr std::uint32_t kMergeGap = 32;
/// Texels of a face that are read here and now rather than by another job.
constexpr std::uint32_t kFewTexels = 1U << 14U;
/// Texels of a face that are read at once for its mean or few others; more is a job.
constexpr std::size_t kMostRead = 1U << 18U;

} // namespace

DisplayTexels::Opener DisplayTexels::opener() const
{
    return [form = m_form, prepare = preparer()](const TexelStore& store) {
        return prepare(openCard(store, form, false, Threads::all()));
    };
}

DisplayTexels::Maker DisplayTexels::maker() const
{
    return [form = m_form](const TexelStore& store, std::span<const BlockJob> jobs) {
        return makeBlocks(store, form, jobs);
    };
}

CardOpening DisplayTexels::openNow(const TexelStore& store) const
{
    return openCard(store, m_form, true, Threads::all());
}

std::optional<MadeBlocks> DisplayTexels::makeAgain(const TexelStore& store,
                                                   const BlockJob& job) const
{
    if (store.face(job.face).level().texelCount() > kFewTexels) {
        return std::nullopt;
    }
    return makeBlocks(store, m_form, {&job, 1});
}

/// Faces in the order of the buffer, where neighbouring ranges join, until so much has been read.
void DisplayTexels::sendTouched(const TexelStore& store, std::size_t mostRead)
{
    if (m_touched.empty()) {
        return;
    }
    std::vector<std::uint32_t> faces;
    faces.reserve(m_touched.size());
    for (const auto& [face, rect] : m_touched) {
        faces.push_back(face);
    }
    std::ranges::sort(
        faces, {}, [&](std::uint32_t face) { return m_blocks.record(faceId(face)).offset; });
    std::size_t read = 0;
    for (const std::uint32_t face : faces) {
        if (read > mostRead) {
            break;
        }
        const auto at = m_touched.find(face);
        read += sendTouched(store, faceId(face), at->second);
        m_touched.erase(at);
    }
}

/// \return texels read
std::size_t DisplayTexels::sendTouched(const TexelStore& store, FaceId face, const Rect& rect)
{
    const FaceTexels& texels = store.face(face);
    const FaceRecord& record = m_blocks.record(face);
    const int own = m_form.shownLevel(texels).log2();
    if (texels.isConstant()) {
        release(face, false);
        show(face, own, true);
        return sendMean(texels, face);
    }
    if (record.isConstant() || record.ownLevel() != own || rect.whole) {
        show(face, own, false);
        return sendWhole(texels, face);
    }
    const int shown = onCard(face).level();
    if (shown == 0) {
        return sendMean(texels, face);
    }
    meanLater(face);
    return shown == texels.level().log2() ? sendRect(texels, face, rect)
                                          : sendReduced(texels, face, rect);
}

std::size_t DisplayTexels::sendWhole(const FaceTexels& texels, FaceId face)
{
    const int level = wantedLevel(face);
    if (level == 0 || texels.level().texelCount() > 4 * kMostRead) {
        release(face, false);
        if (level > 0) {
            makeAgainLater({face, static_cast<std::uint8_t>(level)});
        }
        return sendMean(texels, face);
    }
    if (!place(face, level)) {
        return sendMean(texels, face);
    }
    const std::size_t before = m_bytes.size();
    appendAtLevel(m_form, texels, Level(level), m_bytes);
    write(face, static_cast<std::uint8_t>(level), 0, before);
    meanLater(face);
    return texels.level().texelCount();
}

std::size_t DisplayTexels::sendRect(const FaceTexels& texels, FaceId face, const Rect& rect)
{
    const std::uint32_t resolution = texels.level().resolution();
    const std::uint32_t x1 = std::min(rect.x1, resolution);
    const std::uint32_t y1 = std::min(rect.y1, resolution);
    if (rect.x0 >= x1 || rect.y0 >= y1) {
        return 0;
    }
    const auto level = static_cast<std::uint8_t>(texels.level().log2());
    const auto send = [&](std::uint32_t first, std::uint32_t count) {
        const std::size_t bytes = texels.texelBytes();
        const std::size_t before = m_bytes.size();
        appendShown(m_form.format,
                    m_form.channels,
                    texels.bytes().subspan(first * bytes, count * bytes),
                    m_bytes);
        write(face, level, first, before);
    };
    const std::uint32_t width = x1 - rect.x0;
    if (resolution - width <= kMergeGap) {
        send(rect.x0 + rect.y0 * resolution, (y1 - rect.y0 - 1) * resolution + width);
    } else {
        for (std::uint32_t y = rect.y0; y < y1; ++y) {
            send(rect.x0 + y * resolution, width);
        }
    }
    return std::size_t{width} * (y1 - rect.y0);
}

/// The texels of a coarser level that the rectangle's texels are part of.
std::size_t DisplayTexels::sendReduced(const FaceTexels& texels, FaceId face, const Rect& rect)
{
    const TouchedRect touched = rect.of(face);
    const int level = onCard(face).level();
    const int steps = texels.level().log2() - level;
    const std::size_t least = rect.area();
    const std::vector<std::uint32_t> changed =
        least > 4 * kMostRead ? std::vector<std::uint32_t>()
                              : touchedAt(Level(level), texels.level(), touched);
    const std::size_t read = changed.size() << (2U * static_cast<unsigned>(steps));
    if (std::max(least, read) > 4 * kMostRead) {
        onCard(face).shown |= FaceOnCard::kStale;
        makeAgainLater({face, static_cast<std::uint8_t>(level)});
        return 0;
    }
    std::vector<std::byte> texel(texels.texelBytes());
    for (const std::uint32_t index : changed) {
        reducedTexel(m_form.format, texels, steps, static_cast<TexelIndex>(index), texel);
        const std::size_t before = m_bytes.size();
        appendShown(m_form.format, m_form.channels, texel, m_bytes);
        write(face, static_cast<std::uint8_t>(level), index, before);
    }
    return read;
}

/// The mean, or one texel until a job has made it.
std::size_t DisplayTexels::sendMean(const FaceTexels& texels, FaceId face)
{
    if (!texels.isConstant() && texels.level().texelCount() > kMostRead) {
        makeAgainLater({face, 0});
        return 0;
    }
    const std::size_t before = m_bytes.size();
    appendAtLevel(m_form, texels, Level(), m_bytes);
    write(face, 0, 0, before);
    return texels.isConstant() ? 1 : texels.level().texelCount();
}

} // namespace trixel::render

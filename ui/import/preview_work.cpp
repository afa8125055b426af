// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/preview_work.h"

#include "core/base/check.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace trixel::ui {

namespace {

/// Texels that each pass may look up: some tens of milliseconds, half a second, several.
constexpr std::array<std::uint64_t, 3> kPassTexels = {40'000, 800'000, 8'000'000};

FaceTexels coarser(const TexelFormat& format, const FaceTexels& face, Level level)
{
    if (face.hasStoredLevel(level)) {
        if (auto stored = face.storedLevel(level)) {
            return *stored;
        }
    }
    return reduced(format, face.pinned(), face.level().log2() - level.log2());
}

double secondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

CoarseFaces::CoarseFaces(TexelStore texels)
    : m_texels(std::move(texels))
{
}

void CoarseFaces::prepare(std::span<const FaceId> faces, Level level)
{
    if (m_level != level) {
        m_level = level;
        m_faces = FaceMap<FaceTexels>(m_texels.faceCount());
        m_isMade.assign(m_texels.faceCount(), 0);
    }
    parallelFor(faces.size(), 64, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const FaceTexels& own = m_texels.face(faces[k]);
            std::uint8_t& isMade = m_isMade[indexOf(faces[k])];
            if (isMade == 0) {
                const bool isFiner = own.level().log2() > level.log2();
                m_faces[faces[k]] = isFiner ? coarser(m_texels.format(), own, level) : own;
                isMade = 1;
            }
        }
    });
}

PreviewMaker::PreviewMaker(ImportInput input, std::shared_ptr<CoarseFaces> coarse)
    : m_input(std::move(input))
    , m_coarse(std::move(coarse))
{
}

std::uint64_t PreviewMaker::texelsAt(Level level) const
{
    std::uint64_t texels = 0;
    for (std::size_t n = 0; n < m_facesOfLevel.size(); ++n) {
        const int shown = std::min(static_cast<int>(n), level.log2());
        texels += m_facesOfLevel[n] * Level(shown).texelCount();
    }
    return texels;
}

/// Level 0 where nothing is.
Level PreviewMaker::finestWithin(std::uint64_t texels) const
{
    int level = m_highest.log2();
    while (level > 0 && texelsAt(Level(level)) > texels) {
        --level;
    }
    return Level(level);
}

/// Passes that would show nothing new are left out.
void PreviewMaker::choosePass()
{
    const bool isFirst = m_pass == 0;
    const Level before = m_level;
    while (m_pass < kPassTexels.size()) {
        m_level = finestWithin(kPassTexels[m_pass++]);
        if (isFirst || m_level != before) {
            return;
        }
    }
    m_isDone = true;
}

Result<std::shared_ptr<const PreviewPicture>> PreviewMaker::next(Progress& progress)
{
    if (!m_prepared) {
        auto prepared = prepareImport(m_input, progress);
        if (!prepared) {
            m_isDone = true;
            return tl::unexpected(prepared.error());
        }
        m_prepared = std::move(*prepared);
        m_facesOfLevel.assign(Level::kMax + 1, 0);
        for (const FaceId face : m_prepared->faces) {
            const Level level = m_coarse->texels().face(face).level();
            ++m_facesOfLevel[static_cast<std::size_t>(level.log2())];
            m_highest = std::max(m_highest, level);
        }
        choosePass();
    }
    const auto& faces = m_prepared->faces;
    TexelStore texels = m_coarse->texels();
    // What the quick passes need is kept for the next ones.
    CoarseFaces finer(m_coarse->texels());
    CoarseFaces& coarse = m_pass == 1 ? *m_coarse : finer;
    coarse.prepare(faces, m_level);
    for (const FaceId face : faces) {
        if (texels.face(face).level().log2() > m_level.log2()) {
            texels.exchange(face, coarse.face(face));
        }
    }
    const auto begin = std::chrono::steady_clock::now();
    auto patch = bake(texels,
                      faces,
                      *m_prepared->mapping.mapping,
                      *m_prepared->tiles,
                      m_prepared->options,
                      progress);
    if (!patch) {
        m_isDone = m_isDone || patch.error().kind != ErrorKind::Cancelled;
        return tl::unexpected(patch.error());
    }
    auto picture = std::make_shared<PreviewPicture>();
    const double part = static_cast<double>(texelsAt(m_level));
    picture->seconds = secondsSince(begin) * static_cast<double>(texelsAt(m_highest)) / part;
    picture->isComplete = m_level == m_highest;
    // The others stay as fine as they are.
    patch->swap(texels);
    TexelStore shown = m_coarse->texels();
    for (const TexelPatch::Whole& whole : patch->wholeFaces()) {
        ++picture->facesReached;
        picture->texelsReached += shown.face(whole.face).level().texelCount();
        shown.exchange(whole.face, whole.texels);
    }
    picture->texels = std::move(shown);
    choosePass();
    return std::shared_ptr<const PreviewPicture>(std::move(picture));
}

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/compose.h"

#include "core/base/check.h"
#include "core/layers/face_layers.h"
#include "core/layers/replace_faces.h"

#include <algorithm>
#include <utility>

namespace trixel {

namespace {

/// Texels that one thread works on without a look at what is left.
constexpr std::size_t kPieceTexels = 16'384;
/// Texels for which another thread is worth starting.
constexpr std::size_t kTexelsPerThread = 100'000;
/// Between two reports: what a core does in some hundredths of a second.
constexpr std::size_t kReportTexels = std::size_t{1} << 22U;
constexpr std::size_t kReportFaces = 4096;

Threads threadsFor(std::size_t texels, Threads threads)
{
    const std::size_t useful = std::max<std::size_t>(1, texels / kTexelsPerThread);
    return {static_cast<unsigned>(std::min<std::size_t>(threads.count, useful))};
}

/// A rectangle of one face to be shown anew. Faces go through three steps: their layers are looked
/// up, in parallel; room is made in the store, one after the other; texels are composed, in
/// parallel over pieces, so that a large face has several threads.
struct Job
{
    TouchedRect rect;
    FaceLayers layers;
    FaceTexels whole;            ///< of a face that is shown anew as a whole
    std::span<std::byte> texels; ///< all of the face, to be written to; none where that is done

    std::size_t texelCount() const { return std::size_t{rect.width} * rect.height; }
};

/// Some rows of a job.
struct Piece
{
    const Job* job = nullptr;
    std::uint32_t firstRow = 0, rows = 0;
};

/// The stack's faces, composed into a store.
class FaceComposer
{
public:
    FaceComposer(const LayerStack& layers, TexelStore& shown, Threads threads)
        : m_base(layers.base())
        , m_shown(shown)
        , m_threads(threads)
        , m_layers(shownLayers(layers))
        , m_composer(layers.base().format())
    {
        check(shown.faceCount() == m_base.faceCount() && shown.format() == m_base.format(),
              "what the stack looks like");
    }

    void addFace(FaceId face)
    {
        const auto side = static_cast<std::uint16_t>(m_base.face(face).level().resolution());
        m_jobs.push_back({{face, 0, 0, side, side, true}, {}, {}, {}});
        m_texels += m_jobs.back().texelCount();
    }

    void addRect(const TouchedRect& rect)
    {
        if (rect.wholeFace) {
            addFace(rect.face);
            return;
        }
        const Level level = m_base.face(rect.face).level();
        check(m_shown.face(rect.face).level() == level &&
                  rect.x + std::uint32_t{rect.width} <= level.resolution() &&
                  rect.y + std::uint32_t{rect.height} <= level.resolution(),
              "a rectangle of the face");
        if (rect.width > 0 && rect.height > 0) {
            m_jobs.push_back({rect, {}, {}, {}});
            m_texels += m_jobs.back().texelCount();
        }
    }

    std::size_t jobCount() const { return m_jobs.size(); }
    std::size_t texelCount() const { return m_texels; }

    /// Does what was added. \return  the first face that could not be read, if any
    std::optional<FaceId> run()
    {
        const Threads threads = threadsFor(m_texels, m_threads);
        parallelFor(m_jobs.size(), 16, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                prepare(m_jobs[k]);
            }
        });
        for (Job& job : m_jobs) {
            if (!job.rect.wholeFace) {
                job.texels = m_shown.writable(job.rect.face);
            }
        }
        composePieces(threads);
        return finish();
    }

private:
    void prepare(Job& job) const
    {
        job.layers = layersOfFace(m_base, m_layers, job.rect.face);
        if (job.rect.wholeFace) {
            dropUncovered(m_base.format(), job.layers);
            startWhole(job);
        }
    }

    void startWhole(Job& job) const
    {
        const FaceLayers& layers = job.layers;
        if (layers.over.empty()) {
            job.whole = layers.isBase ? m_base.face(job.rect.face) : layers.base;
        } else if (layers.isConstant()) {
            std::vector<std::byte> texel(m_base.format().texelBytes());
            m_composer.compose(layers.base, layers.over, 0, texel);
            job.whole = FaceTexels::constant(layers.base.level(), texel);
        } else {
            job.whole = layers.base; // a damaged one stays marked
            job.texels = job.whole.writable();
        }
    }

    void composePieces(Threads threads) const
    {
        std::vector<Piece> pieces;
        for (const Job& job : m_jobs) {
            const std::uint32_t rows = std::max<std::uint32_t>(
                1, static_cast<std::uint32_t>(kPieceTexels / job.rect.width));
            for (std::uint32_t row = 0; row < job.rect.height && !job.texels.empty(); row += rows) {
                pieces.push_back({&job, row, std::min(rows, job.rect.height - row)});
            }
        }
        parallelFor(pieces.size(), 4, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                compose(pieces[k]);
            }
        });
    }

    void compose(const Piece& piece) const
    {
        const TouchedRect& rect = piece.job->rect;
        const FaceLayers& layers = piece.job->layers;
        const std::size_t texelBytes = m_base.format().texelBytes();
        const std::size_t side = layers.base.level().resolution();
        const bool isSolid = rect.width == side; // rows follow each other
        const std::size_t runs = isSolid ? 1 : piece.rows;
        const std::size_t length = isSolid ? piece.rows * side : rect.width;
        for (std::size_t run = 0; run < runs; ++run) {
            const std::size_t first = (rect.y + piece.firstRow + run) * side + rect.x;
            m_composer.compose(layers.base,
                               layers.over,
                               first,
                               piece.job->texels.subspan(first * texelBytes, length * texelBytes));
        }
    }

    std::optional<FaceId> finish()
    {
        std::optional<FaceId> damaged;
        FaceTexels last; // one value for neighbours that are alike
        for (Job& job : m_jobs) {
            if (job.layers.isDamaged && !damaged) {
                damaged = job.rect.face;
            }
            if (!job.rect.wholeFace) {
                continue;
            }
            FaceTexels& face = job.whole;
            if (face.isConstant() && last.texelBytes() > 0 &&
                std::ranges::equal(face.bytes(), last.bytes())) {
                face = last.atLevel(face.level());
            } else if (face.isConstant()) {
                last = face;
            }
            m_shown.exchange(job.rect.face, std::move(face));
        }
        m_jobs.clear();
        m_texels = 0;
        return damaged;
    }

    const TexelStore& m_base;
    TexelStore& m_shown;
    Threads m_threads;
    std::vector<const Layer*> m_layers;
    TexelComposer m_composer;
    std::vector<Job> m_jobs;
    std::size_t m_texels = 0;
};

bool isCovered(std::span<const Layer* const> shown, FaceId face)
{
    return std::ranges::any_of(shown, [=](const Layer* layer) { return mayCover(*layer, face); });
}

/// \return  the stack as it looks, in the place of \p shown where `faces` say so
Result<Layered> composedFaces(LayerStack layers,
                              std::span<const FaceId> faces,
                              TexelStore shown,
                              Threads threads,
                              Progress& progress)
{
    FaceComposer composer(layers, shown, threads);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        composer.addFace(faces[k]);
        if (k + 1 < faces.size() && composer.jobCount() < kReportFaces &&
            composer.texelCount() < kReportTexels) {
            continue;
        }
        if (const auto damaged = composer.run()) {
            return unreadFace(*damaged);
        }
        if (!progress.report(static_cast<double>(k + 1) / static_cast<double>(faces.size()))) {
            return cancelled();
        }
    }
    return Layered{std::move(shown), std::move(layers)};
}

} // namespace

Result<Layered> composed(LayerStack layers, Threads threads, Progress& progress)
{
    return recomposed(std::move(layers), Layered(), threads, progress);
}

Result<Layered>
recomposed(LayerStack layers, const Layered& before, Threads threads, Progress& progress)
{
    if (layers.isPlain()) {
        return Layered{layers.base(), {}};
    }
    TexelStore shown = layers.base(); // what nothing covers stays shared with it
    const bool isKin =
        before.shown.faceCount() == shown.faceCount() && before.shown.format() == shown.format();
    const TexelStore& baseBefore = before.layers.isPlain() ? before.shown : before.layers.base();
    const std::vector<const Layer*> visible = shownLayers(layers);
    const std::vector<const Layer*> visibleBefore = shownLayers(before.layers);
    std::vector<FaceId> due;
    for (std::uint32_t f = 0; f < shown.faceCount(); ++f) {
        const FaceId face = faceId(f);
        if (!isCovered(visible, face)) {
            continue;
        }
        if (isKin && showAlike(layers.base(), visible, baseBefore, visibleBefore, face)) {
            shown.exchange(face, before.shown.face(face));
        } else {
            due.push_back(face);
        }
    }
    return composedFaces(std::move(layers), due, std::move(shown), threads, progress);
}

void recompose(const LayerStack& layers,
               std::span<const TouchedRect> rects,
               TexelStore& shown,
               Threads threads)
{
    FaceComposer composer(layers, shown, threads);
    for (const TouchedRect& rect : rects) {
        composer.addRect(rect);
    }
    composer.run();
}

void recompose(const LayerStack& layers,
               std::span<const FaceId> faces,
               TexelStore& shown,
               Threads threads)
{
    FaceComposer composer(layers, shown, threads);
    for (const FaceId face : faces) {
        composer.addFace(face);
    }
    composer.run();
}

} // namespace trixel

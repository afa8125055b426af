// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/layered_texels.h"

#include "core/base/check.h"
#include "core/io/layers_metadata.h"
#include "core/io/ptx_reader.h"
#include "core/texture/level_change.h"
#include "core/texture/pinned_face.h"
#include "core/texture/stored_faces.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace trixel {

namespace {

/// A face in memory, beside its texels.
constexpr std::uint64_t kFaceBytes = 96;

TexelFormat sideBySideFormat(const LayerStack& layers)
{
    TexelFormat format = layers.base().format();
    const std::size_t channels = format.channels + layers.layers().size() * (format.channels + 1U);
    format.channels = static_cast<std::uint16_t>(channels);
    return format;
}

/// The base and the layers, bottom to top.
std::vector<const TexelStore*> storesOf(const LayerStack& layers)
{
    std::vector<const TexelStore*> stores{&layers.base()};
    for (const Layer& layer : layers.layers()) {
        stores.push_back(&layer.texels);
    }
    return stores;
}

/// Puts a face's texels into their place in texels that are wider.
/// \param to  from the first of the bytes they take in the first texel
void spread(const FaceTexels& face, std::size_t wide, std::span<std::byte> to)
{
    const std::size_t own = face.texelBytes();
    const std::size_t step = face.isConstant() ? 0 : own;
    const std::byte* from = face.bytes().data();
    for (std::size_t at = 0; at < to.size(); at += wide, from += step) {
        std::memcpy(to.data() + at, from, own);
    }
}

/// Puts faces of a stack together.
class LayersReader final : public FaceReader
{
public:
    explicit LayersReader(LayerStack layers)
        : m_layers(std::move(layers))
        , m_mean(sideBySideFormat(m_layers).texelBytes())
    {
    }

    Result<bool> read(FaceId face, Level level, std::span<std::byte> texels) const override
    {
        std::size_t begin = 0;
        for (const TexelStore* store : storesOf(m_layers)) {
            const PinnedFace part(store->face(face));
            check(part->level() == level, "all layers at the level of the base");
            if (part->isDamaged()) {
                return contentsError("face " + std::to_string(indexOf(face)) +
                                     " could not be read from its file");
            }
            spread(*part, m_mean.size(), texels.subspan(begin));
            begin += part->texelBytes();
        }
        return true;
    }
    bool stores(FaceId /*face*/, Level /*level*/) const override { return false; }
    /// Of no use: what is written is read whole.
    std::span<const std::byte> mean(FaceId /*face*/) const override { return m_mean; }

private:
    LayerStack m_layers;
    std::vector<std::byte> m_mean;
};

/// Values of constant faces side by side; faces in a row that share theirs go on sharing.
class ConstantFaces
{
public:
    explicit ConstantFaces(const LayerStack& layers)
        : m_stores(storesOf(layers))
        , m_texel(sideBySideFormat(layers).texelBytes())
    {
    }

    bool isConstant(FaceId face) const
    {
        return std::ranges::all_of(
            m_stores, [&](const TexelStore* store) { return store->face(face).isConstant(); });
    }

    /// \param face  constant
    FaceTexels face(FaceId face)
    {
        const Level level = m_stores.front()->face(face).level();
        const bool alike = m_last && std::ranges::all_of(m_stores, [&](const TexelStore* store) {
                               return store->face(face).sharesBytesWith(store->face(*m_last));
                           });
        if (!alike) {
            std::size_t begin = 0;
            for (const TexelStore* store : m_stores) {
                const std::span<const std::byte> part = store->face(face).bytes();
                std::ranges::copy(part, m_texel.begin() + static_cast<std::ptrdiff_t>(begin));
                begin += part.size();
            }
            m_face = FaceTexels::constant(level, m_texel);
            m_last = face;
        }
        return m_face.atLevel(level);
    }

private:
    std::vector<const TexelStore*> m_stores;
    std::vector<std::byte> m_texel;
    std::optional<FaceId> m_last;
    FaceTexels m_face;
};

/// Some bytes of every texel of a face; one value where they are all alike.
FaceTexels slice(const FaceTexels& face, std::size_t begin, std::size_t bytes)
{
    const std::span<const std::byte> all = face.bytes();
    const std::size_t wide = face.texelBytes();
    const std::byte* first = all.data() + begin;
    std::size_t at = wide;
    while (at < all.size() && std::memcmp(first + at, first, bytes) == 0) {
        at += wide;
    }
    if (at >= all.size()) {
        return FaceTexels::constant(face.level(), {first, bytes});
    }
    std::vector<std::byte> texels(all.size() / wide * bytes);
    std::byte* to = texels.data();
    for (at = 0; at < all.size(); at += wide, to += bytes) {
        std::memcpy(to, first + at, bytes);
    }
    return FaceTexels::full(face.level(), bytes, texels);
}

bool isUncovered(const FaceTexels& face)
{
    return face.isConstant() &&
           std::ranges::all_of(face.bytes(), [](std::byte value) { return value == std::byte{}; });
}

/// Takes the faces of a file apart, batch by batch.
class Splitter
{
public:
    Splitter(const PtxFile& file, const TexelFormat& base, std::size_t layers, MemoryBudget& budget)
        : m_base(base)
        , m_layerFormat(layerFormat(base))
        , m_budget(budget)
    {
        FaceMap<Level> levels(file.faceCount(), Level());
        for (std::size_t f = 0; f < file.faceCount(); ++f) {
            levels[faceId(f)] = file.info(faceId(f)).level();
        }
        m_stores.emplace_back(base, levels, std::vector<std::byte>(base.texelBytes()));
        const TexelStore uncovered(m_layerFormat, levels, uncoveredTexel(base));
        m_stores.insert(m_stores.end(), layers, uncovered);
        m_previous.resize(m_stores.size());
    }

    /// \param faces  of the file, from `first` on
    void add(FaceId first, std::span<std::optional<FaceTexels>> faces, Threads threads)
    {
        if (!m_status) {
            return;
        }
        std::vector<FaceTexels> parts(faces.size() * m_stores.size());
        parallelFor(faces.size(), 16, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                split(*faces[k], std::span(parts).subspan(k * m_stores.size(), m_stores.size()));
                faces[k].reset();
            }
        });
        for (std::size_t k = 0; k < faces.size() && m_status; ++k) {
            keep(faceId(indexOf(first) + k),
                 std::span(parts).subspan(k * m_stores.size(), m_stores.size()));
        }
    }

    const Status& status() const { return m_status; }

    LayerStack take(std::vector<LayerSettings> settings)
    {
        LayerStack stack(std::move(m_stores.front()));
        for (std::size_t k = 0; k < settings.size(); ++k) {
            stack.insert(k, std::move(settings[k]), std::move(m_stores[k + 1]));
        }
        return stack;
    }

private:
    void split(const FaceTexels& face, std::span<FaceTexels> parts) const
    {
        std::size_t begin = 0;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const std::size_t bytes = (k == 0 ? m_base : m_layerFormat).texelBytes();
            parts[k] = slice(face, begin, bytes);
            begin += bytes;
        }
    }

    void keep(FaceId face, std::span<FaceTexels> parts)
    {
        bool isCovered = false;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            if (k > 0 && isUncovered(parts[k])) {
                take(sizeof(FaceTexels)); // its place beside faces that are covered
                continue;
            }
            isCovered = isCovered || k > 0;
            FaceTexels& previous = m_previous[k];
            const bool alike = parts[k].isConstant() && previous.isConstant() &&
                               std::ranges::equal(parts[k].bytes(), previous.bytes());
            previous = alike ? previous.atLevel(parts[k].level()) : parts[k];
            take(kFaceBytes + (alike ? 0 : parts[k].byteCount()));
            m_stores[k].exchange(face, previous);
        }
        // What is shown is a store of its own where a layer changes it.
        take(
            kFaceBytes +
            (isCovered ? parts[0].level().texelCount() * std::uint64_t{parts[0].texelBytes()} : 0));
    }

    void take(std::uint64_t bytes)
    {
        if (m_status) {
            m_status = m_budget.take(bytes, "the layers");
        }
    }

    TexelFormat m_base;
    TexelFormat m_layerFormat;
    MemoryBudget& m_budget;
    std::vector<TexelStore> m_stores;
    std::vector<FaceTexels> m_previous; ///< the last that was kept, of each store
    Status m_status;
};

/// Stops where the memory does not last.
class SplitProgress final : public Progress
{
public:
    SplitProgress(Progress& progress, const Status& status)
        : m_progress(progress)
        , m_status(status)
    {
    }
    bool report(double fraction) override { return m_progress.report(fraction) && m_status; }

private:
    Progress& m_progress;
    const Status& m_status;
};

} // namespace

TexelStore sideBySide(const LayerStack& layers)
{
    check(!layers.isPlain(), "layers");
    const TexelFormat format = sideBySideFormat(layers);
    const auto faces = StoredFaces::make(format, std::make_unique<LayersReader>(layers), 0);
    const std::vector<std::byte> none(format.texelBytes());
    const FaceMap<Level> levels = levelsOf(layers.base());
    TexelStore store(format, levels, none);
    ConstantFaces constant(layers);
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const FaceId face = faceId(f);
        store.exchange(face,
                       constant.isConstant(face) ? constant.face(face)
                                                 : faces->face(face, levels[face]));
    }
    return store;
}

Result<LayerStack> readLayers(const PtxFile& file,
                              std::vector<LayerSettings> settings,
                              MemoryBudget& budget,
                              Threads threads,
                              Progress& progress)
{
    check(!settings.empty(), "layers");
    const auto base = baseFormat(file.format(), settings.size());
    if (!base) {
        return tl::unexpected(base.error());
    }
    Splitter splitter(file, *base, settings.size(), budget);
    SplitProgress reading(progress, splitter.status());
    const Status read = decodePtxFaces(
        file, 0, threads, reading, [&](FaceId first, std::span<std::optional<FaceTexels>> faces) {
            splitter.add(first, faces, threads);
        });
    if (!splitter.status() || !read) {
        return tl::unexpected(splitter.status() ? read.error() : splitter.status().error());
    }
    return splitter.take(std::move(settings));
}

} // namespace trixel

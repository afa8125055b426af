// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_source.h"

#include "core/filter/filter_method.h"
#include "core/study/fit/fit_parallel.h"
#include "core/texture/convert.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

namespace trixel {
namespace {

/// Queries between two reports.
constexpr std::size_t kBatch = 512;

std::pair<float, float> spanOf(const TexelStore& floats)
{
    float least = std::numeric_limits<float>::max();
    float most = std::numeric_limits<float>::lowest();
    for (std::uint32_t f = 0; f < floats.faceCount(); ++f) {
        const auto bytes = floats.face(faceId(f)).bytes();
        for (std::size_t at = 0; at < bytes.size(); at += sizeof(float)) {
            float value = 0;
            std::memcpy(&value, bytes.data() + at, sizeof(float));
            if (std::isfinite(value)) {
                least = std::min(least, value);
                most = std::max(most, value);
            }
        }
    }
    return least <= most ? std::pair(least, most) : std::pair(0.0F, 0.0F);
}

} // namespace

Result<std::vector<float>> seenThroughExact(const FilterScene& scene,
                                            const QueryArrays& queries,
                                            Threads threads,
                                            Progress& progress)
{
    ResultArrays results(queries.size(), scene.channels());
    const auto exact = makeMethod({"exact", std::nullopt});
    const std::size_t batches = (queries.size() + kBatch - 1) / kBatch;
    const Status status = forEachInParallel(batches, threads, progress, [&](std::size_t b) {
        const std::size_t first = b * kBatch;
        const std::size_t count = std::min(kBatch, queries.size() - first);
        FilterResults part = results.results();
        part.values = part.values.subspan(first);
        part.levels = part.levels.subspan(first, count);
        part.taps = part.taps.subspan(first, count);
        exact->filter(scene, queries.queries().subspan(first, count), part);
    });
    if (!status) {
        return tl::unexpected(status.error());
    }
    return std::move(results.values);
}

Result<FitSource> FitSource::make(const Surface& surface,
                                  const TexelStore& texels,
                                  const SceneViews& views,
                                  UnseenFaces unseen,
                                  Threads threads,
                                  Progress& progress)
{
    FitSource source;
    source.texels = texels;
    StageProgress converting(progress, 0, 0.3);
    auto floats = converted(texels, TexelType::Float, threads, converting);
    if (!floats) {
        return tl::unexpected(floats.error());
    }
    source.floats = std::move(*floats);
    source.shapes = std::make_shared<FilterSurface>(
        FilterSurface::fromMesh(surface.mesh(), surface.adjacency()));
    StageProgress building(progress, 0.3, 0.9);
    auto scene = FilterScene::build(source.shapes, texels, threads, building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    source.scene = std::move(*scene);
    FaceMap<Level> levels(texels.faceCount());
    for (std::uint32_t f = 0; f < texels.faceCount(); ++f) {
        levels[faceId(f)] = texels.face(faceId(f)).level();
    }
    StageProgress looking(progress, 0.9, 1);
    const auto faceViews = FaceViews::find(surface, views, unseen, threads, looking);
    if (!faceViews) {
        return tl::unexpected(faceViews.error());
    }
    source.samples = fitSamples(surface, *source.shapes, levels, *faceViews, threads);
    source.rim = fitRim(surface, source.shapes->rings(), source.samples);
    source.isUnseen = FaceMap<char>(texels.faceCount());
    for (std::uint32_t f = 0; f < texels.faceCount(); ++f) {
        source.isUnseen[faceId(f)] = faceViews->isSeen(faceId(f)) ? 0 : 1;
    }
    const TexelType type = texels.format().type;
    if (type == TexelType::Half || type == TexelType::Float) {
        std::tie(source.least, source.most) = spanOf(source.floats);
    }
    return source;
}

double FitSource::spacing(FaceId face) const
{
    return std::min(samples.spacing[face], rim.spacing[face]);
}

double FitSource::weight(FaceId face) const
{
    constexpr double kRimWeight = 0.1;
    if (samples.isJudged(face) || !rim.contains(face)) {
        return samples.pixels[face];
    }
    const FaceShape& shape = shapes->shape(face);
    return kRimWeight * shape.e1.x * shape.e2.y / 2 / (rim.spacing[face] * rim.spacing[face]);
}

} // namespace trixel

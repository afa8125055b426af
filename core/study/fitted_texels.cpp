// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fitted_texels.h"

#include "core/lattice/texel.h"
#include "core/texture/convert.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace trixel {
namespace {

/// Pixels this much wider than a coarse texel do not notice its floor.
constexpr double kWidePixel = 4;

/// Steps of Richardson's iteration (over-relaxation by the roots of a Chebyshev polynomial), which
/// after all of them leaves least of what the filter lets through by 0.25 to 1 of its strength. The
/// large and the small take turns, so that nothing grows on the way.
constexpr std::array<double, 5> kSteps = {1.019, 3.726, 1.183, 2.472, 1.6};

std::vector<float>
seenThroughExact(const FilterScene& scene, const QueryArrays& queries, Threads threads)
{
    ResultArrays results(queries.size(), scene.channels());
    const auto exact = makeMethod({"exact", std::nullopt});
    filterParallel(*exact, scene, queries.queries(), results.results(), threads);
    return std::move(results.values);
}

void addTexels(const FitSource& source, FaceId face, Level level, QueryArrays& queries)
{
    const auto [w1, w2] = roundFootprint(source.shapes->shape(face), source.samples.spacing[face]);
    for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
        const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
        queries.add(face, glm::vec2(uv), w1, w2);
    }
}

/// The part of each channel that belongs to one face's texels, joined.
std::vector<float>
partOf(std::span<const float> values, std::size_t queries, std::size_t first, std::size_t count)
{
    std::vector<float> part;
    for (std::size_t channel = 0; channel < values.size(); channel += queries) {
        const auto from = values.subspan(channel + first, count);
        part.insert(part.end(), from.begin(), from.end());
    }
    return part;
}

/// Moves a face's texels by a step of what is missing.
/// \param seen  from the face's first texel on, channels `stride` apart
void moveFace(const FitSource& source,
              std::span<const float> wanted,
              std::span<const float> seen,
              std::size_t stride,
              double step,
              std::span<std::byte> texels)
{
    const std::size_t channels = source.texels.format().channels;
    const std::size_t count = wanted.size() / channels;
    for (std::size_t t = 0; t < count; ++t) {
        for (std::size_t c = 0; c < channels; ++c) {
            const float missing = wanted[c * count + t] - seen[c * stride + t];
            if (!std::isfinite(missing)) {
                continue;
            }
            std::byte* at = texels.data() + (t * channels + c) * sizeof(float);
            float value = 0;
            std::memcpy(&value, at, sizeof(float));
            value =
                std::clamp(value + static_cast<float>(step) * missing, source.least, source.most);
            std::memcpy(at, &value, sizeof(float));
        }
    }
}

/// Faces that kept their level take their bytes back; so do constant ones, at theirs.
TexelStore inFormat(const FitSource& source, const TexelStore& coarse)
{
    const TexelFormat& format = source.texels.format();
    TexelStore result = source.texels;
    std::vector<std::byte> bytes;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceTexels& face = coarse.face(faceId(f));
        const FaceTexels& original = source.texels.face(faceId(f));
        if (face.level() == original.level()) {
            continue;
        }
        if (original.isConstant()) {
            result.exchange(faceId(f), original.atLevel(face.level()));
            continue;
        }
        std::vector<float> values(face.bytes().size() / sizeof(float));
        std::memcpy(values.data(), face.bytes().data(), face.bytes().size());
        bytes.resize(values.size() * byteSize(format.type));
        encode(format.type, values, bytes);
        result.exchange(faceId(f), FaceTexels::full(face.level(), format.texelBytes(), bytes));
    }
    return result;
}

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

Result<FitSource> FitSource::make(const Surface& surface,
                                  const TexelStore& texels,
                                  const SceneViews& views,
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
    source.samples = fitSamples(surface, *source.shapes, levels, views, threads);
    const TexelType type = texels.format().type;
    if (type == TexelType::Half || type == TexelType::Float) {
        std::tie(source.least, source.most) = spanOf(source.floats);
    }
    return source;
}

/// Faces whose texels are to be corrected, and where they are looked at.
struct Coarsener::Correction
{
    QueryArrays queries;
    std::vector<FaceId> faces;
    std::vector<std::size_t> begin; ///< of each face's texels among the queries
};

Coarsener::Coarsener(const FitSource& source)
    : m_source(source)
{
    m_wanted.resize(Level::kMax + 1);
}

bool Coarsener::isCorrected(const TexelStore& coarse, FaceId face) const
{
    const FaceTexels& texels = coarse.face(face);
    if (texels.isConstant() || !m_source.samples.isSeen(face) ||
        texels.level() == m_source.texels.face(face).level()) {
        return false;
    }
    const double edge =
        std::exp2(m_source.shapes->log2Length(face, glm::dvec2(1.0 / 3.0)) - texels.level().log2());
    return m_source.samples.spacing[face] < kWidePixel * edge;
}

Coarsener::Correction Coarsener::correctionOf(const TexelStore& coarse) const
{
    Correction correction;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        if (isCorrected(coarse, faceId(f))) {
            correction.faces.push_back(faceId(f));
            correction.begin.push_back(correction.queries.size());
            addTexels(m_source, faceId(f), coarse.face(faceId(f)).level(), correction.queries);
        }
    }
    return correction;
}

void Coarsener::remember(const TexelStore& coarse, const Correction& correction, Threads threads)
{
    QueryArrays queries;
    std::vector<FaceId> faces;
    for (const FaceId face : correction.faces) {
        const Level level = coarse.face(face).level();
        auto& known = m_wanted[static_cast<std::size_t>(level.log2())];
        if (known.size() == 0) {
            known = FaceMap<std::vector<float>>(coarse.faceCount());
        }
        if (known[face].empty()) {
            faces.push_back(face);
            addTexels(m_source, face, level, queries);
        }
    }
    const auto values = seenThroughExact(m_source.scene, queries, threads);
    std::size_t first = 0;
    for (const FaceId face : faces) {
        const Level level = coarse.face(face).level();
        m_wanted[static_cast<std::size_t>(level.log2())][face] =
            partOf(values, queries.size(), first, level.texelCount());
        first += level.texelCount();
    }
}

Status Coarsener::correct(TexelStore& coarse, Threads threads, Progress& progress)
{
    const Correction correction = correctionOf(coarse);
    if (correction.faces.empty()) {
        return {};
    }
    remember(coarse, correction, threads);
    NoProgress unseen;
    const std::size_t count = correction.queries.size();
    for (std::size_t k = 0; k < kSteps.size(); ++k) {
        if (!progress.report((static_cast<double>(k) + 0.5) / (kSteps.size() + 1.0))) {
            return cancelled();
        }
        const auto scene = FilterScene::build(m_source.shapes, coarse, threads, unseen);
        const auto seen = seenThroughExact(*scene, correction.queries, threads);
        for (std::size_t i = 0; i < correction.faces.size(); ++i) {
            const FaceId face = correction.faces[i];
            const auto level = static_cast<std::size_t>(coarse.face(face).level().log2());
            moveFace(m_source,
                     m_wanted[level][face],
                     std::span(seen).subspan(correction.begin[i]),
                     count,
                     kSteps[k],
                     coarse.writable(face));
        }
    }
    return {};
}

Result<TexelStore>
Coarsener::coarsened(const FaceMap<Level>& levels, Threads threads, Progress& progress)
{
    TexelStore coarse = m_source.floats;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceTexels& face = m_source.floats.face(faceId(f));
        const int steps = face.level().log2() - levels[faceId(f)].log2();
        check(steps >= 0, "levels that only become coarser");
        if (steps > 0) {
            coarse.exchange(faceId(f), reduced(coarse.format(), face, steps));
        }
    }
    if (const Status status = correct(coarse, threads, progress); !status) {
        return tl::unexpected(status.error());
    }
    return inFormat(m_source, coarse);
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/reduction.h"
#include "core/study/error_sums.h"
#include "core/study/machine.h"
#include "core/study/small_studies.h"
#include "core/study/speed/contest.h"
#include "core/study/study_signal.h"
#include "core/study/test_scene.h"
#include "core/texture/convert.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace trixel {
namespace {

constexpr std::array<TexelType, 4> kTypes = {
    TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float};
constexpr std::size_t kChannels = 3;

/// The natural tile with a slow sine over it, so that no texel lies on the grid of uint8.
TexelStore naturalInFloat(const TexelStore& tile)
{
    const TexelFormat format{TexelType::Float, kChannels, std::nullopt};
    const std::array<std::byte, 4 * kChannels> black{};
    TexelStore store(kTileFaces, format, kTileLevel, black);
    std::array<float, kChannels> value{};
    for (std::uint32_t f = 0; f < kTileFaces; ++f) {
        const auto to = store.writable(faceId(f));
        for (std::uint32_t t = 0; t < kTileLevel.texelCount(); ++t) {
            decode(TexelType::UInt8, tile.face(faceId(f)).texel(t), value);
            const glm::dvec2 uv = centroid(kTileLevel, texelAt(kTileLevel, TexelIndex{t}));
            const float light = 0.8F + 0.2F * static_cast<float>(studySine(kTileLevel, uv));
            for (float& channel : value) {
                channel *= light;
            }
            encode(TexelType::Float, value, to.subspan(t * sizeof(value), sizeof(value)));
        }
    }
    return store;
}

/// The texels of a face of floats, `steps` levels down, in double; channels interleaved.
std::vector<double> meansOf(const FaceTexels& face, int steps)
{
    std::vector<float> texels(kChannels * face.level().texelCount());
    decode(TexelType::Float, face.bytes(), texels);
    std::vector<double> values(texels.begin(), texels.end());
    Level level = face.level();
    for (int step = 0; step < steps; ++step) {
        std::vector<double> coarse(values.size() / 4);
        for (std::uint32_t t = 0; t < level.coarser().texelCount(); ++t) {
            const PackedPixel pixel = packedPixel(level.coarser(), TexelIndex{t});
            for (const PackedPixel& finer : finerPixels(level, pixel)) {
                const std::size_t from = indexOf(texelIndex(level, finer));
                for (std::size_t c = 0; c < kChannels; ++c) {
                    coarse[kChannels * t + c] += values[kChannels * from + c] / 4;
                }
            }
        }
        values = std::move(coarse);
        level = level.coarser();
    }
    return values;
}

/// Stored mips, `steps` levels down, against unrounded ones.
void judgeMips(
    const TexelStore& truth, const TexelStore& stored, int steps, ErrorSums& errors, double& drift)
{
    double sum = 0;
    for (std::uint32_t f = 0; f < truth.faceCount(); ++f) {
        const FaceTexels coarse = reduced(stored.format(), stored.face(faceId(f)), steps);
        const std::vector<double> wanted = meansOf(truth.face(faceId(f)), steps);
        const Level level = coarse.level();
        std::vector<float> found(wanted.size());
        if (coarse.isConstant()) {
            for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
                decode(stored.format().type,
                       coarse.texel(t),
                       std::span(found).subspan(kChannels * t, kChannels));
            }
        } else {
            decode(stored.format().type, coarse.bytes(), found);
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            errors.add(static_cast<double>(found[k]), wanted[k], 1);
            sum += static_cast<double>(found[k]) - wanted[k];
        }
    }
    drift = sum / static_cast<double>(errors.count());
}

Result<ResultArrays>
filtered(const TexelStore& store, const QueryArrays& queries, Progress& progress)
{
    auto surface =
        std::make_shared<const FilterSurface>(FilterSurface::equilateral(tileAdjacency()));
    const auto scene = FilterScene::build(std::move(surface), store, Threads::all(), progress);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    ResultArrays answers(queries.size(), kChannels);
    const auto method = makeMethod(MethodChoice{});
    filterParallel(*method, *scene, queries.queries(), answers.results(), Threads::all());
    return answers;
}

} // namespace

Result<Study> studyStorage(StudyWatcher& watcher)
{
    Study study;
    study.name = "storage";
    study.title = "Types of texels: memory against error, after mips and filtering";
    study.costTitle = "Memory per texel";
    study.costUnit = "bytes";
    study.subject = "natural tile, three channels";
    study.conditions = "mips stored in the type; filtered by " + toText(MethodChoice{});
    const auto data = parseTestData(storedTestFiles());
    if (!data) {
        return tl::unexpected(data.error());
    }
    const TexelStore truth = naturalInFloat(data->tiles[0]);
    StageProgress ignored(watcher, 0, 0.1);
    const auto rightAnswers = filtered(truth, data->queries, ignored);
    if (!rightAnswers) {
        return tl::unexpected(rightAnswers.error());
    }
    for (std::size_t k = 0; k < kTypes.size(); ++k) {
        const double begin = 0.1 + 0.9 * static_cast<double>(k) / kTypes.size();
        StageProgress stage(watcher, begin, begin + 0.9 / kTypes.size());
        if (!stage.report(0)) {
            return cancelled();
        }
        NoProgress quick;
        const auto stored = converted(truth, kTypes[k], Threads::all(), quick);
        StudyPoint point;
        point.series = nameOf(kTypes[k]);
        point.cost = static_cast<double>(stored->format().texelBytes());
        const auto add = [&](std::string variant, const ErrorSums& errors) {
            point.variant = std::move(variant);
            errors.tell(point);
            point.samples = errors.count();
            watcher.measured(point);
            study.points.push_back(point);
        };
        double drift = 0;
        for (const int steps : {0, 1, 2, 4, 6}) {
            ErrorSums errors;
            judgeMips(truth, *stored, steps, errors, drift);
            add(steps == 0 ? "texels" : "mips " + std::to_string(steps) + " down", errors);
        }
        const auto answers = filtered(*stored, data->queries, quick);
        ErrorSums errors;
        for (std::size_t i = 0; i < answers->values.size(); ++i) {
            errors.add(static_cast<double>(answers->values[i]),
                       static_cast<double>(rightAnswers->values[i]),
                       1);
        }
        add("filtered", errors);
        std::ostringstream note;
        note.precision(2);
        note << nameOf(kTypes[k]) << ": stored means of 64 × 64 texels drift by " << 255 * drift
             << " of 1/255 in the mean.";
        study.notes.push_back(note.str());
    }
    return study;
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/paint_projection.h"
#include "core/study/error_sums.h"
#include "core/study/machine.h"
#include "core/study/processor_clock.h"
#include "core/study/small_studies.h"
#include "core/study/study_signal.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace trixel {
namespace {

constexpr int kLowest = 2;
constexpr int kHighest = 9;

/// Where one pixel of the packed square was sampled; the half that painted it last counts.
struct Sampled
{
    glm::dvec2 uv{0};
    TexelHalf half = TexelHalf::Lower;
    int times = 0;
};

/// Both halves as a rasteriser draws them: pixels whose centre is inside the triangle or on its
/// border, the upper half after the lower one.
void rasterise(Level level, double offset, std::vector<Sampled>& pixels)
{
    constexpr double kOn = 1e-9;
    const std::uint32_t resolution = level.resolution();
    pixels.assign(level.texelCount(), {});
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        for (std::uint32_t y = 0; y < resolution; ++y) {
            for (std::uint32_t x = 0; x < resolution; ++x) {
                const glm::dvec2 uv = fromPacked(level, half, {x + 0.5, y + 0.5}, offset);
                if (uv.x >= -kOn && uv.y >= -kOn && uv.x + uv.y <= 1 + kOn) {
                    Sampled& pixel = pixels[std::size_t{y} * resolution + x];
                    pixel.uv = uv;
                    pixel.half = half;
                    ++pixel.times;
                }
            }
        }
    }
}

struct Faults
{
    std::uint64_t wrongHalf = 0;
    std::uint64_t unpainted = 0;
    double farthest = 0; ///< texels
};

void judge(Level level, const std::vector<Sampled>& pixels, ErrorSums& errors, Faults& faults)
{
    const double resolution = level.resolution();
    for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
        const Sampled& pixel = pixels[t];
        const TexelCoord texel = texelAt(level, static_cast<TexelIndex>(t));
        const glm::dvec2 middle = centroid(level, texel);
        faults.unpainted += pixel.times == 0 ? 1 : 0;
        faults.wrongHalf += pixel.times > 0 && pixel.half != texel.half ? 1 : 0;
        if (pixel.times > 0) {
            const glm::dvec2 off = resolution * (pixel.uv - middle);
            faults.farthest = std::max(faults.farthest,
                                       std::hypot(off.x + off.y / 2, off.y * 0.8660254037844386));
        }
        errors.add(pixel.times > 0 ? studySine(level, pixel.uv) : 0, studySine(level, middle), 1);
    }
}

double nsPerTexel(Level level, double offset, std::vector<Sampled>& pixels)
{
    double best = 0;
    for (int round = 0; round < 3; ++round) {
        const double begin = processorSeconds();
        rasterise(level, offset, pixels);
        const double seconds = processorSeconds() - begin;
        best = round == 0 ? seconds : std::min(best, seconds);
    }
    return 1e9 * best / level.texelCount();
}

std::string describe(const std::string& series, const Faults& faults)
{
    std::ostringstream text;
    text.precision(2);
    text << series << ": " << faults.wrongHalf << " texels from the wrong half, "
         << faults.unpainted << " unpainted, the farthest sample " << faults.farthest
         << " texels from its centroid.";
    return text.str();
}

} // namespace

Result<Study> studyPaintProjection(StudyWatcher& watcher)
{
    Study study;
    study.name = "paint-projection";
    study.title = "Painting the packed square: offset 1/6 against none";
    study.costTitle = "Time per texel";
    study.costUnit = "ns";
    study.subject = "sine of 20 texels, levels 2 to 9";
    study.conditions = toText(thisMachine()) + "; one thread, processor, least of three";
    std::vector<Sampled> pixels;
    for (const bool right : {true, false}) {
        const double offset = right ? kPaintOffset : 0;
        const std::string series = right ? "offset 1/6" : "no offset";
        Faults faults;
        for (int n = kLowest; n <= kHighest; ++n) {
            const double levels = kHighest - kLowest + 1;
            if (!watcher.report(((right ? 0 : levels) + n - kLowest) / (2 * levels))) {
                return cancelled();
            }
            StudyPoint point;
            point.series = series;
            point.variant = "level " + std::to_string(n);
            point.cost = nsPerTexel(Level(n), offset, pixels);
            ErrorSums errors;
            judge(Level(n), pixels, errors, faults);
            errors.tell(point);
            point.samples = errors.count();
            watcher.measured(point);
            study.points.push_back(std::move(point));
        }
        study.notes.push_back(describe(series, faults));
    }
    return study;
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/fill_holes.h"

#include "core/base/check.h"
#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace trixel {

namespace {

/// Half the size of the one before: values where something is known.
struct HoleLevel
{
    int width = 0, height = 0;
    std::vector<float> values;
    std::vector<std::uint8_t> known;
};

/// What a level is seen as, whether it is the image itself or one of ours.
struct HoleView
{
    int width = 0, height = 0;
    std::span<float> values;
    std::span<const std::uint8_t> known;

    std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
                   static_cast<std::size_t>(width) +
               static_cast<std::size_t>(std::clamp(x, 0, width - 1));
    }
};

constexpr std::size_t kRowsAtOnce = 16;

/// Calls `row` for each of them; fewer where it is cancelled.
void rowsOf(int height, Threads threads, Progress& progress, const std::function<void(int)>& row)
{
    const auto rows = static_cast<std::size_t>(height);
    const std::size_t bands = (rows + kRowsAtOnce - 1) / kRowsAtOnce;
    SharedProgress shared(progress, bands);
    parallelFor(bands, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t band = begin; band < end && shared.goesOn(); ++band) {
            for (std::size_t y = band * kRowsAtOnce; y < std::min(rows, (band + 1) * kRowsAtOnce);
                 ++y) {
                row(static_cast<int>(y));
            }
            shared.step();
        }
    });
}

/// Means of what is known among four.
HoleLevel pulled(const HoleView& fine, std::size_t channels, Threads threads, Progress& progress)
{
    HoleLevel coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
    const std::size_t pixels =
        static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height);
    coarse.values.resize(pixels * channels);
    coarse.known.resize(pixels);
    rowsOf(coarse.height, threads, progress, [&](int y) {
        for (int x = 0; x < coarse.width; ++x) {
            const std::size_t target =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(coarse.width) +
                static_cast<std::size_t>(x);
            float* sum = &coarse.values[target * channels];
            int count = 0;
            for (int k = 0; k < 4; ++k) {
                const int fx = 2 * x + k % 2;
                const int fy = 2 * y + k / 2;
                if (fx >= fine.width || fy >= fine.height || fine.known[fine.at(fx, fy)] == 0) {
                    continue;
                }
                const float* from = &fine.values[fine.at(fx, fy) * channels];
                std::transform(sum, sum + channels, from, sum, std::plus<>());
                ++count;
            }
            for (std::size_t c = 0; c < channels && count > 1; ++c) {
                sum[c] /= static_cast<float>(count);
            }
            coarse.known[target] = count > 0 ? 1 : 0;
        }
    });
    return coarse;
}

/// Between the four nearest of the coarser level, all of which hold something by now.
void push(const HoleView& fine,
          const HoleView& coarse,
          std::size_t channels,
          Threads threads,
          Progress& progress)
{
    rowsOf(fine.height, threads, progress, [&](int y) {
        for (int x = 0; x < fine.width; ++x) {
            const std::size_t target = fine.at(x, y);
            if (fine.known[target] != 0) {
                continue;
            }
            const int besideX = x / 2 + (x % 2 == 0 ? -1 : 1);
            const int besideY = y / 2 + (y % 2 == 0 ? -1 : 1);
            const std::array<std::size_t, 4> from = {coarse.at(x / 2, y / 2) * channels,
                                                     coarse.at(besideX, y / 2) * channels,
                                                     coarse.at(x / 2, besideY) * channels,
                                                     coarse.at(besideX, besideY) * channels};
            for (std::size_t c = 0; c < channels; ++c) {
                fine.values[target * channels + c] =
                    0.5625F * coarse.values[from[0] + c] + 0.1875F * coarse.values[from[1] + c] +
                    0.1875F * coarse.values[from[2] + c] + 0.0625F * coarse.values[from[3] + c];
            }
        }
    });
}

/// Remembers that work is to stop, so that a long one need not look after each part.
class StopWatcher final : public Progress
{
public:
    explicit StopWatcher(Progress& progress)
        : m_progress(progress)
    {
    }
    bool report(double fraction) override
    {
        m_goesOn = m_goesOn && m_progress.report(fraction);
        return m_goesOn;
    }
    bool goesOn() const { return m_goesOn; }

private:
    Progress& m_progress;
    bool m_goesOn = true;
};

bool hasHole(std::span<const std::uint8_t> known)
{
    return std::any_of(known.begin(), known.end(), [](std::uint8_t k) { return k == 0; });
}

} // namespace

Status fillHoles(std::span<float> values,
                 std::span<const std::uint8_t> known,
                 int width,
                 int height,
                 int channels,
                 Threads threads,
                 Progress& progress)
{
    const auto count = static_cast<std::size_t>(channels);
    check(values.size() == known.size() * count &&
              known.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
          "as many values as pixels");
    StopWatcher watched(progress);
    if (std::all_of(known.begin(), known.end(), [](std::uint8_t k) { return k == 0; })) {
        return watched.report(1) ? Status() : cancelled();
    }
    std::vector<HoleView> views = {{width, height, values, known}};
    std::vector<HoleLevel> levels;
    levels.reserve(32); // views refer to them
    double left = 1; // of the way up, and likewise down; each level is a quarter of the finer one
    while (watched.goesOn() && hasHole(views.back().known)) {
        StageProgress stage(watched, 0.5 * (1 - left), 0.5 * (1 - left / 4));
        HoleLevel& level = levels.emplace_back(pulled(views.back(), count, threads, stage));
        views.push_back({level.width, level.height, level.values, level.known});
        left /= 4;
    }
    for (std::size_t k = views.size() - 1; k-- > 0 && watched.goesOn(); left *= 4) {
        StageProgress stage(watched, 0.5 + 0.5 * left, 0.5 + 0.5 * std::min(1.0, 4 * left));
        push(views[k], views[k + 1], count, threads, stage);
    }
    return watched.report(1) ? Status() : cancelled();
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_steps.h"

#include "core/texture/level_change.h"

#include <algorithm>

namespace trixel {

FitSteps evenSteps(const FitSource& source, int judged, int rim)
{
    FitSteps steps(source.texels.faceCount(), 0);
    for (std::size_t f = 0; f < steps.size(); ++f) {
        const FaceId face = faceId(f);
        if (source.samples.isJudged(face)) {
            steps[face] = judged;
        } else if (source.rim.contains(face)) {
            steps[face] = rim;
        }
    }
    return steps;
}

FaceMap<Level> levelsAfter(const FitSource& source, const FitSteps& steps)
{
    FaceMap<Level> levels(steps.size(), Level(0));
    FaceMap<int> rimSteps(steps.size(), Level::kMax);
    for (std::size_t f = 0; f < steps.size(); ++f) {
        const FaceId face = faceId(f);
        if (!source.samples.isJudged(face)) {
            continue;
        }
        levels[face] = source.texels.face(face).level().coarser(steps[face]);
        for (const FaceId near : source.rim.reached[face]) {
            rimSteps[near] = std::min(rimSteps[near], steps[face] + steps[near]);
            levels[near] = source.texels.face(near).level().coarser(rimSteps[near]);
        }
    }
    return levels;
}

std::uint64_t texelsAfter(const FitSource& source, const FitSteps& steps)
{
    return levelCost(source.texels, levelsAfter(source, steps)).texelsAfter;
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The promise of a fit on the sample scene: one camera at so many sizes of the model, then random
// views that it covers, rendered through `exact` before and after.
// Usage: fit_views CHAMELEON.obj STROKES.json [DISTANCE [VIEWS [STEP [one-texel|by-distance]]]]
#include "core/base/read_file.h"
#include "core/io/sample_scene.h"
#include "core/study/fit/fit.h"
#include "core/study/views/picture_error.h"
#include "tests/core/study/fit/covered_views.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

namespace trixel {
namespace {

constexpr double kTolerance = 1.0 / 255;

struct Options
{
    double distance = 8;
    int views = 100;
    int step = 3; ///< one pixel of each step × step stands for all
    UnseenFaces unseen = UnseenFaces::OneTexel;
};

ViewCamera modelCamera(const Surface& surface, double distance)
{
    const glm::dvec3 middle = (glm::dvec3(surface.low()) + glm::dvec3(surface.high())) / 2.0;
    const glm::dvec3 side = glm::normalize(glm::dvec3(1, 0.5, 1));
    return {"model",
            middle + distance * static_cast<double>(surface.size()) * side,
            middle,
            {0, 1, 0},
            35,
            1920,
            1080};
}

FilterScene sceneOf(const Surface& surface, const TexelStore& texels)
{
    NoProgress progress;
    const auto shapes = std::make_shared<FilterSurface>(
        FilterSurface::fromMesh(surface.mesh(), surface.adjacency()));
    return FilterScene::build(shapes, texels, Threads::all(), progress).value();
}

void print(const char* title, std::vector<double> errors)
{
    std::ranges::sort(errors);
    if (!errors.empty()) {
        std::printf("%zu %s: median %.3f, 90 %% below %.3f, worst %.3f\n",
                    errors.size(),
                    title,
                    errors[errors.size() / 2],
                    errors[errors.size() * 9 / 10],
                    errors.back());
    }
}

int run(const Project& project, const Options& options)
{
    NoProgress progress;
    const Surface& surface = *project.surface;
    const SceneViews scene{{modelCamera(surface, options.distance)}, {}};
    const std::clock_t begin = std::clock();
    const auto plan = planFit(
        surface, project.texels, {scene, kTolerance, options.unseen}, Threads::all(), progress);
    if (!plan) {
        std::printf("%s\n", plan.error().message.c_str());
        return 1;
    }
    const double times =
        static_cast<double>(plan->cost.texelsBefore) / static_cast<double>(plan->cost.texelsAfter);
    std::printf("%llu -> %llu texels, %.2f times fewer; RMS %.3f, worst part %.3f, worst face %.3f "
                "(in 1/255); %.0f s of processor time\n",
                static_cast<unsigned long long>(plan->cost.texelsBefore),
                static_cast<unsigned long long>(plan->cost.texelsAfter),
                times,
                255 * plan->rms,
                255 * plan->worstPart,
                255 * plan->worstFace,
                static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    std::printf("no view sees %u of %u faces: their texels %llu -> %llu\n",
                plan->unseenFaces,
                project.texels.faceCount(),
                static_cast<unsigned long long>(plan->unseenTexelsBefore),
                static_cast<unsigned long long>(plan->unseenTexelsAfter));
    std::fflush(stdout);
    TexelStore fitted = project.texels;
    applyFit(*plan, fitted);
    const FilterScene before = sceneOf(surface, project.texels);
    const FilterScene after = sceneOf(surface, fitted);
    const auto errorOf = [&](const ViewCamera& view) {
        const auto queries =
            viewQueries(surface, view, {options.step, 5}, Threads::all(), progress);
        return pictureError(before, after, queries->queries.queries(), Threads::all(), progress)
            .value();
    };
    std::printf("the camera itself: RMS %.3f\n", 255 * errorOf(scene.cameras[0]).rms);
    test::CoveredViews covered(surface, scene, 7);
    std::vector<double> errors;
    for (int k = 0; k < options.views; ++k) {
        const PictureError error = errorOf(covered.next());
        errors.push_back(255 * error.rms);
        if (error.rms > kTolerance) {
            std::printf("view %d exceeds it: RMS %.3f, %zu pixels asked\n",
                        k,
                        255 * error.rms,
                        error.pixels);
        }
    }
    print("covered views", errors);
    for (std::size_t k = 0; k < covered.tallies().size(); ++k) {
        const auto& tally = covered.tallies()[k];
        std::printf("%3.0f to %3.0f degrees off the camera: %zu tried, %zu covered\n",
                    covered.kTallyDegrees * static_cast<double>(k),
                    covered.kTallyDegrees * static_cast<double>(k + 1),
                    tally.tried,
                    tally.covered);
    }
    std::vector<double> others;
    for (int k = 0; k < options.views; ++k) {
        others.push_back(255 * errorOf(covered.nextUncovered()).rms);
    }
    print("views that are not covered, for information", others);
    const bool exceeds = std::ranges::any_of(errors, [](double e) { return e > 255 * kTolerance; });
    return exceeds ? 1 : 0;
}

} // namespace
} // namespace trixel

int main(int argc, char** argv)
{
    if (argc < 3) {
        std::printf("fit_views CHAMELEON.obj STROKES.json [DISTANCE [VIEWS [STEP "
                    "[one-texel|by-distance]]]]\n");
        return 2;
    }
    trixel::NoProgress progress;
    const auto cage = trixel::readFile(argv[1]);
    const auto strokes = trixel::readFile(argv[2]);
    if (!cage || !strokes) {
        std::printf("%s\n", (cage ? strokes : cage).error().message.c_str());
        return 3;
    }
    const auto project = trixel::buildSampleScene(*cage, *strokes, progress);
    if (!project) {
        std::printf("%s\n", project.error().message.c_str());
        return 2;
    }
    trixel::Options options;
    options.distance = argc > 3 ? std::atof(argv[3]) : options.distance;
    options.views = argc > 4 ? std::atoi(argv[4]) : options.views;
    options.step = argc > 5 ? std::atoi(argv[5]) : options.step;
    if (argc > 6 && std::string_view(argv[6]) == "by-distance") {
        options.unseen = trixel::UnseenFaces::ByDistance;
    }
    return trixel::run(*project, options);
}

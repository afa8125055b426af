// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes to filter and one-line questions to a method, for tests.
#pragma once

#include "core/filter/filter_method.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <string_view>
#include <vector>

namespace trixel::test {

/// Value of a texel: face, its coordinates, channel → float.
using TexelFunction = std::function<float(FaceId, glm::dvec2, int)>;

/// Float texels of three channels from the function at each texel's centroid.
inline TexelStore storeOf(const FaceMap<Level>& levels, const TexelFunction& value)
{
    const TexelFormat format{TexelType::Float, 3, std::nullopt};
    const std::array<float, 3> zero{};
    TexelStore store(format, levels, std::as_bytes(std::span(zero)));
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        const Level level = levels[faceId(f)];
        std::vector<float> texels;
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
            for (int c = 0; c < 3; ++c) {
                texels.push_back(value(faceId(f), uv, c));
            }
        }
        store.exchange(faceId(f), FaceTexels::full(level, 12, std::as_bytes(std::span(texels))));
    }
    return store;
}

inline FilterScene sceneOf(FilterSurface surface, const TexelStore& store)
{
    NoProgress progress;
    auto scene = FilterScene::build(
        std::make_shared<const FilterSurface>(std::move(surface)), store, Threads{1}, progress);
    return std::move(*scene);
}

inline FilterSurface surfaceOf(const TriangleMesh& mesh)
{
    return FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles));
}

/// Independent values in [0, 1).
inline TexelFunction noise(unsigned seed)
{
    auto random = std::make_shared<std::mt19937>(seed);
    return [random](FaceId, glm::dvec2, int) {
        return static_cast<float>((*random)() >> 8U) / 16777216.0F;
    };
}

struct Query
{
    FaceId face{};
    glm::vec2 uv{0};
    glm::vec2 w1{0};
    glm::vec2 w2{0};
};

struct Answer
{
    std::array<double, 3> value{};
    float level = 0;
    std::uint32_t taps = 0;
};

inline std::vector<Answer>
ask(const FilterMethod& method, const FilterScene& scene, const std::vector<Query>& queries)
{
    QueryArrays arrays;
    for (const Query& query : queries) {
        arrays.add(query.face, query.uv, query.w1, query.w2);
    }
    ResultArrays results(queries.size(), scene.channels());
    method.filter(scene, arrays.queries(), results.results());
    std::vector<Answer> answers(queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            answers[i].value[c] = static_cast<double>(results.values[c * queries.size() + i]);
        }
        answers[i].level = results.levels[i];
        answers[i].taps = results.taps[i];
    }
    return answers;
}

inline Answer ask(const FilterMethod& method, const FilterScene& scene, const Query& query)
{
    return ask(method, scene, std::vector{query}).front();
}

/// Largest difference of a channel.
inline double difference(const Answer& a, const Answer& b)
{
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(a.value[c] - b.value[c]));
    }
    return largest;
}

} // namespace trixel::test

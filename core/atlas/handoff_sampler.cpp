// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_sampler.h"

#include "core/texture/opacity.h"

#include <numeric>
#include <utility>
#include <vector>

namespace trixel {

namespace {

/// One answer, channel by channel.
void take(const ResultArrays& answers, std::size_t k, std::span<float> value)
{
    for (std::size_t c = 0; c < value.size(); ++c) {
        value[c] = answers.values[c * answers.levels.size() + k];
    }
}

void put(std::span<const float> value, ResultArrays& answers, std::size_t k)
{
    for (std::size_t c = 0; c < value.size(); ++c) {
        answers.values[c * answers.levels.size() + k] = value[c];
    }
}

} // namespace

HandOffSampler::HandOffSampler(const FilterScene& scene,
                               const FilterMethod& method,
                               const TexelFormat& format)
    : m_scene(scene)
    , m_method(method)
    , m_format(format)
    , m_average(format.alpha ? makeMethod({"ewa", std::nullopt}) : nullptr)
{
}

ResultArrays HandOffSampler::sampled(const QueryArrays& places) const
{
    ResultArrays samples(places.size(), m_scene.channels());
    m_method.filter(m_scene, places.queries(), samples.results());
    if (m_format.alpha) {
        spreadColors(places, samples);
    }
    return samples;
}

/// Asks for ever wider averages about the samples that show nothing, until there is something.
void HandOffSampler::spreadColors(const QueryArrays& places, ResultArrays& samples) const
{
    constexpr float kWidest = 2; // edges of the face: all about it has been seen
    const std::size_t opacity = *m_format.alpha;
    std::vector<float> value(m_format.channels);
    std::vector<std::size_t> hidden;
    for (std::size_t k = 0; k < places.size(); ++k) {
        take(samples, k, value);
        unweigh(value, opacity);
        put(value, samples, k);
        if (!(value[opacity] > 0)) {
            hidden.push_back(k);
        }
    }
    for (float texels = 2; !hidden.empty(); texels *= 2) {
        QueryArrays wider;
        std::vector<std::size_t> asked;
        for (const std::size_t k : std::exchange(hidden, {})) {
            const FaceId face = places.face[k];
            const float width = texels / static_cast<float>(m_scene.level(face).resolution());
            if (width <= kWidest) {
                asked.push_back(k);
                wider.add(face, {places.u[k], places.v[k]}, {width, 0}, {0, width});
            }
        }
        ResultArrays about(asked.size(), m_scene.channels());
        m_average->filter(m_scene, wider.queries(), about.results());
        for (std::size_t k = 0; k < asked.size(); ++k) {
            take(about, k, value);
            if (!(value[opacity] > 0)) {
                hidden.push_back(asked[k]);
                continue;
            }
            unweigh(value, opacity);
            value[opacity] = 0; // it is the colour alone that spreads
            put(value, samples, asked[k]);
        }
    }
}

} // namespace trixel

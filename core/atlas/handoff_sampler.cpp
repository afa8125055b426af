// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_sampler.h"

#include "core/texture/opacity.h"

#include <vector>

namespace trixel {

HandOffSampler::HandOffSampler(const FilterScene& scene,
                               const FilterMethod& method,
                               const TexelFormat& format)
    : m_scene(scene)
    , m_method(method)
    , m_opacity(format.alpha)
{
    if (m_opacity) {
        m_hidden.emplace(scene, *m_opacity);
    }
}

ResultArrays HandOffSampler::sampled(const QueryArrays& places) const
{
    ResultArrays samples(places.size(), m_scene.channels());
    m_method.filter(m_scene, places.queries(), samples.results());
    if (m_opacity) {
        takeColors(places, samples);
    }
    return samples;
}

/// From weighed samples.
void HandOffSampler::takeColors(const QueryArrays& places, ResultArrays& samples) const
{
    std::vector<float> value(static_cast<std::size_t>(m_scene.channels()));
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (std::size_t c = 0; c < value.size(); ++c) {
            value[c] = samples.values[c * places.size() + k];
        }
        if (value[*m_opacity] > 0) {
            unweigh(value, *m_opacity);
        } else {
            m_hidden->at(places.face[k], {places.u[k], places.v[k]}, value);
        }
        for (std::size_t c = 0; c < value.size(); ++c) {
            samples.values[c * places.size() + k] = value[c];
        }
    }
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/hidden_colors.h"

#include "core/texture/opacity.h"

#include <algorithm>
#include <array>

namespace trixel {

namespace {

/// Rings of the two other corners of every face about a vertex.
template <class Visit>
void forNeighbours(const VertexRings& rings, RingId ring, const Visit& visit)
{
    for (const Corner corner : rings.corners(ring)) {
        for (const int step : {1, 2}) {
            visit(rings.ring({corner.face, static_cast<std::uint8_t>((corner.index + step) % 3)}));
        }
    }
}

} // namespace

HiddenColors::HiddenColors(const FilterScene& scene, std::size_t opacity)
    : m_scene(scene)
    , m_opacity(opacity)
{
    const std::size_t rings = scene.surface().rings().ringCount();
    m_colors.resize(rings * static_cast<std::size_t>(scene.channels()));
    m_states.resize(rings, State::Unknown);
    std::vector<RingId> reached;
    for (std::size_t r = 0; r < rings; ++r) {
        const RingId ring{static_cast<std::uint32_t>(r)};
        if (takeShown(ring)) {
            reached.push_back(ring);
        }
    }
    while (!reached.empty()) {
        reached = nextTo(reached);
        for (const RingId ring : reached) {
            takeMean(ring);
        }
        for (const RingId ring : reached) {
            m_states[indexOf(ring)] = State::Known; // not before: the order must not matter
        }
    }
}

void HiddenColors::at(FaceId face, glm::vec2 uv, std::span<float> value) const
{
    check(value.size() == static_cast<std::size_t>(m_scene.channels()), "all channels");
    const VertexRings& rings = m_scene.surface().rings();
    const std::array<float, 3> weights{1 - uv.x - uv.y, uv.x, uv.y};
    std::ranges::fill(value, 0.0F);
    for (std::uint8_t k = 0; k < 3; ++k) {
        const std::span<const float> corner = color(rings.ring({face, k}));
        for (std::size_t c = 0; c < value.size(); ++c) {
            value[c] += weights[k] * corner[c];
        }
    }
}

std::span<float> HiddenColors::color(RingId ring)
{
    const auto channels = static_cast<std::size_t>(m_scene.channels());
    return std::span(m_colors).subspan(indexOf(ring) * channels, channels);
}

std::span<const float> HiddenColors::color(RingId ring) const
{
    const auto channels = static_cast<std::size_t>(m_scene.channels());
    return std::span(m_colors).subspan(indexOf(ring) * channels, channels);
}

/// From the mean of the faces about it.
bool HiddenColors::takeShown(RingId ring)
{
    const Corner corner = m_scene.surface().rings().corners(ring).front();
    const std::span<float> value = color(ring);
    for (std::size_t c = 0; c < value.size(); ++c) {
        const LevelVertices vertices =
            m_scene.pyramid().vertices(corner.face, Level(0), static_cast<int>(c / kGroupChannels));
        value[c] = vertices.values[vertices.stride * corner.index + c % kGroupChannels];
    }
    const bool shows = value[m_opacity] > 0;
    unweigh(value, m_opacity);
    value[m_opacity] = 0;
    m_states[indexOf(ring)] = shows ? State::Known : State::Unknown;
    return shows;
}

std::vector<RingId> HiddenColors::nextTo(std::span<const RingId> rings)
{
    std::vector<RingId> next;
    for (const RingId ring : rings) {
        forNeighbours(m_scene.surface().rings(), ring, [&](RingId other) {
            if (m_states[indexOf(other)] == State::Unknown) {
                m_states[indexOf(other)] = State::Next;
                next.push_back(other);
            }
        });
    }
    return next;
}

void HiddenColors::takeMean(RingId ring)
{
    const std::span<float> mean = color(ring);
    float count = 0;
    forNeighbours(m_scene.surface().rings(), ring, [&](RingId other) {
        if (m_states[indexOf(other)] == State::Known) {
            const std::span<const float> known = color(other);
            for (std::size_t c = 0; c < mean.size(); ++c) {
                mean[c] += known[c];
            }
            ++count;
        }
    });
    for (float& value : mean) {
        value /= count; // it is next to one
    }
}

} // namespace trixel

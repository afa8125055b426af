// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl.h"

#include <array>
#include <cstddef>
#include <optional>

namespace trixel::render {

/// Times frames by the card's own clock, and never waits for it: the time of a frame is known some
/// frames later. Needs the context it was made in to be current.
class FrameTimer
{
public:
    explicit FrameTimer(Gl& gl);
    ~FrameTimer();
    FrameTimer(const FrameTimer&) = delete;
    FrameTimer& operator=(const FrameTimer&) = delete;

    /// Before a frame's first and after its last call. Frames do not nest.
    void begin();
    void end();

    /// Of the latest frame whose time is known; nothing before there is one, or where the card has
    /// no clock.
    std::optional<double> milliseconds() const { return m_milliseconds; }

private:
    void read();

    static constexpr std::size_t kFrames = 4; ///< in flight at most; more are not timed
    Gl& m_gl;
    bool m_hasClock = false;
    std::array<GLuint, kFrames> m_queries{};
    std::size_t m_next = 0;  ///< frames begun
    std::size_t m_known = 0; ///< of them, read
    bool m_isTiming = false;
    std::optional<double> m_milliseconds;
};

} // namespace trixel::render

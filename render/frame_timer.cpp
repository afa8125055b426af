// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_timer.h"

namespace trixel::render {

FrameTimer::FrameTimer(Gl& gl)
    : m_gl(gl)
{
    GLint bits = 0;
    m_gl.glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    m_hasClock = bits > 0;
    if (m_hasClock) {
        m_gl.glGenQueries(static_cast<GLsizei>(kFrames), m_queries.data());
    }
}

FrameTimer::~FrameTimer()
{
    if (m_hasClock && m_gl.isCurrent()) {
        m_gl.glDeleteQueries(static_cast<GLsizei>(kFrames), m_queries.data());
    }
}

void FrameTimer::begin()
{
    if (!m_hasClock) {
        return;
    }
    read();
    m_isTiming = m_next - m_known < kFrames;
    if (m_isTiming) {
        m_gl.glBeginQuery(GL_TIME_ELAPSED, m_queries[m_next % kFrames]);
    }
}

void FrameTimer::end()
{
    if (m_isTiming) {
        m_gl.glEndQuery(GL_TIME_ELAPSED);
        m_isTiming = false;
        ++m_next;
    }
}

/// What has become known since.
void FrameTimer::read()
{
    while (m_known < m_next) {
        const GLuint query = m_queries[m_known % kFrames];
        GLint isKnown = 0;
        m_gl.glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &isKnown);
        if (isKnown == 0) {
            return;
        }
        GLuint64 nanoseconds = 0;
        m_gl.glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        m_milliseconds = 1e-6 * static_cast<double>(nanoseconds);
        ++m_known;
    }
}

} // namespace trixel::render

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at a texel that is held and stepped from.
#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/document/inspection.h"
#include "ui/viewport/viewport.h"

#include <string>

namespace trixel::app {

namespace {

constexpr int kMostSteps = 64; ///< more than any way through a face of the sample

} // namespace

Status Stops::heldTexel()
{
    const ui::Inspection& inspection = m_window.inspection();
    m_input.keys(Qt::Key_I);
    m_input.keys(Qt::Key_T);
    m_input.keys(Qt::Key_W);
    m_input.wheel(m_view, inView(0.45, 0.45), 10);
    m_input.click(m_view, inView(0.45, 0.45));
    if (Status held = expect(inspection.isHeld(), "a click with the tool I holds a texel"); !held) {
        return held;
    }
    const FaceId first = inspection.texel()->place.face;
    int steps = 0;
    for (; steps < kMostSteps && inspection.texel()->place.face == first; ++steps) {
        m_input.press(m_view, Qt::Key_Up);
    }
    if (Status left = expect(steps < kMostSteps, "the arrow key goes on to the next face"); !left) {
        return left;
    }
    m_input.hover(m_view, inView(0.7, 0.3)); // it stays
    if (Status stays = expect(inspection.isHeld(), "a held texel stays"); !stays) {
        return stays;
    }
    const Status taken = picture("held-texel");
    m_input.keys(Qt::Key_T);
    m_input.keys(Qt::Key_W);
    m_input.press(m_view, Qt::Key_Escape);
    const Status gone = expect(!inspection.isHeld(), "Esc lets the texel go");
    return taken ? gone : taken;
}

} // namespace trixel::app

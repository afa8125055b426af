// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at a split view.
#include "app/tour/stops.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/viewport.h"

namespace trixel::app {

namespace {

/// Two pictures of a large window take seconds, on a busy machine minutes.
constexpr int kPatienceMs = 240'000;

} // namespace

Status Stops::comparedFilters()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 3.2);
    m_window.settings().setMethod({"point", std::nullopt});
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_8));
    const ui::ViewMap& map = m_window.viewMap();
    const bool complete = m_input.waitFor([&] { return map.isComplete(); }, kPatienceMs);
    ui::SplitBar& bar = m_window.viewport().splitBar();
    const bool named = bar.isVisible() && !bar.leftText().isEmpty() && !bar.rightText().isEmpty();
    if (!complete || !named) {
        return contentsError("tour: Ctrl+8 splits the view between two filters");
    }
    const Status taken = picture("compared-filters");
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_8));
    m_window.settings().setMethod({});
    if (bar.isVisible() || m_window.viewport().hasPicture()) {
        return contentsError("tour: Ctrl+8 again ends the comparison");
    }
    return taken;
}

} // namespace trixel::app

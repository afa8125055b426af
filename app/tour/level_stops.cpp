// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at faces chosen by hand and given another level.
#include <QLineEdit>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/document/face_selection.h"
#include "ui/viewport/viewport.h"
#include "ui/window/command_palette.h"
#include "ui/window/message_bar.h"

#include <array>
#include <vector>

namespace trixel::app {

Status Stops::command(const QString& words)
{
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P));
    auto* palette = m_window.findChild<ui::CommandPalette*>();
    if (Status opened = expect(palette != nullptr, "Ctrl+Shift+P lists the commands"); !opened) {
        return opened;
    }
    auto* field = palette->findChild<QLineEdit*>();
    m_input.type(*field, words);
    m_input.press(*field, Qt::Key_Return);
    return {};
}

Status Stops::chosenLevels()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_input.wheel(m_view, inView(0.42, 0.37), 9);
    m_input.keys(Qt::Key_Q);
    const std::array path = {inView(0.34, 0.40), inView(0.42, 0.30), inView(0.50, 0.38)};
    m_input.drag(m_view, path, Qt::ShiftModifier);
    const ui::FaceSelection& selection = m_window.selection();
    const std::size_t swept = selection.faces().size();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    if (Status chosen = expect(swept > 1 && selection.faces().size() > swept,
                               "Q and a drag choose faces, Ctrl+Shift+I those about them");
        !chosen) {
        return chosen;
    }
    const std::vector<FaceId> faces(selection.faces().begin(), selection.faces().end());
    const auto levels = [&] {
        std::vector<int> all;
        for (const FaceId face : faces) {
            all.push_back(m_window.document().texels().face(face).level().log2());
        }
        return all;
    };
    std::vector<int> wanted = levels();
    for (int& level : wanted) {
        --level;
    }
    if (Status run = command("levels halve"); !run) {
        return run;
    }
    const bool offered = m_input.waitFor(
        [&] { return m_window.messages().sentence().startsWith("Halve resolution"); });
    if (Status told = expect(offered, "Edit > Levels > Halve tells what it would cost"); !told) {
        return told;
    }
    if (Status pressed = press(m_window, "Apply"); !pressed) {
        return pressed;
    }
    const bool halved = m_input.waitFor([&] { return levels() == wanted; });
    if (Status applied = expect(halved, "Apply halves the resolution of the faces"); !applied) {
        return applied;
    }
    m_input.keys(Qt::Key_T);
    const Status taken = picture("levels-by-hand");
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Z));
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
    m_input.keys(Qt::Key_T);
    m_input.keys(Qt::Key_B);
    return taken ? expect(selection.isEmpty() && levels() != wanted, "Ctrl+Z takes it back")
                 : taken;
}

} // namespace trixel::app

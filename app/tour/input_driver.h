// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QPoint>
#include <QString>

#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <span>

class QWidget;

namespace trixel::app {

/// Uses a window as a person would: pointer, wheel and key events on its widgets, with time for
/// the window to answer. Positions are in the widget's own coordinates.
class InputDriver
{
public:
    explicit InputDriver(QWidget& window);

    /// Lets the window work until nothing is left to draw.
    void settle();
    /// Lets the window work until the condition holds; false when it does not within the time.
    [[nodiscard]] bool waitFor(const std::function<bool()>& condition, int milliseconds = 30'000);

    void hover(QWidget& widget, QPoint at);
    void click(QWidget& widget, QPoint at);
    /// Presses the left button at the first point, moves along the others, and lets go.
    void drag(QWidget& widget, std::span<const QPoint> path, Qt::KeyboardModifiers keys = {});
    /// \param notches  positive turns away from the person
    void wheel(QWidget& widget, QPoint at, int notches);
    /// Presses and lets go each combination in turn, as "Ctrl+E".
    void keys(const QKeySequence& sequence);
    /// Presses and lets go one key where the keyboard is.
    void press(QWidget& field, Qt::Key key);
    /// Replaces the text of an input field.
    void type(QWidget& field, const QString& text);

    /// Writes a picture of the window, or of another top-level widget.
    Status savePicture(QWidget& widget, const std::filesystem::path& path);

private:
    QWidget& m_window;
};

} // namespace trixel::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/input_driver.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QPixmap>
#include <QTest>
#include <QWheelEvent>
#include <QWidget>

#include <tuple>

namespace trixel::app {

namespace {

/// Long enough for a frame of software OpenGL, and for delayed updates of panels.
constexpr int kFrame = 60;

} // namespace

InputDriver::InputDriver(QWidget& window)
    : m_window(window)
{
}

void InputDriver::settle()
{
    for (int frame = 0; frame < 4; ++frame) {
        QTest::qWait(kFrame);
    }
}

bool InputDriver::waitFor(const std::function<bool()>& condition, int milliseconds)
{
    const QDeadlineTimer deadline(milliseconds);
    while (!condition()) {
        if (deadline.hasExpired()) {
            return false;
        }
        QTest::qWait(kFrame / 4);
    }
    return true;
}

void InputDriver::hover(QWidget& widget, QPoint at)
{
    QTest::mouseMove(&widget, at);
    settle();
}

void InputDriver::click(QWidget& widget, QPoint at)
{
    QTest::mouseClick(&widget, Qt::LeftButton, {}, at);
    settle();
}

void InputDriver::drag(QWidget& widget, std::span<const QPoint> path, Qt::KeyboardModifiers keys)
{
    if (path.empty()) {
        return;
    }
    const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button) {
        const Qt::MouseButtons held =
            type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, widget.mapToGlobal(at), button, held, keys);
        QApplication::sendEvent(&widget, &event);
    };
    send(QEvent::MouseButtonPress, path.front(), Qt::LeftButton);
    for (const QPoint at : path.subspan(1)) {
        send(QEvent::MouseMove, at, Qt::NoButton);
        QTest::qWait(2);
    }
    send(QEvent::MouseButtonRelease, path.back(), Qt::LeftButton);
    settle();
}

void InputDriver::wheel(QWidget& widget, QPoint at, int notches)
{
    constexpr int kNotch = 120; // eighths of a degree, as mice report
    const int step = notches < 0 ? -kNotch : kNotch;
    for (int k = 0; k < std::abs(notches); ++k) {
        QWheelEvent event(at,
                          widget.mapToGlobal(at),
                          {},
                          QPoint(0, step),
                          Qt::NoButton,
                          Qt::NoModifier,
                          Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(&widget, &event);
    }
    settle();
}

void InputDriver::keys(const QKeySequence& sequence)
{
    QWidget* dialog = QApplication::activeModalWidget();
    QWidget& target = dialog != nullptr ? *dialog : m_window;
    target.activateWindow(); // shortcuts reach active windows only, and not all servers activate
    std::ignore = waitFor([&] { return target.isActiveWindow(); }); // the stop notices if not
    QTest::keySequence(&target, sequence);
    settle();
}

void InputDriver::press(QWidget& field, Qt::Key key)
{
    QTest::keyClick(&field, key);
    settle();
}

void InputDriver::type(QWidget& field, const QString& text)
{
    field.setFocus();
    QTest::keySequence(&field, QKeySequence::SelectAll);
    QTest::keyClicks(&field, text);
    settle();
}

Status InputDriver::savePicture(QWidget& widget, const std::filesystem::path& path)
{
    settle();
    if (!widget.grab().save(QString::fromStdString(path.string()), "PNG")) {
        return pathError(path.string() + ": the picture could not be written");
    }
    return {};
}

} // namespace trixel::app

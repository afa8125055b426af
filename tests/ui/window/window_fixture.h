// SPDX-License-Identifier: GPL-3.0-or-later
//
// A main window to drive with real events.
#pragma once

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"

#include <memory>

namespace trixel::ui {

inline void writeFile(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

/// Two triangles that share an edge.
inline const QByteArray kSquareObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 3 2\n";

/// The command of that name, whichever menu it is in.
inline QAction* actionNamed(const QWidget& window, const QString& name)
{
    for (QAction* action : window.findChildren<QAction*>()) {
        if (QString(action->text()).remove('&') == name) {
            return action;
        }
    }
    return nullptr;
}

/// The widget a screen reader calls by that name; null when there is none to be seen.
template <class T>
T* widgetNamed(const QWidget& parent, const QString& name)
{
    for (T* widget : parent.findChildren<T*>()) {
        if (widget->accessibleName() == name && widget->isVisibleTo(&parent)) {
            return widget;
        }
    }
    return nullptr;
}

/// The dialog in front of the window, if any.
template <class T>
T* openDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* dialog = qobject_cast<T*>(widget); dialog && dialog->isVisible()) {
            return dialog;
        }
    }
    return nullptr;
}

/// Base of the tests: settings and files of their own, a window on the painted grid or none.
class WindowTest : public QObject
{
protected:
    void openWindow()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QSettings().clear();
        QSettings().setValue("files/folder", m_folder->path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1280, 800);
        m_window->show();
        m_window->activateWindow(); // there is no window manager to do it
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }
    void openGrid()
    {
        m_window->document().open(gridProject(), {}, "grid");
        m_window->viewport().setFocus();
    }
    void closeWindow()
    {
        m_window.reset();
        m_folder.reset();
    }
    void fillFace(std::uint32_t face)
    {
        m_window->document().fillFaces(std::array{FaceId{face}}, {1, 0, 0, 1});
    }
    QString path(const QString& name) const { return m_folder->filePath(name); }
    Document& document() { return m_window->document(); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        m_window->activateWindow(); // a dialog that closed has left no window active
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus != nullptr ? focus : m_window.get(), key, modifiers);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;

private:
    TemporarySettings m_settings;
};

} // namespace trixel::ui

/// Like QTEST_MAIN, with the program's own set-up.
#define TRIXEL_WINDOW_TEST_MAIN(Test)                                                              \
    int main(int argc, char** argv)                                                                \
    {                                                                                              \
        trixel::ui::prepareApplication();                                                          \
        QApplication application(argc, argv);                                                      \
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);                                   \
        trixel::ui::TemporarySettings settings;                                                    \
        trixel::ui::setUpApplication(application);                                                 \
        Test test;                                                                                 \
        return QTest::qExec(&test, argc, argv);                                                    \
    }

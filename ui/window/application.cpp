// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/application.h"

#include <QIcon>
#include <QSettings>
#include <QSurfaceFormat>

#include "ui/window/main_window.h"
#include "ui/window/theme.h"

namespace trixel::ui {

void prepareApplication()
{
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setOption(QSurfaceFormat::ResetNotification); // as the view's, which shares with it
    QSurfaceFormat::setDefaultFormat(format);
    QCoreApplication::setOrganizationName("Trixel");
    QCoreApplication::setApplicationName("Trixel");
    QCoreApplication::setApplicationVersion(TRIXEL_VERSION);
    QGuiApplication::setDesktopFileName("trixel"); // whose icon the desktop shows
}

void setUpApplication(QApplication& /*application*/)
{
    const QString chosen = QSettings().value("view/theme").toString();
    applyTheme(themeFromName(chosen).value_or(Theme::System));
}

int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& file)
{
    prepareApplication();
    QApplication application(argc, argv);
    setUpApplication(application);
    QApplication::setWindowIcon(QIcon(":/icons/trixel.svg"));
    MainWindow window;
    window.show();
    if (file) {
        window.open(QString::fromStdU16String(file->u16string()));
    } else {
        window.files().openSample();
    }
    return QApplication::exec();
}

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A large .ptx in the window: from `open` to the first picture of it, to the last, then what one
// does with it. Needs a display with OpenGL; see README.md for how to run it.
// Usage: bench_open_ptx FILE [FOLDER FOR PICTURES AND AN EXPORT]
#include <QApplication>
#include <QElapsedTimer>

#include "core/texture/stored_faces.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

#include <cstdio>
#include <fstream>
#include <functional>
#include <unistd.h>

using namespace trixel;
using namespace trixel::ui;

namespace {

double residentMiB()
{
    std::ifstream status("/proc/self/statm");
    std::uint64_t size = 0;
    std::uint64_t resident = 0;
    status >> size >> resident;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1048576;
}

/// Tells of each step how long it took and what is in memory after it.
class Steps
{
public:
    explicit Steps(MainWindow& window, QString folder)
        : m_window(window)
        , m_folder(std::move(folder))
    {
        m_clock.start();
    }

    void done(const char* what, bool pictured = true)
    {
        const auto& faces = m_window.document().storedFaces();
        const double read = faces ? static_cast<double>(faces->readBytes()) / 1048576 : 0;
        const double held = faces ? static_cast<double>(faces->heldBytes()) / 1048576 : 0;
        std::printf("%-36s %8.1f ms  RSS %7.1f MiB  read %7.1f MiB  held %7.1f MiB\n",
                    what,
                    static_cast<double>(m_clock.nsecsElapsed()) / 1e6,
                    residentMiB(),
                    read,
                    held);
        std::fflush(stdout);
        if (pictured && !m_folder.isEmpty()) {
            m_window.grab().save(m_folder + QString("/%1.png").arg(what).replace(' ', '-'));
        }
        m_clock.start();
    }

private:
    MainWindow& m_window;
    QString m_folder;
    QElapsedTimer m_clock;
};

void waitFor(const std::function<bool()>& condition)
{
    while (!condition()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    }
}

void paint(Document& document)
{
    Brush brush;
    brush.radius = 0.05F;
    brush.color = {1, 0, 0, 1};
    document.beginStroke(brush);
    const std::uint32_t middle = document.texels().faceCount() / 2;
    document.extendStroke({faceId(middle), {0.3F, 0.3F}, 1.0F, 0});
    document.extendStroke({faceId(middle + 2), {0.3F, 0.3F}, 1.0F, 0.1});
    document.endStroke();
}

} // namespace

int main(int count, char** arguments)
{
    prepareApplication();
    QApplication application(count, arguments);
    if (count < 2) {
        std::fprintf(stderr, "bench_open_ptx FILE [FOLDER]\n");
        return 1;
    }
    const QString folder = count > 2 ? QString(arguments[2]) : QString();
    MainWindow window;
    window.resize(1500, 940);
    window.show();
    QCoreApplication::processEvents();
    Document& document = window.document();
    QObject::connect(&document, &Document::notice, [](const QString& sentence) {
        std::printf("notice: %s\n", qPrintable(sentence));
    });
    QObject::connect(&window.files(), &ProjectFiles::failed, [](const QString& sentence) {
        std::printf("failed: %s\n", qPrintable(sentence));
    });

    Steps steps(window, folder);
    bool isOpened = false;
    QObject::connect(&window.files(), &ProjectFiles::opened, [&] { isOpened = true; });
    window.files().open(arguments[1]);
    waitFor([&] { return isOpened; });
    steps.done("opened", false);
    const QImage first = window.viewport().grabFramebuffer();
    steps.done("first picture");
    window.viewport().settle();
    steps.done("settled");
    window.viewport().frameFace(faceId(document.texels().faceCount() / 2));
    window.viewport().settle();
    steps.done("framed one face");
    paint(document);
    steps.done("stroke", false);
    window.viewport().settle();
    steps.done("stroke shown");
    document.undoStack().undo();
    window.viewport().settle();
    steps.done("undone");
    if (!folder.isEmpty()) {
        paint(document);
        bool isEnded = false;
        QObject::connect(&window.files(), &ProjectFiles::exportEnded, [&] { isEnded = true; });
        window.files().exportAs({(folder + "/exported.ptx").toStdString(), PtxExportOptions{}, {}});
        waitFor([&] { return isEnded; });
        steps.done("exported");
    }
    return first.isNull() ? 1 : 0;
}

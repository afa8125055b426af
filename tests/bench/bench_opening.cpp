// SPDX-License-Identifier: GPL-3.0-or-later
//
// From `open` to the first frame in the window that shows the surface, to the first that shows its
// texels however coarsely, and to the picture complete. Needs a display with OpenGL; see README.md
// for how to run it.
// Usage: bench_opening FILE…, or bench_opening write FOLDER, which makes files of a million faces
// and a .ptx of 1 GiB
#include <QApplication>
#include <QElapsedTimer>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QThread>

#include "tests/bench/large_ptx.h"
#include "tests/bench/sheet_project.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>

using namespace trixel;
using namespace trixel::ui;
namespace fs = std::filesystem;

namespace {

constexpr int kSide = 707; // a million faces

void writePly(const fs::path& path, const TriangleMesh& mesh)
{
    std::ofstream file(path, std::ios::binary);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
         << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    file.write(reinterpret_cast<const char*>(mesh.positions.data()),
               static_cast<std::streamsize>(mesh.positions.size() * sizeof(glm::vec3)));
    for (const auto& triangle : mesh.triangles) {
        file.put(3);
        file.write(reinterpret_cast<const char*>(triangle.data()), 12);
    }
}

void writeObj(const fs::path& path, const TriangleMesh& mesh)
{
    std::FILE* file = std::fopen(path.c_str(), "w");
    for (const glm::vec3& p : mesh.positions) {
        std::fprintf(file, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    }
    for (const auto& t : mesh.triangles) {
        std::fprintf(file, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
    std::fclose(file);
}

int writeFiles(const fs::path& folder)
{
    const TriangleMesh mesh = sheetMesh(kSide);
    writePly(folder / "million.ply", mesh);
    writeObj(folder / "million.obj", mesh);
    NoProgress silent;
    const Project project = sheetProject(kSide, Level(3));
    const bool done = saveProject(folder / "million.trixel", project, silent) &&
                      exportPtx(folder / "million.ptx", project, {}, silent) &&
                      writeLargePtx(folder / "gib.ptx", std::uint64_t{1} << 30U, 9);
    return done ? 0 : 1;
}

double clockMs(clockid_t clock)
{
    timespec t{};
    clock_gettime(clock, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double processMs()
{
    return clockMs(CLOCK_PROCESS_CPUTIME_ID);
}

double threadMs()
{
    return clockMs(CLOCK_THREAD_CPUTIME_ID);
}

/// Knows what the window's thread spent in drawing frames: without a graphics card that is the
/// card's work.
class Application : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override
    {
        const bool isFrame = event->type() == QEvent::Paint &&
                             qobject_cast<QOpenGLWidget*>(receiver) != nullptr && !m_isInFrame;
        if (!isFrame) {
            return QApplication::notify(receiver, event);
        }
        m_isInFrame = true;
        const double before = threadMs();
        const bool isDone = QApplication::notify(receiver, event);
        m_frameMs += threadMs() - before;
        m_isInFrame = false;
        return isDone;
    }

    double frameMs() const { return m_frameMs; }

private:
    double m_frameMs = 0;
    bool m_isInFrame = false;
};

/// The longest times in which the window answers to nobody, in milliseconds.
struct Turns
{
    double wall = 0;
    double processor = 0; ///< of the thread
    double noFrames = 0;  ///< the same without drawing

    /// Lets the window do what there is to do.
    void take(const Application& application)
    {
        QElapsedTimer turn;
        turn.start();
        const double before = threadMs();
        const double framesBefore = application.frameMs();
        QCoreApplication::processEvents(QEventLoop::AllEvents);
        const double taken = threadMs() - before;
        wall = std::max(wall, 1e-6 * static_cast<double>(turn.nsecsElapsed()));
        processor = std::max(processor, taken);
        noFrames = std::max(noFrames, taken - (application.frameMs() - framesBefore));
        QThread::usleep(500);
    }
};

/// Milliseconds since `open`, on the clock and of the process on all cores.
struct Times
{
    double wall = 0;
    double processor = 0;
};

/// What the window shows, frame by frame.
class Watch
{
public:
    Watch(const Application& application, MainWindow& window, QOpenGLWidget& canvas)
        : m_application(application)
        , m_window(window)
        , m_canvas(canvas)
    {
        QObject::connect(&canvas, &QOpenGLWidget::frameSwapped, &canvas, [this] { look(); });
        QObject::connect(&window.files(), &ProjectFiles::opened, &canvas, [this] { loaded(); });
        QObject::connect(&window.files(), &ProjectFiles::meshOpened, &canvas, [this] { loaded(); });
        QObject::connect(&window.files(), &ProjectFiles::failed, [](const QString& sentence) {
            std::printf("failed: %s\n", qPrintable(sentence));
        });
    }

    void open(const QString& path)
    {
        m_empty = pixel();
        m_clock.start();
        m_processor = processMs();
        m_window.files().open(path);
        Turns turns;
        while (m_texels.wall == 0 && m_clock.elapsed() < 120000) {
            turns.take(m_application);
        }
        const Times first = m_texels;
        m_window.viewport().settle();
        const Times settled = now();
        const Times load = m_load;
        const Turns again = openAgain(path);
        std::printf(
            "%-18s loaded %6.0f (%6.0f)  surface %6.0f (%6.0f)  texels %6.0f (%6.0f)  "
            "complete %6.0f (%6.0f)  longest turn of the window %4.0f ms, of its thread %.0f, "
            "without frames %.0f; the second time %.0f, %.0f, %.0f\n",
            qPrintable(path.section('/', -1)),
            load.wall,
            load.processor,
            m_surface.wall,
            m_surface.processor,
            first.wall,
            first.processor,
            settled.wall,
            settled.processor,
            turns.wall,
            turns.processor,
            turns.noFrames,
            again.wall,
            again.processor,
            again.noFrames);
        std::fflush(stdout);
    }

private:
    /// In the place of what is open: until nothing has to be done for a while.
    Turns openAgain(const QString& path)
    {
        constexpr qint64 kAWhileMs = 1000;
        Turns turns;
        bool isLoaded = false;
        QElapsedTimer sinceLoaded;
        const auto loaded =
            QObject::connect(&m_window.files(), &ProjectFiles::opened, &m_canvas, [&] {
                isLoaded = true;
                sinceLoaded.start();
            });
        m_window.files().open(path);
        while (!isLoaded || sinceLoaded.elapsed() < kAWhileMs) {
            turns.take(m_application);
        }
        QObject::disconnect(loaded);
        return turns;
    }

    Times now() const
    {
        return {1e-6 * static_cast<double>(m_clock.nsecsElapsed()), processMs() - m_processor};
    }

    void loaded() { m_load = now(); }

    /// In the middle of the view.
    std::uint32_t pixel()
    {
        std::uint32_t read = 0;
        m_canvas.makeCurrent();
        glReadPixels(
            m_canvas.width() / 2, m_canvas.height() / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &read);
        m_canvas.doneCurrent();
        return read & 0xffffffU;
    }

    /// Unlit, a surface whose texels have not come is of one grey.
    void look()
    {
        constexpr std::uint32_t kPending = 0x737373;
        if (m_load.wall == 0 || m_texels.wall > 0) {
            return;
        }
        const Times shown = now();
        const std::uint32_t seen = pixel();
        if (seen == m_empty) {
            return;
        }
        if (m_surface.wall == 0) {
            m_surface = shown;
        }
        if (seen != kPending) {
            m_texels = shown;
        }
    }

    const Application& m_application;
    MainWindow& m_window;
    QOpenGLWidget& m_canvas;
    QElapsedTimer m_clock;
    double m_processor = 0;
    std::uint32_t m_empty = 0; ///< where there is no surface
    Times m_load, m_surface, m_texels;
};

} // namespace

int main(int count, char** arguments)
{
    if (count > 2 && std::string_view(arguments[1]) == "write") {
        return writeFiles(arguments[2]);
    }
    prepareApplication();
    const Application application(count, arguments);
    for (int k = 1; k < count; ++k) {
        MainWindow window; // as when the program starts
        window.resize(1500, 940);
        window.show();
        QCoreApplication::processEvents();
        ViewOptions view = window.settings().view();
        view.lit = false;
        window.settings().setView(view);
        auto* canvas = window.viewport().findChild<QOpenGLWidget*>();
        if (canvas == nullptr) {
            std::fprintf(stderr, "OpenGL is needed\n");
            return 1;
        }
        (void)window.viewport().grabFramebuffer();
        Watch(application, window, *canvas).open(arguments[k]);
    }
    return 0;
}

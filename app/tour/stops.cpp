// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/stops.h"

#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QLineEdit>

#include "app/tour/looks.h"
#include "core/io/ptx_check.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace trixel::app {

namespace {

/// A wave between two points, as a hand draws it.
std::vector<QPoint> wave(QPoint from, QPoint to, double height)
{
    constexpr int kPoints = 48;
    std::vector<QPoint> path;
    for (int k = 0; k <= kPoints; ++k) {
        const double t = static_cast<double>(k) / kPoints;
        const QPointF along = QPointF(from) * (1 - t) + QPointF(to) * t;
        path.push_back((along + QPointF(0, height * std::sin(t * 4 * std::numbers::pi))).toPoint());
    }
    return path;
}

Brush tourBrush(ui::MainWindow& window, std::array<float, 4> color, float share)
{
    Brush brush;
    brush.color = color;
    brush.radius = share * window.document().surface()->size();
    brush.hardness = 0.7F;
    return brush;
}

} // namespace

Stops::Stops(ui::MainWindow& window, std::filesystem::path folder)
    : m_window(window)
    , m_view(window.viewport())
    , m_input(window)
    , m_folder(std::move(folder))
{
}

QPoint Stops::inView(double x, double y) const
{
    return QPointF(x * m_view.width(), y * m_view.height()).toPoint();
}

Status Stops::picture(const std::string& name)
{
    return pictureOf(m_window, name);
}

Status Stops::pictureOf(QWidget& widget, const std::string& name)
{
    m_window.viewport().settle();
    const QString number = QString("%1").arg(m_taken + 1, 2, 10, QChar('0'));
    ++m_taken;
    return m_input.savePicture(widget, m_folder / (number.toStdString() + "-" + name + ".png"));
}

Status Stops::wholeScene()
{
    m_window.viewport().lookFrom(48, 12, 1.25);
    return picture("sample");
}

Status Stops::hoveredTexel()
{
    const std::optional<SurfacePoint> eye = m_window.viewport().surfacePointAt(inView(0.4, 0.4));
    if (Status seen = expect(eye.has_value(), "the scene fills the middle of the view"); !seen) {
        return seen;
    }
    m_input.wheel(m_view, inView(0.4, 0.4), 8);
    m_input.hover(m_view, inView(0.45, 0.45));
    return picture("texel-under-pointer");
}

Status Stops::paintedStroke()
{
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_window.settings().setBrush(tourBrush(m_window, {0.98F, 0.86F, 0.35F, 1.0F}, 0.006F));
    m_input.keys(Qt::Key_B);
    const int before = m_window.document().undoStack().index();
    m_input.drag(m_view, wave(inView(0.52, 0.45), inView(0.66, 0.45), 0.04 * m_view.height()));
    if (Status painted = expect(m_window.document().undoStack().index() == before + 1,
                                "a stroke is one undo step");
        !painted) {
        return painted;
    }
    return picture("painted-stroke");
}

Status Stops::undoneAndRedone()
{
    const int painted = m_window.document().undoStack().index();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Z));
    const bool undone = m_window.document().undoStack().index() == painted - 1;
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    const bool redone = m_window.document().undoStack().index() == painted;
    return expect(undone && redone, "Ctrl+Z and Ctrl+Shift+Z go back and forward");
}

Status Stops::texelsOfBothHalves()
{
    m_input.keys(Qt::Key_T);
    m_input.keys(Qt::Key_W);
    m_input.wheel(m_view, inView(0.58, 0.45), 14);
    m_input.hover(m_view, inView(0.5, 0.5));
    const Status shown = expect(m_window.settings().view().texelGrid, "T shows the texel grid");
    return shown ? picture("texel-grid") : shown;
}

Status Stops::mipLevels()
{
    m_input.keys(Qt::Key_PageDown);
    m_input.keys(Qt::Key_PageDown);
    if (Status coarser =
            expect(m_window.settings().view().mipDrop == 2, "Page Down shows a coarser level");
        !coarser) {
        return coarser;
    }
    const Status taken = picture("two-levels-coarser");
    m_input.keys(Qt::Key_PageUp);
    m_input.keys(Qt::Key_PageUp);
    m_input.keys(Qt::Key_T);
    m_input.keys(Qt::Key_W);
    return taken;
}

Status Stops::newProject()
{
    const std::filesystem::path mesh = m_folder / "chameleon.obj";
    QFile::remove(QString::fromStdString(mesh.string()));
    if (!QFile::copy(":/sample/chameleon.obj", QString::fromStdString(mesh.string()))) {
        return pathError(mesh.string() + ": the mesh could not be written");
    }
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_N));
    QDialog* dialog = openDialog();
    if (Status opened = expect(dialog != nullptr, "Ctrl+N asks for the mesh"); !opened) {
        return opened;
    }
    m_input.type(*dialog->findChild<QLineEdit*>(), QString::fromStdString(mesh.string()));
    const Status taken = pictureOf(*dialog, "new-from-mesh");
    m_input.keys(Qt::Key_Escape);
    return taken;
}

Status Stops::exportedTexture()
{
    const std::filesystem::path texture = m_folder / "chameleon.ptx";
    std::filesystem::remove(texture);
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    if (Status asked = askForExport("chameleon.ptx", "export"); !asked) {
        return asked;
    }
    m_input.keys(Qt::Key_Return);
    const bool written = m_input.waitFor(
        [&] { return m_window.messages().sentence().contains("read again and found equal"); });
    if (Status exported = expect(written, "the export ends with its size"); !exported) {
        return exported;
    }
    NoProgress progress;
    const Result<std::vector<std::string>> faults = checkPtx(texture, {}, progress);
    if (!faults) {
        return tl::unexpected(faults.error());
    }
    if (!faults->empty()) {
        return contentsError("tour: " + texture.string() + ": " + faults->front());
    }
    return picture("exported");
}

Status Stops::askForExport(const std::string& file, const std::string& pictureName)
{
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_E));
    QDialog* dialog = openDialog();
    if (Status opened = expect(dialog != nullptr, "Ctrl+E asks where to export"); !opened) {
        return opened;
    }
    m_input.type(*dialog->findChild<QLineEdit*>(),
                 QString::fromStdString((m_folder / file).string()));
    const auto labels = dialog->findChildren<QLabel*>();
    const auto size = std::ranges::find(labels, "Size estimate", &QLabel::accessibleName);
    const bool said = m_input.waitFor(
        [&] { return size != labels.end() && !(*size)->text().startsWith("Estimating"); });
    if (Status estimated = expect(said, "the dialog says what the export takes"); !estimated) {
        return estimated;
    }
    return pictureName.empty() ? Status() : pictureOf(*dialog, pictureName);
}

/// Out as an atlas; the dialog for meshes is only looked at.
Status Stops::exportedAtlas()
{
    if (Status asked = askForExport("chameleon.glb", "export-mesh"); !asked) {
        return asked;
    }
    m_input.keys(Qt::Key_Escape);
    if (Status asked = askForExport("chameleon.png", "export-atlas"); !asked) {
        return asked;
    }
    m_input.keys(Qt::Key_Return);
    const bool written = m_input.waitFor(
        [&] { return m_window.messages().sentence().startsWith("Exported chameleon.png"); },
        120'000);
    return expect(written && std::filesystem::exists(m_folder / "chameleon.json"),
                  "the atlas is written with what describes it");
}

} // namespace trixel::app

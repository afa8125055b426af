// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stops at other files: what differs from one, paint from another mesh, images by uvs.
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "core/io/project.h"
#include "ui/exchange/difference_model.h"
#include "ui/exchange/difference_panel.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace trixel::app {

namespace {

/// Files of the sample's size are written and read, on a busy machine slowly.
constexpr int kPatienceMs = 120'000;

template <class T>
T* named(const QWidget& parent, const QString& name)
{
    const auto widgets = parent.findChildren<T*>();
    const auto found = std::ranges::find(widgets, name, &QWidget::accessibleName);
    return found == widgets.end() ? nullptr : *found;
}

/// A vase, turned about its axis, with uvs around it and up.
Status writeVase(const std::filesystem::path& path)
{
    constexpr int kAround = 48;
    constexpr int kUp = 32;
    std::ofstream file(path);
    for (int y = 0; y <= kUp; ++y) {
        const double t = static_cast<double>(y) / kUp;
        const double radius = 0.45 + 0.25 * std::sin(5.2 * t) - 0.15 * t;
        for (int x = 0; x <= kAround; ++x) {
            const double s = static_cast<double>(x) / kAround;
            const double angle = 2 * std::numbers::pi * s;
            file << "v " << radius * std::cos(angle) << ' ' << 2 * t << ' '
                 << -radius * std::sin(angle) << "\nvt " << 0.02 + 0.96 * s << ' '
                 << 0.02 + 0.96 * t << '\n';
        }
    }
    for (int y = 0; y < kUp; ++y) {
        for (int x = 0; x < kAround; ++x) {
            const int a = y * (kAround + 1) + x + 1;
            file << "f";
            for (const int corner : {a, a + 1, a + kAround + 2, a + kAround + 1}) {
                file << ' ' << corner << '/' << corner;
            }
            file << '\n';
        }
    }
    file.close();
    return file ? Status() : Status(pathError(path.string() + ": could not be written"));
}

} // namespace

/// With what was exported before a stroke is painted and a face is halved.
Status Stops::comparedFile()
{
    const std::filesystem::path file = m_folder / "compared.ptx";
    NoProgress progress;
    if (Status written = exportPtx(file, m_window.document().snapshot(), {}, progress); !written) {
        return written;
    }
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_input.keys(Qt::Key_B);
    m_input.drag(m_view,
                 std::vector<QPoint>{inView(0.48, 0.5), inView(0.54, 0.46), inView(0.6, 0.5)});
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D));
    QDialog* dialog = openDialog();
    if (Status opened = expect(dialog != nullptr, "File > Compare asks for a file"); !opened) {
        return opened;
    }
    m_input.type(*named<QLineEdit>(*dialog, "Second file"), QString::fromStdString(file.string()));
    const auto* compare = named<QPushButton>(*dialog, "Compare");
    const bool fits = m_input.waitFor([&] { return compare->isEnabled(); }, kPatienceMs);
    if (Status looked = expect(fits, "the dialog says that the file fits"); !looked) {
        return looked;
    }
    if (Status taken = pictureOf(*dialog, "compare-with-file"); !taken) {
        return taken;
    }
    m_input.keys(Qt::Key_Return);
    auto* panel = m_window.findChild<ui::DifferencePanel*>();
    const bool compared = m_input.waitFor(
        [&] {
            return panel->comparison() && panel->model().rowCount() > 0 &&
                   m_window.viewMap().isComplete();
        },
        kPatienceMs);
    if (Status listed = expect(compared, "faces that differ are listed and shown"); !listed) {
        return listed;
    }
    m_input.settle();
    m_input.hover(m_view, inView(0.54, 0.46));
    const Status taken = picture("difference-from-file");
    auto* table = panel->findChild<QTableView*>();
    m_input.click(*table->viewport(), table->visualRect(panel->model().index(0, 0)).center());
    const bool chosen = m_window.selection().contains(panel->model().differenceAt(0).face);
    m_window.selection().clear();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_1));
    m_window.findChild<QDockWidget*>("differencePanel")->hide();
    m_window.findChild<QDockWidget*>("readoutPanel")->raise();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Z));
    return taken ? expect(chosen, "a click on a row selects the face") : taken;
}

/// The vase has uvs: it goes out by them.
Status Stops::bakedOut()
{
    const std::filesystem::path mesh = m_folder / "vase.obj";
    if (Status written = writeVase(mesh); !written) {
        return written;
    }
    m_window.files().open(QString::fromStdString(mesh.string()));
    const bool opened = m_input.waitFor(
        [&] { return m_window.document().title() == "vase" && m_window.viewport().canDraw(); });
    if (Status there = expect(opened, "the vase opens"); !there) {
        return there;
    }
    m_input.keys(Qt::Key_B);
    m_input.drag(m_view,
                 std::vector<QPoint>{inView(0.45, 0.4), inView(0.5, 0.55), inView(0.55, 0.4)});
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_E));
    QDialog* dialog = openDialog();
    if (Status asked = expect(dialog != nullptr, "Ctrl+E asks where to export"); !asked) {
        return asked;
    }
    m_input.type(*dialog->findChild<QLineEdit*>(),
                 QString::fromStdString((m_folder / "vase.tx").string()));
    const auto* size = named<QLabel>(*dialog, "Size estimate");
    const bool said =
        m_input.waitFor([&] { return size->text().contains("1 image of"); }, kPatienceMs);
    if (Status estimated = expect(said, "the dialog says what the image takes"); !estimated) {
        return estimated;
    }
    if (Status taken = pictureOf(*dialog, "export-by-uvs"); !taken) {
        return taken;
    }
    m_input.keys(Qt::Key_Return);
    const bool written = m_input.waitFor(
        [&] { return m_window.messages().sentence().startsWith("Exported vase.tx"); }, kPatienceMs);
    return expect(written, "the image is written");
}

/// From the sample onto the cage that it was refined from: other faces, of nearly the same shape.
Status Stops::transferredPaint()
{
    const std::filesystem::path mesh = m_folder / "chameleon.obj"; // written by an earlier stop
    m_window.files().open(QString::fromStdString(mesh.string()));
    const bool opened = m_input.waitFor([&] { return m_window.document().title() == "chameleon"; });
    if (Status there = expect(opened, "the cage opens"); !there) {
        return there;
    }
    m_window.viewport().lookFrom(48, 12, 1.25);
    if (Status chosen = command("transfer paint"); !chosen) {
        return chosen;
    }
    QDialog* dialog = openDialog();
    if (Status asked = expect(dialog != nullptr, "File > Transfer Paint asks for a file"); !asked) {
        return asked;
    }
    m_input.type(*named<QLineEdit>(*dialog, "Painted file"),
                 QString::fromStdString((m_folder / "compared.ptx").string()));
    const auto* transfer = named<QPushButton>(*dialog, "Transfer");
    const bool reached = m_input.waitFor([&] { return transfer->isEnabled(); }, kPatienceMs);
    if (Status measured = expect(reached, "the dialog says how many texels take paint");
        !measured) {
        return measured;
    }
    if (Status taken = pictureOf(*dialog, "transfer-paint"); !taken) {
        return taken;
    }
    m_input.keys(Qt::Key_Return);
    const bool arrived = m_input.waitFor(
        [&] { return m_window.messages().sentence().contains("texels took paint"); }, kPatienceMs);
    if (Status done = expect(arrived && m_window.document().undoStack().count() == 1,
                             "paint arrives in one undo step");
        !done) {
        return done;
    }
    return picture("transferred-paint");
}

} // namespace trixel::app

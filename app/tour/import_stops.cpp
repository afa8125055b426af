// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at an image laid onto the faces.
#include <QComboBox>
#include <QImage>
#include <QPainter>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/import/corner_handle.h"
#include "ui/import/distortion_view.h"
#include "ui/import/import_look.h"
#include "ui/import/import_panel.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

#include <algorithm>
#include <array>

namespace trixel::app {

namespace {

constexpr int kPatienceMs = 120'000;

/// Rings and squares, whose stretching the eye sees at once.
QImage poster()
{
    constexpr int kCell = 64;
    QImage image(10 * kCell, 6 * kCell, QImage::Format_RGB32);
    image.fill(QColor(0xf2, 0xe8, 0xcf));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int row = 0; row < 6; ++row) {
        for (int column = row % 2; column < 10; column += 2) {
            painter.fillRect(column * kCell, row * kCell, kCell, kCell, QColor(0x2a, 0x6f, 0x97));
        }
    }
    painter.setBrush(Qt::NoBrush);
    for (int ring = 1; ring < 6; ++ring) {
        painter.setPen(QPen(QColor(0xd6, 0x28, 0x28), 10));
        painter.drawEllipse(QPointF(5 * kCell, 3 * kCell), 32.0 * ring, 32.0 * ring);
    }
    return image;
}

void chooseEntry(InputDriver& input, QComboBox& box, const QString& entry)
{
    input.press(box, Qt::Key_Home);
    for (int k = 0; k < box.count() && box.currentText() != entry; ++k) {
        input.press(box, Qt::Key_Down);
    }
}

QComboBox* boxNamed(QWidget& panel, const QString& name)
{
    const auto boxes = panel.findChildren<QComboBox*>();
    const auto found = std::ranges::find(boxes, name, &QComboBox::accessibleName);
    return found == boxes.end() ? nullptr : *found;
}

} // namespace

Status Stops::draggedCorner(const QString& name, QPoint by)
{
    const auto handles = m_view.findChildren<ui::CornerHandle*>();
    const auto found = std::ranges::find(handles, name, &ui::CornerHandle::accessibleName);
    if (found == handles.end() || !(*found)->isVisible()) {
        return contentsError("tour: there is a handle for " + name.toStdString());
    }
    const QPointF before = (*found)->place();
    const QPoint middle = (*found)->rect().center();
    // The handle comes along: each point is where it has come to.
    constexpr int kSteps = 8;
    const std::array<QPoint, 2> step = {middle, middle + by / kSteps};
    for (int k = 0; k < kSteps; ++k) {
        m_input.drag(**found, step);
    }
    return expect((*found)->place() != before, "a dragged corner moves");
}

/// How a sphere stretches the image, over the surface.
Status Stops::distortedImage(ui::ImportPanel& panel, QComboBox& kinds)
{
    chooseEntry(m_input, kinds, "Sphere");
    if (Status pressed = press(panel, "Show the distortion of the image"); !pressed) {
        return pressed;
    }
    const ui::DistortionView& view = panel.look().distortion();
    const bool shown = m_input.waitFor(
        [&] {
            return view.isShown() && !view.shown()->mapping.projection && panel.picture() &&
                   panel.picture()->isComplete;
        },
        kPatienceMs);
    m_input.hover(m_view, inView(0.45, 0.45));
    if (Status done = expect(shown && m_window.viewport().hasFaceColors() &&
                                 view.legend().state().contains("texels a pixel"),
                             "the distortion of a sphere's image is mapped");
        !done) {
        return done;
    }
    const Status taken = picture("import-distortion");
    return taken ? press(panel, "Show the texels with the image") : taken;
}

Status Stops::importedImage()
{
    const std::filesystem::path file = m_folder / "poster.png";
    if (!poster().save(QString::fromStdString(file.string()))) {
        return pathError(file.string() + ": the image could not be written");
    }
    const ui::Document& document = m_window.document();
    const ui::StateId before = document.state();
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O));
    auto* panel = m_window.findChild<ui::ImportPanel*>();
    if (Status shown = expect(panel->isVisible(), "Ctrl+Shift+O shows the panel of imports");
        !shown) {
        return shown;
    }
    panel->begin(QString::fromStdString(file.string()));
    QComboBox* kinds = boxNamed(*panel, "How the image lies on the surface");
    chooseEntry(m_input, *kinds, "Camera");
    const auto previewed = [&] {
        return m_input.waitFor([&] { return panel->picture() && panel->picture()->isComplete; },
                               kPatienceMs);
    };
    if (Status done = expect(previewed(), "an image is previewed"); !done) {
        return done;
    }
    if (Status moved = draggedCorner("Upper right corner of the image", {-80, 64}); !moved) {
        return moved;
    }
    if (Status done = expect(previewed() && document.state() == before,
                             "a preview follows the corner and changes nothing");
        !done) {
        return done;
    }
    if (Status taken = picture("import-image"); !taken) {
        return taken;
    }
    if (Status distorted = distortedImage(*panel, *kinds); !distorted) {
        return distorted;
    }
    chooseEntry(m_input, *kinds, "Camera");
    if (Status pressed = press(*panel, "Apply the import"); !pressed) {
        return pressed;
    }
    const bool applied = m_input.waitFor([&] { return document.state() != before; }, kPatienceMs);
    const bool told = m_window.messages().sentence().startsWith("Imported poster.png");
    if (Status done = expect(applied && told && !panel->isVisible(), "Apply imports the image");
        !done) {
        return done;
    }
    m_window.viewport().lookFrom(75, 12, 1.25);
    if (Status taken = picture("imported"); !taken) {
        return taken;
    }
    m_window.messages().dismiss();
    m_view.setFocus();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Z));
    return expect(document.state() == before, "one step takes an imported image back");
}

} // namespace trixel::app

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at paint on layers.
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "ui/layers/layer_list.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

#include <algorithm>
#include <array>
#include <vector>

namespace trixel::app {

namespace {

template <class T>
T* named(QWidget& parent, const QString& name)
{
    const QList<T*> all = parent.findChildren<T*>();
    const auto found = std::ranges::find(all, name, &T::accessibleName);
    return found != all.end() ? *found : nullptr;
}

bool areEqual(const TexelStore& a, const TexelStore& b)
{
    for (std::size_t k = 0; k < a.faceCount(); ++k) {
        if (!(a.face(faceId(k)) == b.face(faceId(k)))) {
            return false;
        }
    }
    return true;
}

/// A broad band down the animal's side.
std::vector<QPoint> band(QPoint from, QPoint to)
{
    constexpr int kPoints = 24;
    std::vector<QPoint> path;
    for (int k = 0; k <= kPoints; ++k) {
        path.push_back(from + (to - from) * k / kPoints);
    }
    return path;
}

} // namespace

Status Stops::paintedLayers()
{
    auto* dock = m_window.findChild<QDockWidget*>("layerPanel");
    auto* list = m_window.findChild<ui::LayerList*>();
    const auto rows = [&] { return list->model()->rowCount(); };
    dock->show();
    dock->raise();
    m_input.keys(Qt::Key_A);
    m_window.viewport().lookFrom(48, 12, 1.25);
    m_input.keys(Qt::Key_B);
    const int before = m_window.document().undoStack().index();
    if (Status painted = bandOnLayer({0.86F, 0.25F, 0.2F, 1}, 0.44, 1); !painted) {
        return painted;
    }
    if (Status painted = bandOnLayer({0.2F, 0.55F, 0.85F, 1}, 0.52, 2); !painted) {
        return painted;
    }
    auto* blend = named<QComboBox>(*dock, "Blend mode");
    auto* opacity = named<QDoubleSpinBox>(*dock, "Layer opacity");
    m_input.press(*blend, Qt::Key_Down); // after Normal comes Multiply
    m_input.type(*opacity, "70");
    m_input.press(*opacity, Qt::Key_Return);
    const QString hint = list->currentIndex().data(Qt::AccessibleTextRole).toString();
    if (Status set =
            expect(hint == "Layer 2: Multiply · 70 %", "the list tells " + hint.toStdString());
        !set) {
        return set;
    }
    if (Status taken = picture("layers"); !taken) {
        return taken;
    }
    if (Status hidden = hiddenLayer(*list); !hidden) {
        return hidden;
    }
    if (Status exported = exportedLayer(); !exported) {
        return exported;
    }
    while (m_window.document().undoStack().index() > before) {
        m_input.keys(QKeySequence(Qt::CTRL | Qt::Key_Z));
    }
    m_window.findChild<QDockWidget*>("readoutPanel")->raise();
    return expect(rows() == 1, "Ctrl+Z takes the layers back, one by one");
}

/// A layer more, and a stroke on it.
/// \param height  of the stroke's middle, a share of the view's
Status Stops::bandOnLayer(const std::array<float, 4>& color, double height, int layers)
{
    const ui::Document& document = m_window.document();
    m_input.keys(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N));
    if (Status added = expect(document.layers().layers().size() == std::size_t(layers) &&
                                  document.activeLayer() != kBaseLayer,
                              "Ctrl+Shift+N adds a layer and makes it the active one");
        !added) {
        return added;
    }
    Brush brush;
    brush.color = color;
    brush.radius = 0.025F * document.surface()->size();
    brush.hardness = 0.8F;
    m_window.settings().setBrush(brush);
    const TexelStore base = document.layers().base();
    const TexelStore blank = document.layers().texels(document.activeLayer());
    m_input.drag(m_view, band(inView(0.4, height - 0.06), inView(0.62, height + 0.06)));
    return expect(!areEqual(document.layers().texels(document.activeLayer()), blank) &&
                      areEqual(document.layers().base(), base),
                  "a stroke lands on the active layer and leaves the base");
}

Status Stops::hiddenLayer(ui::LayerList& list)
{
    const QModelIndex top = list.model()->index(0, 0);
    const TexelStore shown = m_window.document().texels();
    m_input.click(*list.viewport(), list.eyeRect(top).center());
    const bool hidden = top.data(Qt::CheckStateRole).toInt() == Qt::Unchecked &&
                        !areEqual(m_window.document().texels(), shown);
    const Status taken = picture("layer-hidden");
    m_input.click(*list.viewport(), list.eyeRect(top).center());
    if (!taken) {
        return taken;
    }
    return expect(hidden && areEqual(m_window.document().texels(), shown),
                  "the eye hides a layer and shows it again");
}

/// One layer alone, its coverage as opacity.
Status Stops::exportedLayer()
{
    if (Status asked = askForExport("band.png", {}); !asked) {
        return asked;
    }
    QDialog* dialog = openDialog();
    auto* layer = named<QComboBox>(*dialog, "Layer");
    if (Status offered = expect(layer != nullptr, "the export offers layers"); !offered) {
        return offered;
    }
    layer->setCurrentIndex(layer->findText("Layer 2"));
    m_input.settle();
    if (Status taken = pictureOf(*dialog, "export-layer"); !taken) {
        return taken;
    }
    m_input.keys(Qt::Key_Return);
    const bool written = m_input.waitFor(
        [&] { return m_window.messages().sentence().startsWith("Exported band.png"); }, 120'000);
    return expect(written, "a layer is exported alone");
}

} // namespace trixel::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layers/layer_commands.h"

#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/document/made_layers.h"
#include "ui/layers/layer_words.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

LayerCommands::LayerCommands(Document& document, BackgroundJobs& jobs, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_jobs(jobs)
{
    connect(&document, &Document::layersChanged, this, &LayerCommands::changed);
    connect(&document, &Document::opened, this, &LayerCommands::changed);
    connect(&document, &Document::activeLayerChanged, this, &LayerCommands::changed);
}

int LayerCommands::placeOf(LayerId layer) const
{
    const auto index = m_document.layers().indexOf(layer);
    return index ? static_cast<int>(*index) : -1;
}

int LayerCommands::activePlace() const
{
    return placeOf(m_document.activeLayer());
}

LayerId LayerCommands::layerAt(int place) const
{
    return place < 0 ? kBaseLayer
                     : m_document.layers().layers()[static_cast<std::size_t>(place)].id;
}

QString LayerCommands::whyNot(LayerCommand command) const
{
    const LayerStack& layers = m_document.layers();
    const int top = static_cast<int>(layers.layers().size()) - 1;
    const bool isBase = m_document.activeLayer() == kBaseLayer;
    if (!m_document.isOpen()) {
        return tr("No mesh is open.");
    }
    switch (command) {
    case LayerCommand::Add:
        return whyNoRoom();
    case LayerCommand::Duplicate:
        return isBase ? tr("The base is there once.") : whyNoRoom();
    case LayerCommand::Rename:
        return isBase ? tr("The base has no name of its own.") : QString();
    case LayerCommand::Show:
        return isBase ? tr("The base is always shown.") : QString();
    case LayerCommand::MoveUp:
        return isBase                 ? tr("The base stays below all layers.")
               : activePlace() == top ? tr("It is the topmost layer.")
                                      : QString();
    case LayerCommand::MoveDown:
        return isBase               ? tr("The base stays below all layers.")
               : activePlace() == 0 ? tr("Only the base lies below.")
                                    : QString();
    case LayerCommand::GoAbove:
        return activePlace() == top ? tr("Nothing lies above.") : QString();
    case LayerCommand::GoBelow:
        return isBase ? tr("Nothing lies below the base.") : QString();
    case LayerCommand::MergeDown:
        return whyNoMerge(m_document.activeLayer());
    case LayerCommand::Flatten:
        return layers.isPlain() ? tr("There are no layers.") : QString();
    case LayerCommand::Delete:
        return isBase ? tr("The base stays.") : QString();
    }
    return {};
}

QString LayerCommands::whyNoRoom() const
{
    const LayerStack& layers = m_document.layers();
    if (layers.isPlain()) {
        return LayerStack(m_document.texels()).hasRoom()
                   ? QString()
                   : tr("The texels have too many channels for layers.");
    }
    return layers.hasRoom() ? QString()
                            : tr("There is no room for another layer: %1 are there.")
                                  .arg(layers.layers().size());
}

QString LayerCommands::whyNoMerge(LayerId layer) const
{
    const LayerStack& layers = m_document.layers();
    const int from = placeOf(layer);
    if (from < 0) {
        return tr("Nothing lies below the base.");
    }
    if (m_isMerging) {
        return tr("Layers are being merged.");
    }
    const auto isHidden = [&](int place) {
        return place >= 0 && !layers.settings(layerAt(place)).isVisible;
    };
    return isHidden(from)       ? tr("A hidden layer is not merged: show it first.")
           : isHidden(from - 1) ? tr("The layer below is hidden: show it first.")
                                : QString();
}

void LayerCommands::run(LayerCommand command)
{
    if (!whyNot(command).isEmpty()) {
        return;
    }
    const LayerId layer = m_document.activeLayer(); // it may be another when paint has settled
    switch (command) {
    case LayerCommand::Add:
        whenStill([this, layer] { add(layer); });
        break;
    case LayerCommand::Duplicate:
        whenStill([this, layer] { duplicate(layer); });
        break;
    case LayerCommand::Rename:
        emit renameWanted();
        break;
    case LayerCommand::Show:
        setVisible(layer, !m_document.layers().settings(layer).isVisible);
        break;
    case LayerCommand::MoveUp:
        moveBy(1);
        break;
    case LayerCommand::MoveDown:
        moveBy(-1);
        break;
    case LayerCommand::GoAbove:
        go(1);
        break;
    case LayerCommand::GoBelow:
        go(-1);
        break;
    case LayerCommand::MergeDown: // these two take what is shown
        m_document.endStroke();
        m_document.whenSettled([this, layer] { mergeDown(layer); });
        break;
    case LayerCommand::Flatten:
        m_document.endStroke();
        m_document.whenSettled([this] { flatten(); });
        break;
    case LayerCommand::Delete:
        whenStill([this, layer] { remove(layer); });
        break;
    }
}

/// The layers hold all that was painted when they are copied to be changed. What they look like
/// need not be known yet: a slider does not wait for its last move.
void LayerCommands::whenStill(std::function<void()> edit)
{
    m_document.endStroke();
    m_document.whenPainted([this, edit = std::move(edit)] {
        if (m_document.isOpen()) {
            edit();
        }
    });
}

void LayerCommands::add(LayerId above)
{
    LayerStack next =
        m_document.layers().isPlain() ? LayerStack(m_document.texels()) : m_document.layers();
    if (!next.hasRoom()) {
        return;
    }
    LayerSettings settings;
    settings.name = freeLayerName(next, tr("Layer %1")).toStdString();
    const auto place = static_cast<std::size_t>(placeOf(above) + 1);
    const LayerId added = next.insert(place, std::move(settings));
    m_document.editLayers(std::move(next), added, tr("Add layer"));
}

void LayerCommands::duplicate(LayerId layer)
{
    LayerStack next = m_document.layers();
    const auto place = next.indexOf(layer);
    if (!place || !next.hasRoom()) {
        return;
    }
    LayerSettings settings = next.settings(layer);
    const QString name = QString::fromStdString(settings.name);
    settings.name = tr("%1 copy").arg(name).left(kLongestName).toStdString();
    const LayerId added = next.insert(*place + 1, std::move(settings), next.texels(layer));
    m_document.editLayers(std::move(next), added, tr("Duplicate layer"));
}

void LayerCommands::rename(LayerId layer, const QString& name)
{
    const QString tidy = name.simplified().left(kLongestName);
    if (!tidy.isEmpty()) {
        change(layer, tr("Rename layer"), [tidy](LayerSettings& settings) {
            settings.name = tidy.toStdString();
        });
    }
}

void LayerCommands::setVisible(LayerId layer, bool isVisible)
{
    change(layer,
           isVisible ? tr("Show layer") : tr("Hide layer"),
           [isVisible](LayerSettings& settings) { settings.isVisible = isVisible; });
}

void LayerCommands::setBlend(LayerId layer, LayerBlend blend)
{
    change(layer, tr("Blend layer as %1").arg(titleOf(blend)), [blend](LayerSettings& settings) {
        settings.blend = blend;
    });
}

void LayerCommands::setOpacity(LayerId layer, float opacity, bool goesOn)
{
    change(
        layer,
        tr("Layer opacity"),
        [opacity](LayerSettings& settings) { settings.opacity = std::clamp(opacity, 0.0F, 1.0F); },
        goesOn);
}

void LayerCommands::change(LayerId layer,
                           const QString& text,
                           const std::function<void(LayerSettings&)>& edit,
                           bool goesOn)
{
    whenStill([this, layer, text, edit, goesOn] {
        if (!m_document.layers().indexOf(layer)) {
            return;
        }
        LayerSettings settings = m_document.layers().settings(layer);
        edit(settings);
        if (settings != m_document.layers().settings(layer)) {
            LayerStack next = m_document.layers();
            next.set(layer, std::move(settings));
            m_document.editLayers(std::move(next), m_document.activeLayer(), text, goesOn);
        }
    });
}

void LayerCommands::move(LayerId layer, std::size_t index)
{
    whenStill([this, layer, index] {
        LayerStack next = m_document.layers();
        const auto from = next.indexOf(layer);
        if (from && *from != index && index < next.layers().size()) {
            next.move(layer, index);
            m_document.editLayers(std::move(next), m_document.activeLayer(), tr("Move layer"));
        }
    });
}

void LayerCommands::moveBy(int places)
{
    move(m_document.activeLayer(), static_cast<std::size_t>(activePlace() + places));
}

void LayerCommands::go(int places)
{
    m_document.setActiveLayer(layerAt(activePlace() + places));
}

void LayerCommands::mergeDown(LayerId layer)
{
    if (!whyNoMerge(layer).isEmpty()) {
        return;
    }
    m_isMerging = true;
    emit changed();
    m_jobs.run(
        tr("Merging layers…"),
        [project = m_document.snapshot(), layer](Progress& progress) {
            return withLayerMerged(project, layer, progress);
        },
        [this, madeFor = m_document.state()](Result<LayersEdit> merged) {
            m_isMerging = false;
            if (merged) {
                m_document.replaceLayers(std::move(*merged), madeFor, tr("Merge layer down"));
            } else if (merged.error().kind != ErrorKind::Cancelled) {
                emit failed(QString::fromStdString(merged.error().message));
            }
            emit changed();
        });
}

/// What is shown becomes the base; hidden layers show nothing.
void LayerCommands::flatten()
{
    const auto layers = m_document.layers().layers();
    const int hidden = static_cast<int>(std::ranges::count_if(
        layers, [](const Layer& layer) { return !layer.settings.isVisible; }));
    if (layers.empty()) {
        return;
    }
    const bool isDone =
        m_document.editLayers(LayerStack(m_document.texels()), kBaseLayer, tr("Flatten layers"));
    if (isDone && hidden > 0) {
        emit done(hidden == 1 ? tr("Flattened; the hidden layer is gone.")
                              : tr("Flattened; the %1 hidden layers are gone.").arg(hidden));
    }
}

void LayerCommands::remove(LayerId layer)
{
    LayerStack next = m_document.layers();
    if (!next.indexOf(layer)) {
        return;
    }
    const LayerId active = m_document.activeLayer();
    const LayerId left = active == layer ? layerAt(placeOf(layer) - 1) : active;
    next.remove(layer);
    m_document.editLayers(std::move(next), left, tr("Delete layer"));
}

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layers/layer_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::LayerWords", text);
}

} // namespace

QString titleOf(LayerBlend blend)
{
    switch (blend) {
    case LayerBlend::Normal:
        return tr("Normal");
    case LayerBlend::Multiply:
        return tr("Multiply");
    case LayerBlend::Screen:
        return tr("Screen");
    case LayerBlend::Overlay:
        return tr("Overlay");
    case LayerBlend::Darken:
        return tr("Darken");
    case LayerBlend::Lighten:
        return tr("Lighten");
    case LayerBlend::Add:
        return tr("Add");
    case LayerBlend::Subtract:
        return tr("Subtract");
    case LayerBlend::Difference:
        return tr("Difference");
    }
    return {};
}

QString opacityText(float opacity)
{
    return tr("%1 %").arg(std::lround(100 * opacity));
}

QString layerName(const LayerStack& layers, LayerId layer)
{
    return layer == kBaseLayer ? tr("Base") : QString::fromStdString(layers.settings(layer).name);
}

QString settingsHint(const LayerSettings& settings)
{
    QStringList parts;
    if (settings.blend != LayerBlend::Normal) {
        parts += titleOf(settings.blend);
    }
    if (settings.opacity < 1) {
        parts += opacityText(settings.opacity);
    }
    return parts.join(QStringLiteral(" · "));
}

QString whyUnseen(const LayerStack& layers, LayerId layer)
{
    if (layer == kBaseLayer) {
        return {};
    }
    const LayerSettings& settings = layers.settings(layer);
    return !settings.isVisible
               ? tr("%1 is hidden: show it to paint on it.").arg(layerName(layers, layer))
           : settings.opacity == 0
               ? tr("The opacity of %1 is 0 %: what is painted on it is not seen.")
                     .arg(layerName(layers, layer))
               : QString();
}

QString freeLayerName(const LayerStack& layers, const QString& pattern)
{
    for (std::size_t number = 1;; ++number) {
        const QString name = pattern.arg(number);
        const bool isTaken = std::ranges::any_of(layers.layers(), [&](const Layer& layer) {
            return QString::fromStdString(layer.settings.name) == name;
        });
        if (!isTaken) {
            return name;
        }
    }
}

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_words.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "ui/dialogs/format_choice.h"
#include "ui/layers/layer_words.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr const char* kEndings[] = {
    "png", "jpg", "jpeg", "tif", "tiff", "tx", "exr", "hdr", "tga", "bmp", "webp"};

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::ImportWords", text);
}

QString spaceName(ColorSpace space)
{
    switch (space) {
    case ColorSpace::SRgb:
        return tr("sRGB");
    case ColorSpace::Linear:
        return tr("linear light");
    case ColorSpace::Raw:
        break;
    }
    return tr("raw data");
}

} // namespace

QString imageFilter()
{
    QStringList patterns;
    for (const char* ending : kEndings) {
        patterns += QString("*.%1").arg(ending);
    }
    return tr("Images (%1)").arg(patterns.join(' ')) + ";;" + tr("All files (*)");
}

bool isImageName(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    return std::ranges::any_of(kEndings, [&](const char* one) { return ending == one; });
}

QString colorText(const Image& image)
{
    for (std::size_t c = 0; c < image.colors().size(); ++c) {
        if (image.format().alpha != static_cast<std::uint16_t>(c)) {
            return spaceName(image.colors()[c]);
        }
    }
    return spaceName(ColorSpace::Raw);
}

QString aboutText(const ImportImages& images)
{
    const Image& image = images.first();
    const int channels = image.format().channels;
    const QString one = tr("%1 × %2 pixels, %3 of %4, %5")
                            .arg(countText(static_cast<std::uint64_t>(image.width())),
                                 countText(static_cast<std::uint64_t>(image.height())),
                                 channels == 1 ? tr("1 channel") : tr("%1 channels").arg(channels),
                                 QString::fromStdString(std::string(nameOf(image.format().type))),
                                 colorText(image));
    return images.hasTiles() ? tr("%1 tiles, the first %2").arg(images.images.size()).arg(one)
                             : one;
}

QString channelName(const TexelFormat& format, int channel)
{
    if (format.alpha == static_cast<std::uint16_t>(channel)) {
        return tr("Opacity alone");
    }
    const int colors = format.channels - (format.alpha ? 1 : 0);
    if (colors == 1) {
        return tr("Grey alone");
    }
    constexpr const char* kNames[] = {"Red alone", "Green alone", "Blue alone"};
    return colors == 3 && channel < 3 ? tr(kNames[channel])
                                      : tr("Channel %1 alone").arg(channel + 1);
}

QString secondsText(double seconds)
{
    if (seconds < 0.1) {
        return tr("less than 0.1 seconds");
    }
    if (seconds < 90) {
        return tr("about %1 seconds").arg(seconds, 0, 'g', 2);
    }
    return tr("about %1 minutes").arg(std::round(seconds / 60));
}

QString placeText(const LayerStack& layers, LayerId below)
{
    const auto place = layers.indexOf(below);
    const auto above = layers.layers().subspan(place ? *place + 1 : 0);
    const bool isCovered =
        std::ranges::any_of(above, [](const Layer& layer) { return layer.settings.isVisible; });
    return isCovered ? ' ' + tr("Shown over all layers, it will lie right above %1.")
                                 .arg(layerName(layers, below))
                     : QString();
}

QString problemText(const Error& error)
{
    QString text = QString::fromStdString(error.message);
    const qsizetype word = text.indexOf(' ');
    const bool namesFile = text.left(word).contains('/') || text.left(word).contains('.');
    if (!text.isEmpty() && !namesFile) {
        text[0] = text[0].toUpper();
    }
    return text.endsWith('.') ? text : text + '.';
}

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/distortion_scale.h"

#include <QCoreApplication>

#include <cmath>

namespace trixel::ui {

namespace {

/// So many times more texels than pixels, or fewer, along a side.
constexpr double kMostRatio = 16;

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::DistortionScale", text);
}

} // namespace

const MapScale& distortionScale(DistortionMeasure measure)
{
    static const MapScale kTexels = MapScale::ofDensities(1 / kMostRatio, kMostRatio);
    static const MapScale kStretch = MapScale::of(ViewMapKind::Condition);
    return measure == DistortionMeasure::Stretch ? kStretch : kTexels;
}

QString distortionTitle(DistortionMeasure measure)
{
    return measure == DistortionMeasure::Stretch
               ? tr("How many times longer than wide the image's pixels are drawn; grey: not "
                    "reached")
               : tr("Texels a pixel of the image, along a side: above 1 the image is magnified, "
                    "below 1 it loses detail; grey: not reached");
}

QString distortionText(DistortionMeasure measure, double number)
{
    if (std::isnan(number)) {
        return tr("not reached");
    }
    if (std::isinf(number)) {
        return tr("without end");
    }
    const QString text = QString::number(number, 'g', 3);
    return measure == DistortionMeasure::Stretch ? tr("%1 : 1").arg(text)
                                                 : tr("%1 texels a pixel").arg(text);
}

} // namespace trixel::ui

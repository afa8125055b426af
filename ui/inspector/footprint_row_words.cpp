// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the rows of a footprint's numbers are called and mean.
#include <QCoreApplication>

#include "ui/inspector/footprint_rows.h"

namespace trixel::ui {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::FootprintRows", text);
}

} // namespace

QString footprintRowName(FootprintRow row)
{
    switch (row) {
    case FootprintRow::Place:
        return tr("Centre");
    case FootprintRow::Jacobian:
        return tr("Screen");
    case FootprintRow::First:
        return tr("W1");
    case FootprintRow::Second:
        return tr("W2");
    case FootprintRow::Axes:
        return tr("Half axes");
    case FootprintRow::Angle:
        return tr("Angle");
    case FootprintRow::Anisotropy:
        return tr("Anisotropy");
    case FootprintRow::Condition:
        return tr("Condition");
    case FootprintRow::Level:
        return tr("Level");
    case FootprintRow::Clamps:
        return tr("Clamps");
    case FootprintRow::Method:
        return tr("Method");
    case FootprintRow::MethodCost:
        return tr("  its cost");
    case FootprintRow::Exact:
        return tr("Exact");
    case FootprintRow::ExactCost:
        return tr("  its cost");
    case FootprintRow::Difference:
        return tr("Difference");
    case FootprintRow::Texels:
        return tr("Texels");
    case FootprintRow::Spread:
        return tr("Spread");
    }
    return {};
}

QString footprintRowTip(FootprintRow row)
{
    switch (row) {
    case FootprintRow::Place:
        return tr("Face and (u, v) of the footprint's centre");
    case FootprintRow::Jacobian:
        return tr("How the pixel's place (x, y) on the screen changes with (u, v): the Jacobian. "
                  "W1 and W2 are the columns of its inverse, found without dividing by its "
                  "determinant, which vanishes where the surface is seen edge-on");
    case FootprintRow::First:
        return tr("From this sample to the next along the first axis, in (u, v) of the face; for a "
                  "screen, one pixel to the right");
    case FootprintRow::Second:
        return tr("From this sample to the next along the second axis, in (u, v) of the face; for "
                  "a screen, one pixel down");
    case FootprintRow::Axes:
        return tr("Half axes of the ellipse, one standard deviation of the Gaussian that stands "
                  "for the parallelogram: Σ = ¼ (W1 W1ᵀ + W2 W2ᵀ). World units, and texels of this "
                  "place");
    case FootprintRow::Angle:
        return tr("Between the long axis and the face's first edge, in the plane of the face");
    case FootprintRow::Anisotropy:
        return tr("Long axis over short axis: 1 face-on, more the more grazing the view; and the "
                  "same of the ellipse that is filtered, which is never thinner than texels are");
    case FootprintRow::Condition:
        return tr("What a relative error of W1 and W2 may grow by in the short axis");
    case FootprintRow::Level:
        return tr("The level whose texels are as wide as the ellipse is across, the face's own "
                  "level, and the level that the method read");
    case FootprintRow::Clamps:
        return tr("What was brought into bounds before filtering, and what the method's own limits "
                  "did to the ellipse");
    case FootprintRow::Method:
        return tr("The value by the chosen method, every channel on the scale it is stored in");
    case FootprintRow::MethodCost:
        return tr("Texels or vertices that the chosen method read, and the quickest of a few goes");
    case FootprintRow::Exact:
        return tr("The exact value: the Gaussian over every texel of the base level, in double "
                  "precision");
    case FootprintRow::ExactCost:
        return tr("Texels that the exact answer read, and the quickest of a few goes");
    case FootprintRow::Difference:
        return tr("Largest difference of a channel between the two");
    case FootprintRow::Texels:
        return tr("Texels that count, found by asking the method itself: a texture that is 1 in "
                  "one "
                  "texel and 0 elsewhere gives that texel's weight. Up to %1 one by one")
            .arg(ContributionLimits().mostTexels);
    case FootprintRow::Spread:
        return tr(
            "Half axes of the ellipse that the weights make, and of the one that filters were "
            "asked for");
    }
    return {};
}

QString footprintRowSample(FootprintRow row)
{
    switch (row) {
    case FootprintRow::Place:
        return tr("face 9999999 at 0.0000, 0.0000");
    case FootprintRow::Jacobian:
        return tr("∂x/∂u -1234.5   ∂y/∂u -1234.5\n∂x/∂v -1234.5   ∂y/∂v -1234.5\ndet -1.2345e+05");
    case FootprintRow::First:
    case FootprintRow::Second:
        return tr("-0.01234, -0.01234  (12.3 texels)");
    case FootprintRow::Axes:
        return tr("0.00123 × 0.000123  (12.3 × 0.123 texels)");
    case FootprintRow::Clamps:
        return tr("widened for the texels: 0.123 → 0.577 texels\nthe method reads wider: 1 → 2");
    case FootprintRow::Level:
        return tr("asks for 10.00 of 10, reads 10.00");
    case FootprintRow::Difference:
        return tr("0.00123 = 0.123/255  (0.123 % of the range)");
    case FootprintRow::Texels:
        return tr("1234 with a weight, which sum to 1.00000; 12 % of it by texels taken together");
    case FootprintRow::Spread:
        return tr("12.3 × 12.3 texels, asked 12.3 × 12.3");
    default:
        return tr("255.00  255.00  255.00");
    }
}

} // namespace trixel::ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_rows.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/footprint/ellipse_report.h"
#include "core/footprint/svd2.h"
#include "ui/docks/readout_text.h"
#include "ui/viewport/method_title.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::ui {

namespace {

const QString kNothing = QStringLiteral("–");
const QString kToCome = QStringLiteral("…");

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::FootprintRows", text);
}

QString number(double value, int digits = 4)
{
    return std::isinf(value) ? QString(value > 0 ? "∞" : "-∞")
                             : QString::number(value, 'g', digits);
}

QString placeText(const ProbedFootprint& probed)
{
    const PlacedFootprint& placed = probed.placed;
    return tr("face %1 at %2, %3")
        .arg(static_cast<std::uint32_t>(placed.face))
        .arg(placed.uv.x, 0, 'f', 4)
        .arg(placed.uv.y, 0, 'f', 4);
}

/// Two rows, as the matrix is written.
QString jacobianText(const ProbedFootprint& probed)
{
    if (!probed.derivatives) {
        return probed.source == FootprintSource::Tilted
                   ? tr("view tilted by %1°").arg(probed.degrees, 0, 'f', 0)
                   : kNothing;
    }
    const ScreenDerivatives& f = *probed.derivatives;
    return tr("∂x/∂u %1   ∂y/∂u %2\n∂x/∂v %3   ∂y/∂v %4\ndet %5")
        .arg(number(f.perU.x),
             number(f.perU.y),
             number(f.perV.x),
             number(f.perV.y),
             number(differenceOfProducts(f.perU.x, f.perV.y, f.perU.y, f.perV.x)));
}

/// In (u,v), and its length in texels.
QString vectorRow(glm::dvec2 uv, glm::dvec2 plane, const FootprintNet& net)
{
    return tr("%1, %2  (%3 texels)")
        .arg(number(uv.x),
             number(uv.y),
             number(glm::length(plane) / std::exp2(net.ellipse.log2Texel), 3));
}

QString axesText(const FootprintNet& net)
{
    const double texel = std::exp2(net.ellipse.log2Texel);
    const double major = glm::length(net.major);
    const double minor = glm::length(net.minor);
    return tr("%1 × %2  (%3 × %4 texels)")
        .arg(
            number(major, 3), number(minor, 3), number(major / texel, 3), number(minor / texel, 3));
}

/// Major over minor, as `EllipseReport` has it.
double conditionOf(const FootprintNet& net)
{
    const double major = glm::length(net.major);
    const double minor = glm::length(net.minor);
    return minor > 0 ? major / minor : major > 0 ? INFINITY : 1;
}

QString angleText(const FootprintNet& net)
{
    double degrees = std::atan2(net.major.y, net.major.x) * 180 / std::numbers::pi;
    if (degrees <= -90) {
        degrees += 180;
    } else if (degrees > 90) {
        degrees -= 180;
    }
    return tr("%1° to the edge V0→V1").arg(degrees, 0, 'f', 1);
}

QString levelText(const FootprintFacts& facts)
{
    const double minor = glm::length(facts.net.minor);
    const double level = facts.net.ellipse.log2Edge - std::log2(2 * minor);
    QString text = tr("asks for %1 of %2")
                       .arg(std::isfinite(level) ? QString::number(level, 'f', 2) : number(level))
                       .arg(facts.net.faces.front().level.log2());
    if (facts.answer && facts.answer->own.isKnown() && !facts.answer->own.isRefused()) {
        text += tr(", reads %1").arg(facts.answer->own.level, 0, 'f', 2);
    }
    return text;
}

/// Of a method's answer, if it is of this footprint.
const MethodAnswer* answerOf(const FootprintFacts& facts, bool exact)
{
    if (!facts.answer) {
        return nullptr;
    }
    const MethodAnswer& answer = exact ? facts.answer->exact : facts.answer->own;
    return answer.isKnown() ? &answer : nullptr;
}

QString valueText(const FootprintFacts& facts, bool exact)
{
    const MethodAnswer* answer = answerOf(facts, exact);
    if (answer == nullptr) {
        return facts.noAnswer.isEmpty() ? kToCome : facts.noAnswer;
    }
    return answer->isRefused() ? tr("refused: too wide") : filteredText(facts.type, answer->values);
}

QString costText(const FootprintFacts& facts, bool exact)
{
    const MethodAnswer* answer = answerOf(facts, exact);
    if (answer == nullptr) {
        return facts.noAnswer.isEmpty() ? kToCome : kNothing;
    }
    return answer->isRefused()
               ? kNothing
               : tr("%1 taps in %2 µs").arg(answer->taps).arg(number(answer->microseconds, 3));
}

QString differenceText(const FootprintFacts& facts)
{
    const MethodAnswer* own = answerOf(facts, false);
    const MethodAnswer* exact = answerOf(facts, true);
    if (own == nullptr || exact == nullptr) {
        return facts.noAnswer.isEmpty() ? kToCome : kNothing;
    }
    if (own->isRefused() || exact->isRefused()) {
        return kNothing;
    }
    const double difference = facts.answer->difference;
    return tr("%1 = %2/255  (%3 % of the range)")
        .arg(number(difference, 3),
             number(255 * difference, 3),
             number(100 * facts.answer->differenceShare, 3));
}

QString texelsText(const FootprintFacts& facts)
{
    if (!facts.answer || !facts.answer->weights) {
        const QString why = facts.answer ? facts.answer->noWeights : facts.noAnswer;
        return why.isEmpty() ? kToCome : why;
    }
    const Contributions& weights = *facts.answer->weights;
    QString text = tr("%1 with a weight, which sum to %2")
                       .arg(weights.texels.size())
                       .arg(weights.sum, 0, 'f', 5);
    if (weights.joined > 1e-6) {
        text += tr("; %1 % of it by texels taken together").arg(number(100 * weights.joined, 2));
    }
    return text;
}

QString spreadText(const FootprintFacts& facts)
{
    if (!facts.answer || !facts.answer->weights) {
        return facts.answer && !facts.answer->noWeights.isEmpty() ? kNothing : kToCome;
    }
    const auto ellipse = weightEllipse(facts.net, *facts.answer->weights);
    if (!ellipse) {
        return kNothing;
    }
    const double texel = std::exp2(facts.net.ellipse.log2Texel);
    const QString text = tr("%1 × %2 texels, asked %3 × %4")
                             .arg(number(ellipse->majorSigma / texel, 3),
                                  number(ellipse->minorSigma / texel, 3),
                                  number(facts.net.ellipse.majorSigma / texel, 3),
                                  number(facts.net.ellipse.minorSigma / texel, 3));
    return ellipse->placed < 0.999
               ? text + tr("; %1 % not in the picture").arg(number(100 * (1 - ellipse->placed), 2))
               : text;
}

QString clampsText(const FootprintFacts& facts)
{
    std::optional<WeightEllipse> weights;
    if (facts.answer && facts.answer->weights && facts.answer->asked == facts.probed.placed) {
        weights = weightEllipse(facts.net, *facts.answer->weights);
    }
    const bool screen = facts.probed.source == FootprintSource::Screen ||
                        facts.probed.source == FootprintSource::Tilted;
    QStringList lines;
    for (const FootprintClamp& clamp : clampsOf(facts.probed.placed, facts.net, screen, weights)) {
        lines += clampText(clamp);
    }
    return lines.isEmpty() ? tr("none") : lines.join('\n');
}

} // namespace

QString footprintRowText(FootprintRow row, const FootprintFacts& facts)
{
    const FootprintNet& net = facts.net;
    switch (row) {
    case FootprintRow::Place:
        return placeText(facts.probed);
    case FootprintRow::Jacobian:
        return jacobianText(facts.probed);
    case FootprintRow::First:
        return vectorRow(facts.probed.placed.footprint.w1, net.w1, net);
    case FootprintRow::Second:
        return vectorRow(facts.probed.placed.footprint.w2, net.w2, net);
    case FootprintRow::Axes:
        return axesText(net);
    case FootprintRow::Angle:
        return angleText(net);
    case FootprintRow::Anisotropy:
        return tr("%1, filtered as %2")
            .arg(number(conditionOf(net)), number(net.ellipse.majorSigma / net.ellipse.minorSigma));
    case FootprintRow::Condition:
        return number(conditionOf(net));
    case FootprintRow::Level:
        return levelText(facts);
    case FootprintRow::Clamps:
        return clampsText(facts);
    case FootprintRow::Method:
        return valueText(facts, false);
    case FootprintRow::MethodCost:
        return costText(facts, false);
    case FootprintRow::Exact:
        return valueText(facts, true);
    case FootprintRow::ExactCost:
        return costText(facts, true);
    case FootprintRow::Difference:
        return differenceText(facts);
    case FootprintRow::Texels:
        return texelsText(facts);
    case FootprintRow::Spread:
        return spreadText(facts);
    }
    return {};
}

QString clampText(const FootprintClamp& clamp)
{
    using Kind = FootprintClamp::Kind;
    const QString asked = number(clamp.asked, 3);
    const QString used = number(clamp.used, 3);
    switch (clamp.kind) {
    case Kind::NotFinite:
        return tr("no number: taken as %1 edges all around").arg(used);
    case Kind::Shortened:
        return tr("shortened: %1 → %2 edges").arg(asked, used);
    case Kind::Grazing:
        return tr("seen edge-on: limited to %1 edges").arg(used);
    case Kind::CentreMoved:
        return tr("centre brought into the face");
    case Kind::Widened:
        return tr("widened for the texels: %1 → %2 texels").arg(asked, used);
    case Kind::FinestLevel:
        return tr("finer than the face: level %1 → %2").arg(asked, used);
    case Kind::CoarsestLevel:
        return tr("coarser than a face: level %1 → %2").arg(asked, used);
    case Kind::MethodWidened:
        return tr("the method reads wider: %1 → %2 texels").arg(asked, used);
    case Kind::MethodShortened:
        return tr("the method reads shorter: %1 → %2 texels").arg(asked, used);
    }
    return {};
}

} // namespace trixel::ui

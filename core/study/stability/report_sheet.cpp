// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sheet of small multiples. Colours are those of Okabe and Ito, which everybody can tell apart;
// the textbook's curve is dashed besides.
#include "core/study/stability/report_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace trixel {
namespace {

constexpr const char* kNaiveColour = "#C14B00";
constexpr const char* kOurColour = "#0067A5";
constexpr const char* kInk = "#1F2328";
constexpr const char* kFaint = "#6B7280";

constexpr std::size_t kColumns = 4;
constexpr double kMargin = 28;
constexpr double kPanelWidth = 312;
constexpr double kPanelHeight = 248;
constexpr double kHeader = 104;
constexpr double kPageWidth = 2 * kMargin + kColumns * kPanelWidth;

// Within a panel.
constexpr double kLeft = 44;
constexpr double kRight = kPanelWidth - 20;
constexpr double kTop = 66;       // of the strip for "no answer"
constexpr double kStrip = 16;     // its height
constexpr double kBottom = 204;   // of the plot
constexpr double kLeastLog = -18; // errors below stand on the axis, 0 among them
constexpr double kMostLog = 4;

std::string format(const char* pattern, double a, double b = 0, double c = 0, double d = 0)
{
    char text[256];
    // NOLINTNEXTLINE: patterns are those of this file
    std::snprintf(text, sizeof text, pattern, a, b, c, d);
    return text;
}

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

/// "1e-6" rather than "1e-06".
std::string shortNumber(double value)
{
    std::string text = format("%.2g", value);
    const std::size_t zero = text.find("e-0");
    return zero == std::string::npos ? text : text.erase(zero + 2, 1);
}

struct TextStyle
{
    double size = 10;
    const char* colour = kInk;
    const char* anchor = "start";
    bool bold = false;
};

std::string textAt(double x, double y, const TextStyle& style, std::string_view text)
{
    return format("<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.1f\"", x, y, style.size) + " fill=\"" +
           style.colour + "\" text-anchor=\"" + style.anchor + "\"" +
           (style.bold ? " font-weight=\"600\"" : "") + ">" + escaped(text) + "</text>\n";
}

std::string lineBetween(double x1, double y1, double x2, double y2, const std::string& style)
{
    return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" ", x1, y1, x2, y2) +
           style + "/>\n";
}

double heightOf(double error)
{
    if (!std::isfinite(error)) {
        return kTop + kStrip / 2;
    }
    const double log = error > 0 ? std::log10(error) : kLeastLog;
    const double part = (std::clamp(log, kLeastLog, kMostLog) - kLeastLog) / (kMostLog - kLeastLog);
    return kBottom - part * (kBottom - kTop - kStrip);
}

/// Values of a sweep lie at even distances: that is what their axis means, logarithmic or not.
double placeOf(std::size_t index, std::size_t count)
{
    const double part =
        count > 1 ? static_cast<double>(index) / static_cast<double>(count - 1) : 0.5;
    return kLeft + 6 + part * (kRight - kLeft - 12);
}

/// About what a label needs.
double widthOf(std::string_view text)
{
    return 5.2 * static_cast<double>(text.size()) + 8;
}

/// First and last label, and as many in between as have room.
std::string axisLabels(const StabilitySweep& sweep)
{
    std::string out;
    const std::size_t count = sweep.values.size();
    const auto half = [&](std::size_t k) { return widthOf(sweep.values[k].label) / 2; };
    const double end = placeOf(count - 1, count) - half(count - 1);
    double free = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = placeOf(k, count);
        const bool last = k + 1 == count;
        out += lineBetween(x, kBottom, x, kBottom + 3, "stroke=\"#9AA1AB\" stroke-width=\"0.8\"");
        if (last || (x - half(k) >= free && x + half(k) <= end)) {
            out += textAt(x, kBottom + 13, {9, kFaint, "middle"}, sweep.values[k].label);
            free = x + half(k);
        }
    }
    return out;
}

std::string frame(const StabilitySweep& sweep)
{
    const double width = kRight - kLeft;
    std::string out =
        format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#FBFBFC\"/>\n",
               kLeft,
               kTop,
               width,
               kBottom - kTop);
    const double bound = heightOf(sweep.bound);
    out += format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" ",
                  kLeft,
                  kTop,
                  width,
                  bound - kTop) +
           "fill=\"" + kNaiveColour + "\" fill-opacity=\"0.07\"/>\n";
    out += format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" ",
                  kLeft,
                  kTop,
                  width,
                  kStrip) +
           "fill=\"" + kNaiveColour + "\" fill-opacity=\"0.10\"/>\n";
    for (const int decade : {-16, -12, -8, -4, 0}) {
        const double y = heightOf(std::pow(10.0, decade));
        out += lineBetween(kLeft, y, kRight, y, "stroke=\"#E3E5E8\" stroke-width=\"0.8\"");
        out += textAt(kLeft - 5,
                      y + 3,
                      {9, kFaint, "end"},
                      decade == 0 ? std::string("1") : "1e" + std::to_string(decade));
    }
    out += textAt(kLeft - 5, kTop + 11, {9, kNaiveColour, "end"}, "none");
    out += lineBetween(kLeft,
                       bound,
                       kRight,
                       bound,
                       "stroke=\"#3F4650\" stroke-width=\"1.1\" stroke-dasharray=\"1.5 2.5\"");
    return out;
}

/// A line through the errors; where there is no answer it climbs to the strip above the plot.
std::string curve(const StabilityCurve& c, double opacity)
{
    const char* colour = c.naive ? kNaiveColour : kOurColour;
    const std::size_t count = c.errors.size();
    std::string points;
    std::string marks;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = placeOf(k, count);
        const double y = heightOf(c.errors[k]);
        points += format("%.1f,%.1f ", x, y);
        if (c.naive && !std::isfinite(c.errors[k])) {
            marks += format("<path d=\"M%.1f %.1fl5 5m0 -5l-5 5\" ", x - 2.5, y - 2.5) +
                     "stroke=\"" + colour + "\" stroke-width=\"1.3\" fill=\"none\"/>\n";
        } else {
            marks +=
                format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" ", x, y, c.naive ? 1.9 : 1.7) +
                "fill=\"" + (c.naive ? "#FFFFFF" : colour) + "\" stroke=\"" + colour +
                "\" stroke-width=\"1\"/>\n";
        }
    }
    return format("<g opacity=\"%.2f\">\n", opacity) + "<polyline points=\"" + points +
           "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.6\"" +
           (c.naive ? " stroke-dasharray=\"5 2.5\"" : "") + " stroke-linejoin=\"round\"/>\n" +
           marks + "</g>\n";
}

std::string formsOf(const StabilitySweep& sweep, bool naive)
{
    std::size_t count = 0;
    std::string first;
    for (const StabilityCurve& c : sweep.curves) {
        if (c.naive == naive) {
            first = count == 0 ? c.form : first;
            ++count;
        }
    }
    return count <= 2 ? first : "filters of the table (" + std::to_string(count) + ")";
}

std::string panel(const StabilitySweep& sweep)
{
    std::string out = "<title>" + escaped(sweep.hazard + " " + sweep.property) + "</title>\n";
    out += textAt(0, 14, {12.5, kInk, "start", true}, sweep.title);
    out += textAt(0, 30, {10, kNaiveColour}, "textbook: " + formsOf(sweep, true));
    out += textAt(0, 44, {10, kOurColour}, "ours: " + formsOf(sweep, false));
    out += textAt(0, 58, {9, kFaint}, sweep.errorTitle);
    const bool holds = sweep.holds();
    out += textAt(kRight,
                  58,
                  {9, holds ? kOurColour : kNaiveColour, "end", true},
                  (holds ? "holds, bound " : "BROKEN, bound ") + shortNumber(sweep.bound));
    out += frame(sweep) + axisLabels(sweep);
    const auto ours = std::ranges::count(sweep.curves, false, &StabilityCurve::naive);
    for (const StabilityCurve& c : sweep.curves) {
        out += curve(c, c.naive || ours <= 2 ? 1.0 : 0.45);
    }
    out += textAt((kLeft + kRight) / 2, kBottom + 27, {10, kInk, "middle"}, sweep.axisTitle);
    return out;
}

std::string header(const StabilityReport& report)
{
    std::string out = textAt(kMargin,
                             40,
                             {21, kInk, "start", true},
                             "Where the textbook\u2019s formulas leave the chart");
    std::size_t kept = 0;
    for (const StabilitySweep& sweep : report.sweeps) {
        kept += sweep.holds() ? 1 : 0;
    }
    out += textAt(kMargin,
                  62,
                  {12, kFaint},
                  std::to_string(kept) + " of " + std::to_string(report.sweeps.size()) +
                      " hazards kept within their bounds. " + report.conditions);
    const double y = 84;
    double x = kMargin;
    const auto key = [&](const StabilityCurve& sample, double width, std::string_view text) {
        const char* colour = sample.naive ? kNaiveColour : kOurColour;
        out += lineBetween(x,
                           y - 4,
                           x + 26,
                           y - 4,
                           std::string("stroke=\"") + colour + "\" stroke-width=\"2\"" +
                               (sample.naive ? " stroke-dasharray=\"5 2.5\"" : ""));
        out += textAt(x + 32, y, {11, colour}, text);
        x += width;
    };
    key({"", true, {}}, 200, "textbook (\u00D7 no answer)");
    key({"", false, {}}, 90, "ours");
    out += lineBetween(x,
                       y - 4,
                       x + 26,
                       y - 4,
                       "stroke=\"#3F4650\" stroke-width=\"1.4\" stroke-dasharray=\"1.5 2.5\"");
    out += textAt(x + 32, y, {11, kInk}, "bound; beyond it the ground is tinted");
    out += textAt(kPageWidth - kMargin,
                  y,
                  {11, kFaint, "end"},
                  "error (logarithmic) against what is swept, in the order of the sweep");
    return out;
}

std::string findingLines(const StabilityReport& report, double top)
{
    std::string out =
        textAt(kMargin, top, {14, kInk, "start", true}, "On the faces of " + report.subject);
    double y = top + 20;
    for (const AssetFinding& finding : report.findings) {
        std::string line = finding.title + ": " + std::to_string(finding.count);
        if (finding.count > 0) {
            line += format(", worst %.4g", finding.worst);
            line += finding.face ? " at face " + std::to_string(indexOf(*finding.face)) : "";
        }
        if (finding.error) {
            line += format("; error %.2g, bound %.2g", *finding.error, finding.bound);
            line += finding.holds() ? " (holds)" : " (BROKEN)";
        }
        out += textAt(kMargin, y, {11, finding.holds() ? kInk : kNaiveColour}, line);
        y += 17;
    }
    return out;
}

} // namespace

std::string toSvg(const StabilityReport& report)
{
    const std::size_t rows = (report.sweeps.size() + kColumns - 1) / kColumns;
    const double panels = kHeader + static_cast<double>(rows) * kPanelHeight;
    const double findings =
        report.findings.empty() ? 0 : 44 + 17 * static_cast<double>(report.findings.size());
    const double height = panels + findings + 12;
    std::string out = format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" "
                             "height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" ",
                             kPageWidth,
                             height,
                             kPageWidth,
                             height) +
                      "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n" +
                      header(report);
    for (std::size_t k = 0; k < report.sweeps.size(); ++k) {
        const double x = kMargin + static_cast<double>(k % kColumns) * kPanelWidth;
        const double y = kHeader + static_cast<double>(k / kColumns) * kPanelHeight;
        out += format("<g transform=\"translate(%.0f %.0f)\">\n", x, y) + panel(report.sweeps[k]) +
               "</g>\n";
    }
    if (!report.findings.empty()) {
        out += findingLines(report, panels + 26);
    }
    return out + "</svg>\n";
}

} // namespace trixel

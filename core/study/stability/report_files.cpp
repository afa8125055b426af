// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/report_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

namespace trixel {
namespace {

std::string quoted(const std::string& field)
{
    if (field.find_first_of(",\"\n") == std::string::npos) {
        return field;
    }
    std::string text = "\"";
    for (const char c : field) {
        text += c;
        if (c == '"') {
            text += c;
        }
    }
    return text + '"';
}

std::string number(double value)
{
    if (std::isnan(value)) {
        return "nan";
    }
    if (std::isinf(value)) {
        return value > 0 ? "inf" : "-inf";
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

nlohmann::json finiteOrNull(double value)
{
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

std::string_view nameOf(SweepAxis axis)
{
    switch (axis) {
    case SweepAxis::Logarithmic:
        return "logarithmic";
    case SweepAxis::Linear:
        return "linear";
    case SweepAxis::Listed:
        break;
    }
    return "listed";
}

nlohmann::json jsonOf(const StabilitySweep& sweep)
{
    nlohmann::json values = nlohmann::json::array();
    for (const SweepValue& value : sweep.values) {
        values.push_back({{"at", finiteOrNull(value.at)}, {"label", value.label}});
    }
    nlohmann::json curves = nlohmann::json::array();
    for (const StabilityCurve& curve : sweep.curves) {
        nlohmann::json errors = nlohmann::json::array();
        for (const double error : curve.errors) {
            errors.push_back(finiteOrNull(error));
        }
        curves.push_back(
            {{"form", curve.form}, {"naive", curve.naive}, {"errors", std::move(errors)}});
    }
    return {{"name", sweep.name},
            {"title", sweep.title},
            {"hazard", sweep.hazard},
            {"property", sweep.property},
            {"axisTitle", sweep.axisTitle},
            {"axis", nameOf(sweep.axis)},
            {"errorTitle", sweep.errorTitle},
            {"bound", sweep.bound},
            {"holds", sweep.holds()},
            {"naiveFailures", sweep.naiveFailures()},
            {"values", std::move(values)},
            {"curves", std::move(curves)}};
}

nlohmann::json jsonOf(const AssetFinding& finding)
{
    nlohmann::json object{{"name", finding.name},
                          {"title", finding.title},
                          {"count", finding.count},
                          {"worst", finiteOrNull(finding.worst)},
                          {"holds", finding.holds()}};
    if (finding.face) {
        object["face"] = indexOf(*finding.face);
    }
    if (finding.error) {
        object["error"] = finiteOrNull(*finding.error);
        object["bound"] = finding.bound;
    }
    return object;
}

/// "9.1e-16", "none" for nothing usable.
std::string shortError(double error)
{
    if (!std::isfinite(error)) {
        return "no answer";
    }
    char text[32];
    std::snprintf(text, sizeof text, error == 0 ? "0" : "%.1e", error);
    return text;
}

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string lineOf(const StabilitySweep& sweep)
{
    std::string line = padded(sweep.name, 18) + padded(sweep.holds() ? "holds" : "BROKEN", 8) +
                       "bound " + padded(shortError(sweep.bound), 9) + "ours " +
                       padded(shortError(sweep.worst(false)), 11) + "textbook " +
                       padded(shortError(sweep.worst(true)), 11);
    if (const auto first = firstNaiveFailure(sweep)) {
        line += "beyond it at " + std::to_string(sweep.naiveFailures()) + " of " +
                std::to_string(sweep.values.size()) + " values, first " + first->label;
    }
    while (line.back() == ' ') {
        line.pop_back();
    }
    return line + '\n';
}

std::string lineOf(const AssetFinding& finding)
{
    std::string line = padded(finding.name, 18) + padded(finding.holds() ? "holds" : "BROKEN", 8) +
                       finding.title + ": " + std::to_string(finding.count);
    if (finding.count > 0) {
        line += ", worst " + number(finding.worst);
        if (finding.face) {
            line += " at face " + std::to_string(indexOf(*finding.face));
        }
    }
    if (finding.error) {
        line += "; error " + shortError(*finding.error) + ", bound " + shortError(finding.bound);
    }
    return line + '\n';
}

} // namespace

std::optional<SweepValue> firstNaiveFailure(const StabilitySweep& sweep)
{
    for (std::size_t k = 0; k < sweep.values.size(); ++k) {
        if (std::ranges::any_of(sweep.curves, [&](const StabilityCurve& curve) {
                return curve.naive && !(curve.errors[k] <= sweep.bound);
            })) {
            return sweep.values[k];
        }
    }
    return std::nullopt;
}

std::string toCsv(const StabilityReport& report)
{
    std::ostringstream text;
    text << "sweep,axis,value,label,form,kind,error,bound,within\n";
    for (const StabilitySweep& sweep : report.sweeps) {
        for (const StabilityCurve& curve : sweep.curves) {
            for (std::size_t k = 0; k < sweep.values.size(); ++k) {
                text << sweep.name << ',' << quoted(sweep.axisTitle) << ','
                     << number(sweep.values[k].at) << ',' << quoted(sweep.values[k].label) << ','
                     << quoted(curve.form) << ',' << (curve.naive ? "naive" : "robust") << ','
                     << number(curve.errors[k]) << ',' << number(sweep.bound) << ','
                     << (curve.errors[k] <= sweep.bound ? 1 : 0) << '\n';
            }
        }
    }
    for (const AssetFinding& finding : report.findings) {
        text << "asset," << quoted(finding.title) << ',' << number(finding.worst) << ','
             << finding.count << ',' << finding.name << ",robust,"
             << (finding.error ? number(*finding.error) : "") << ','
             << (finding.error ? number(finding.bound) : "") << ',' << (finding.holds() ? 1 : 0)
             << '\n';
    }
    return text.str();
}

std::string toJson(const StabilityReport& report)
{
    nlohmann::json sweeps = nlohmann::json::array();
    for (const StabilitySweep& sweep : report.sweeps) {
        sweeps.push_back(jsonOf(sweep));
    }
    nlohmann::json findings = nlohmann::json::array();
    for (const AssetFinding& finding : report.findings) {
        findings.push_back(jsonOf(finding));
    }
    return nlohmann::json{{"study", "stability"},
                          {"subject", report.subject},
                          {"conditions", report.conditions},
                          {"holds", report.holds()},
                          {"sweeps", std::move(sweeps)},
                          {"findings", std::move(findings)}}
               .dump(2) +
           '\n';
}

std::string toText(const StabilityReport& report)
{
    std::string text;
    for (const StabilitySweep& sweep : report.sweeps) {
        text += lineOf(sweep);
    }
    if (!report.findings.empty()) {
        text += "On the faces of " + report.subject + ":\n";
    }
    for (const AssetFinding& finding : report.findings) {
        text += lineOf(finding);
    }
    return text;
}

} // namespace trixel

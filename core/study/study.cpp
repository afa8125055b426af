// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace trixel {
namespace {

std::string className(const StudyPoint& point)
{
    return point.footprintClass ? std::string(nameOf(*point.footprintClass)) : "all";
}

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

/// Whether a makes b superfluous.
bool beats(const StudyPoint& a, const StudyPoint& b)
{
    return a.cost <= b.cost && a.rms <= b.rms && (a.cost < b.cost || a.rms < b.rms);
}

} // namespace

void markFront(std::vector<StudyPoint>& points)
{
    for (StudyPoint& point : points) {
        point.onFront = std::ranges::none_of(points, [&](const StudyPoint& other) {
            return other.footprintClass == point.footprintClass && beats(other, point);
        });
    }
}

std::string toCsv(const Study& study)
{
    std::ostringstream text;
    text.precision(9);
    text << "series,variant,method,class,cost_" << study.costUnit
         << ",rms,p99,worst,samples,refused,front\n";
    for (const StudyPoint& point : study.points) {
        text << quoted(point.series) << ',' << quoted(point.variant) << ','
             << (point.method ? toText(*point.method) : "") << ',' << className(point) << ','
             << point.cost << ',' << point.rms << ',' << point.p99 << ',' << point.worst << ','
             << point.samples << ',' << point.refused << ',' << (point.onFront ? 1 : 0) << '\n';
    }
    return text.str();
}

std::string toJson(const Study& study)
{
    nlohmann::json points = nlohmann::json::array();
    for (const StudyPoint& point : study.points) {
        nlohmann::json row = {{"series", point.series},
                              {"variant", point.variant},
                              {"class", className(point)},
                              {"cost", point.cost},
                              {"rms", point.rms},
                              {"p99", point.p99},
                              {"worst", point.worst},
                              {"samples", point.samples},
                              {"refused", point.refused},
                              {"partly", point.partly},
                              {"front", point.onFront}};
        if (point.method) {
            row["method"] = toText(*point.method);
        }
        points.push_back(std::move(row));
    }
    return nlohmann::json{{"study", study.name},
                          {"title", study.title},
                          {"costTitle", study.costTitle},
                          {"costUnit", study.costUnit},
                          {"subject", study.subject},
                          {"conditions", study.conditions},
                          {"notes", study.notes},
                          {"points", std::move(points)}}
        .dump(2);
}

} // namespace trixel

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study that nobody measured, as large and as crowded as real ones.
#pragma once

#include "core/study/study.h"

#include <cmath>
#include <string>
#include <vector>

namespace trixel::ui {

/// A point of a method; `parameter` 0 stands for none.
inline StudyPoint madeUpPoint(const std::string& method,
                              double parameter,
                              double cost,
                              double rms,
                              std::optional<FootprintClass> footprintClass = std::nullopt)
{
    StudyPoint point;
    point.series = method;
    point.method = MethodChoice{method, std::nullopt};
    if (parameter > 0) {
        point.method->parameter = parameter;
        point.variant = "probes " + std::to_string(static_cast<int>(parameter));
    }
    point.footprintClass = footprintClass;
    point.cost = cost;
    point.rms = rms;
    point.p99 = 4.6 * rms;
    point.worst = 21 * rms;
    point.samples = 3000;
    return point;
}

inline StudyPoint madeUpPeer(const std::string& name, double cost, double rms)
{
    StudyPoint peer = madeUpPoint(name, 0, cost, rms);
    peer.method.reset();
    return peer;
}

/// Twelve methods and two peers, in all classes together and, costlier, in three of them.
inline Study madeUpStudy()
{
    Study study;
    study.name = "speed-accuracy";
    study.title = "Cost of a filtered sample against its error";
    study.costTitle = "Time per sample";
    study.costUnit = "ns";
    study.subject = "made-up texture, 3,000 footprints";
    study.conditions = "one thread, seed 7, float RGB, footprints of 1/4 to 64 texels, anisotropy "
                       "1 to 64; a machine that does not exist";
    const std::optional<FootprintClass> classes[] = {std::nullopt,
                                                     FootprintClass::SmallRound,
                                                     FootprintClass::MediumElongated,
                                                     FootprintClass::LargeGrazing};
    double slower = 1;
    for (const auto& c : classes) {
        const auto add = [&](const char* method, double parameter, double cost, double rms) {
            study.points.push_back(madeUpPoint(method, parameter, cost * slower, rms * slower, c));
        };
        add("point", 0, 5, 0.27);
        add("nearest-level", 0, 38, 0.096);
        add("rectilinear-bilinear", 0, 30, 0.11);
        add("trilinear", 0, 88, 0.055);
        add("separable", 0, 460, 0.041);
        for (const double n : {2, 4, 8, 16, 32}) {
            add("equal-probes", n, 40 + 30 * n, 0.05 / (1 + n / 20));
        }
        for (const double n : {1, 2, 4, 8, 16, 32}) {
            add("probes-1", n, 30 + 3.2 * n, 0.0115 + 0.05 / (n * n));
        }
        for (const double n : {1, 2, 4, 8, 16, 32, 64, 128}) {
            add("probes-2", n, 55 + 5 * n, 0.0038 + 0.058 / n);
        }
        for (const double n : {4, 16, 64, 256}) {
            add("stochastic", n, 80 * n, 0.29 / std::sqrt(n));
        }
        for (const double n : {4, 16, 64}) {
            add("ewa", n, 300 + 18 * n, 0.0022 + 0.05 / n);
        }
        add("ewa-blended", 0, 2700, 0.0012);
        add("ewa-base", 0, 120'000, 0.00027);
        add("exact", 0, 900'000, 0);
        slower *= 1.3;
    }
    study.points.push_back(madeUpPeer("OpenImageIO", 610, 0.021));
    study.points.push_back(madeUpPeer("reference loop", 5438, 0.0058));
    return study;
}

} // namespace trixel::ui

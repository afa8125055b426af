// SPDX-License-Identifier: GPL-3.0-or-later
//
// tests/data/filter: 600 footprints on 128 equilateral faces of mixed levels, with the exact answer
// and what the reference library gave.
#pragma once

#include "core/io/ptx.h"
#include "tests/core/filter/filter_scenes.h"

#include <fstream>
#include <sstream>
#include <string>

namespace trixel::test {

struct GoldenQueries
{
    std::vector<Query> queries;
    std::vector<std::array<double, 3>> exact;
    std::vector<std::array<double, 3>> library;
};

inline GoldenQueries goldenQueries()
{
    std::ifstream file(std::string(TRIXEL_TEST_DATA) + "/filter/filter_a.csv");
    GoldenQueries golden;
    std::string line;
    std::getline(file, line); // names of the columns
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::string cell;
        std::vector<double> n;
        while (std::getline(cells, cell, ',')) {
            n.push_back(std::stod(cell));
        }
        const auto f = [&n](std::size_t column) { return static_cast<float>(n.at(column)); };
        golden.queries.push_back(
            {faceId(static_cast<std::size_t>(n.at(0))), {f(1), f(2)}, {f(3), f(4)}, {f(5), f(6)}});
        golden.exact.push_back({n.at(7), n.at(8), n.at(9)});
        golden.library.push_back({n.at(10), n.at(11), n.at(12)});
    }
    return golden;
}

inline FilterScene goldenScene()
{
    NoProgress progress;
    const auto contents = readPtx(std::string(TRIXEL_TEST_DATA) + "/filter/filter_a.ptx", progress);
    return sceneOf(FilterSurface::equilateral(contents->adjacency), contents->texels);
}

} // namespace trixel::test

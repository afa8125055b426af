// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/covariance.h"
#include "core/footprint/limit.h"
#include "core/footprint/svd2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

using namespace trixel;

TEST(Covariance, axesAreTheSingularValuesOfTheHalfAxes)
{
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int k = 0; k < 2000; ++k) {
        const double scale = std::pow(10, 8 * in(engine));
        const glm::dvec2 a(scale * in(engine), scale * in(engine));
        const glm::dvec2 b(scale * in(engine), scale * in(engine));
        const CovarianceAxes axes = axesOf(covarianceOf(a, b, 0));
        const Svd2 svd = svd2(a, b);
        EXPECT_NEAR(axes.majorSigma / svd.major, 1, 1e-12);
        EXPECT_NEAR(axes.minorSigma / svd.minor, 1, 1e-12);
        EXPECT_NEAR(glm::length(axes.majorAxis), 1, 1e-12);
        EXPECT_NEAR(std::abs(glm::dot(axes.majorAxis, svd.majorTo)), 1, 1e-12);
    }
}

TEST(Covariance, theFloorKeepsItPositiveForNothingAndForALine)
{
    const CovarianceAxes nothing = axesOf(covarianceOf({0, 0}, {0, 0}, 0.25));
    EXPECT_DOUBLE_EQ(nothing.majorSigma, 0.5);
    EXPECT_DOUBLE_EQ(nothing.minorSigma, 0.5);
    EXPECT_EQ(nothing.majorAxis, glm::dvec2(1, 0));
    const CovarianceAxes line = axesOf(covarianceOf({3e5, 4e5}, {3e5, 4e5}, 0.25));
    EXPECT_NEAR(line.minorSigma, 0.5, 1e-12);
    EXPECT_NEAR(line.majorAxis.x, 0.6, 1e-12);
    EXPECT_NEAR(line.majorAxis.y, 0.8, 1e-12);
}

TEST(LimitedVector, isNoLongerThanAskedWhateverItsSize)
{
    EXPECT_EQ(limitedVector({3, 4}, 6), glm::dvec2(3, 4));
    EXPECT_NEAR(glm::length(limitedVector({3, 4}, 1)), 1, 1e-15);
    for (const double size : {1e-320, 1.0, 1e30, 1e200, std::numeric_limits<double>::max()}) {
        const glm::dvec2 v = limitedVector({size, -size}, 2);
        EXPECT_LE(glm::length(v), 2 * (1 + 1e-15)) << size;
        EXPECT_EQ(v.x, -v.y);
        EXPECT_GT(v.x, 0);
    }
}

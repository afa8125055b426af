// SPDX-License-Identifier: GPL-3.0-or-later
//
// What EWA reads for a query: how far the ellipse is limited and which levels.
#pragma once

#include "core/filter/gaussian_window.h"
#include "core/filter/query_ellipse.h"
#include "core/filter/unfolding.h"

#include <cstdint>

namespace trixel {

/// How an EWA filter trades.
struct EwaSettings
{
    double sigma = 0.5;            ///< least standard deviation in texels of the level read
    double cut = 3.0;              ///< of the window, in standard deviations
    double mostAnisotropy = 64.0;  ///< beyond it the minor axis is widened
    std::uint32_t mostTaps = 4096; ///< of all levels together
    bool atBase = false;           ///< the base level of every face, and every anisotropy
    bool blended = false;          ///< two levels instead of one
};

/// Ellipse and levels of one query. Everything follows from lengths that are continuous over the
/// mesh, so that it is the same from both sides of an edge.
struct EwaPlan
{
    glm::dvec2 majorAxis{1, 0};
    double majorSigma = 0;
    double minorSigma = 0;
    int coarse = 0;   ///< levels read: this one
    int fine = 0;     ///< and this one, the same or the next
    double blend = 1; ///< share of the fine one

    EllipseFrame frame() const { return {majorAxis, majorSigma, minorSigma}; }
    /// One level coarser; at level 0 a smaller ellipse: for where the mesh holds more texels under
    /// the ellipse than its lengths let expect.
    void reduce();
};

EwaPlan
planEwa(const EwaSettings& settings, const GaussianWindow& window, const QueryEllipse& ellipse);

} // namespace trixel

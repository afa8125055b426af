// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Gaussian that ends: what EWA weighs texels with.
#pragma once

#include <algorithm>
#include <cmath>

namespace trixel {

/// exp(-q/2) - p (q/c²)⁴ for q <= c², p = exp(-c²/2): zero at the cut, so that no texel comes or
/// goes with a jump, and the Gaussian itself where it matters.
class GaussianWindow
{
public:
    /// \param cut  c, standard deviations, in [1, 4]
    explicit GaussianWindow(double cut)
        : m_cut(cut)
        , m_pedestal(std::exp(-cut * cut / 2))
    {
    }

    double cut() const { return m_cut; }
    double pedestal() const { return m_pedestal; } ///< p

    /// Its variance along each axis, below 1 for what was cut off: a Gaussian of covariance Σ is
    /// matched by a window of covariance Σ / variance().
    double variance() const
    {
        const double c2 = m_cut * m_cut;
        const double mass = 1 - m_pedestal - m_pedestal * c2 / 10;
        const double second = 2 - m_pedestal * (c2 + 2) - m_pedestal * c2 * c2 / 12;
        return second / (2 * mass);
    }

    /// At squared distance q.
    float weight(float q) const
    {
        const float r = q * static_cast<float>(1 / (m_cut * m_cut));
        const float rim = static_cast<float>(m_pedestal) * ((r * r) * (r * r));
        return std::max(negativeExponential(0.5F * q) - rim, 0.0F);
    }

    /// exp(-x), x >= 0, with an error below 2e-6, without a branch: the eighth power of the Taylor
    /// polynomial of exp(-x/8). Where that runs out of digits, exp has nothing left to say.
    static float negativeExponential(float x)
    {
        const float y = x * 0.125F;
        float e = 1.0F / 720.0F;
        e = 1.0F / 120.0F - y * e;
        e = 1.0F / 24.0F - y * e;
        e = 1.0F / 6.0F - y * e;
        e = 0.5F - y * e;
        e = 1.0F - y * e;
        e = 1.0F - y * e;
        e *= e;
        e *= e;
        return e * e;
    }

private:
    double m_cut;
    double m_pedestal;
};

} // namespace trixel

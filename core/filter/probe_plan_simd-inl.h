// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries → plans, several at a time. Included once per instruction set (see Highway).
#include "core/filter/level_blend.h"
#include "core/filter/probe_plan.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_PLAN_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_PLAN_SIMD
#undef TRIXEL_PROBE_PLAN_SIMD
#else
#define TRIXEL_PROBE_PLAN_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What plans are made from, gathered from queries and their faces.
struct PlanInputs
{
    static constexpr std::size_t kSize = ProbePlans::kSize;

    alignas(64) double u[kSize], v[kSize], w1u[kSize], w1v[kSize], w2u[kSize], w2v[kSize];
    alignas(64) double e1x[kSize], e2x[kSize], e2y[kSize]; ///< of the face's shape
    alignas(64) double texel[3][kSize], edge[3][kSize];    ///< log2 sizes at its corners
};

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

/// 2^x.
HWY_INLINE V exp2Of(D d, V x)
{
    return hn::Exp(d, hn::Mul(x, hn::Set(d, 0.69314718055994531)));
}

/// Factor that brings a vector down to the widest footprint.
HWY_INLINE V limitOf(D d, V u, V v)
{
    const V squared = hn::MulAdd(u, u, hn::Mul(v, v));
    const V widest = hn::Set(d, kWidestFootprint);
    const auto isLong = hn::Gt(squared, hn::Mul(widest, widest));
    if (hn::AllFalse(d, isLong)) {
        return hn::Set(d, 1.0); // no roots for nothing
    }
    return hn::IfThenElse(isLong, hn::Div(widest, hn::Sqrt(squared)), hn::Set(d, 1.0));
}

/// Where a query is, and how large what it lies on is.
struct Place
{
    V u, v;          ///< centre, brought inside the face
    V edge2, texel2; ///< squared edges of the face and of a texel of its base
};

HWY_INLINE Place placeOf(D d, const PlanInputs& in, std::size_t at)
{
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0);
    V u = hn::Load(d, in.u + at);
    V v = hn::Load(d, in.v + at);
    const auto hasCentre = hn::And(hn::IsFinite(u), hn::IsFinite(v));
    u = hn::Max(hn::IfThenElse(hasCentre, u, hn::Set(d, 1.0 / 3.0)), zero);
    v = hn::Max(hn::IfThenElse(hasCentre, v, hn::Set(d, 1.0 / 3.0)), zero);
    const V outside = hn::Max(hn::Add(u, v), one);
    if (!hn::AllTrue(d, hn::Eq(outside, one))) {
        u = hn::Div(u, outside);
        v = hn::Div(v, outside);
    }
    const V w = hn::Sub(hn::Sub(one, u), v);
    const auto interpolated = [&](const double(&corners)[3][PlanInputs::kSize]) HWY_ATTR {
        return hn::MulAdd(
            w,
            hn::Load(d, corners[0] + at),
            hn::MulAdd(u, hn::Load(d, corners[1] + at), hn::Mul(v, hn::Load(d, corners[2] + at))));
    };
    const V log2Edge = interpolated(in.edge);
    const V edge2 = exp2Of(d, hn::Add(log2Edge, log2Edge));
    const V log2Texel = interpolated(in.texel);
    const V texel2 = exp2Of(d, hn::Add(log2Texel, log2Texel));
    return {u, v, edge2, texel2};
}

/// The ellipse of a footprint, with its floor.
struct Axes
{
    V major, minor; ///< variances
    V x, y;         ///< direction of the major axis in the plane, of length 1
};

/// Everything as in `queryEllipse`.
HWY_INLINE Axes axesOf(D d, const PlanInputs& in, std::size_t at, const Place& place)
{
    const V zero = hn::Zero(d);
    const V half = hn::Set(d, 0.5);
    const V one = hn::Set(d, 1.0);

    // Half axes a, b in the plane. The determinant is taken in (u,v), where products of floats are
    // exact.
    const V e1x = hn::Load(d, in.e1x + at);
    const V e2x = hn::Load(d, in.e2x + at);
    const V e2y = hn::Load(d, in.e2y + at);
    V w1u = hn::Load(d, in.w1u + at);
    V w1v = hn::Load(d, in.w1v + at);
    V w2u = hn::Load(d, in.w2u + at);
    V w2v = hn::Load(d, in.w2v + at);
    const auto finite = hn::And(hn::And(hn::IsFinite(w1u), hn::IsFinite(w1v)),
                                hn::And(hn::IsFinite(w2u), hn::IsFinite(w2v)));
    const V limit1 = limitOf(d, w1u, w1v);
    const V limit2 = limitOf(d, w2u, w2v);
    w1u = hn::Mul(w1u, limit1);
    w1v = hn::Mul(w1v, limit1);
    w2u = hn::Mul(w2u, limit2);
    w2v = hn::Mul(w2v, limit2);
    const V widest = hn::Mul(hn::Set(d, kWidestFootprint / 2), hn::Sqrt(place.edge2));
    const auto orWidest = [&](V x, V otherwise)
                              HWY_ATTR { return hn::IfThenElse(finite, x, otherwise); };
    const V ax = orWidest(hn::Mul(half, hn::MulAdd(w1u, e1x, hn::Mul(w1v, e2x))), widest);
    const V ay = orWidest(hn::Mul(half, hn::Mul(w1v, e2y)), zero);
    const V bx = orWidest(hn::Mul(half, hn::MulAdd(w2u, e1x, hn::Mul(w2v, e2x))), zero);
    const V by = orWidest(hn::Mul(half, hn::Mul(w2v, e2y)), widest);
    const V crossUv = hn::NegMulAdd(w1v, w2u, hn::Mul(w1u, w2v));
    const V cross = orWidest(hn::Mul(hn::Mul(crossUv, hn::Mul(e1x, e2y)), hn::Set(d, 0.25)),
                             hn::Mul(widest, widest));

    // Covariance with its floor, its eigenvalues and the major axis.
    const V floor = hn::Mul(place.texel2, hn::Set(d, 0.25));
    const V xx = hn::MulAdd(ax, ax, hn::Mul(bx, bx));
    const V yy = hn::MulAdd(ay, ay, hn::Mul(by, by));
    const V xy = hn::MulAdd(ax, ay, hn::Mul(bx, by));
    const V trace = hn::Add(xx, yy);
    const V determinant = hn::MulAdd(cross, cross, hn::Mul(floor, hn::Add(trace, floor)));
    const V difference = hn::Mul(half, hn::Sub(xx, yy));
    const V root = hn::Sqrt(hn::MulAdd(difference, difference, hn::Mul(xy, xy)));
    const V major = hn::Add(hn::MulAdd(half, trace, root), floor);
    const V minor = hn::Min(hn::Div(determinant, major), major);
    const auto alongX = hn::Ge(difference, zero);
    const V dx = hn::IfThenElse(alongX, hn::Add(root, difference), xy);
    const V dy = hn::IfThenElse(alongX, xy, hn::Sub(root, difference));
    const V length = hn::Sqrt(hn::MulAdd(dx, dx, hn::Mul(dy, dy)));
    const auto isRound = hn::Eq(length, zero);
    const V inverse = hn::Div(one, hn::IfThenElse(isRound, one, length));
    const V axisX = hn::IfThenElse(isRound, one, hn::Mul(dx, inverse));
    const V axisY = hn::Mul(dy, inverse);
    return {major, minor, axisX, axisY};
}

/// Neither longer nor thinner than the probes can span.
HWY_INLINE void
bound(D d, const ProbeSettings& settings, const ProbeCap& cap, const Place& place, Axes& axes)
{
    const double longest = kMostProbedEdges / settings.support;
    const V thinnest = hn::Set(d, cap.thinnest);
    axes.major = hn::Min(axes.major, hn::Mul(hn::Set(d, longest * longest), place.edge2));
    axes.minor = hn::Min(axes.minor, axes.major);
    const V lack = hn::Min(hn::Div(axes.minor, hn::Mul(thinnest, axes.major)), hn::Set(d, 1.0));
    axes.major = hn::Mul(axes.major, hn::Sqrt(hn::Sqrt(hn::Sqrt(lack))));
    axes.minor = hn::Max(axes.minor, hn::Mul(thinnest, axes.major));
}

/// Which levels are read, see `levelBlend`.
struct Blend
{
    V fine, coarse; ///< number of the finer level; weight of the coarser one
    V variance;     ///< that the blend has
};

/// \param wanted  variance
HWY_INLINE Blend blendOf(D d, const Place& place, V wanted, double band)
{
    const V edge2 = place.edge2;
    const V texel2 = place.texel2;
    const V zero = hn::Zero(d);
    const V half = hn::Set(d, 0.5);
    const V one = hn::Set(d, 1.0);
    const auto clamped = [&](V x) HWY_ATTR { return hn::Min(hn::Max(x, zero), one); };

    // The levels whose blend has the variance wanted. Below the base's own it is stretched to
    // what a level beyond it would have by the rule for the others. Of 4^level = edge²/texel² the
    // exponent tells the finer level.
    const V inPoints = hn::Mul(texel2, hn::Set(d, kTexelVariance));
    constexpr double kStretch =
        (kBaseVariance - kBeyondVariance) / (kBaseVariance - kDetailVariance);
    const V base = hn::Mul(texel2, hn::Set(d, kBaseVariance));
    const V sharpest = hn::Mul(texel2, hn::Set(d, kDetailVariance));
    wanted = hn::Max(wanted, sharpest);
    const V wantedBelow = hn::Min(hn::Sub(wanted, base), zero);
    const V stretched = hn::MulAdd(wantedBelow, hn::Set(d, kStretch - 1), wanted);
    const V wanted2 = hn::Mul(hn::Add(stretched, inPoints), hn::Set(d, 1 / kVertexKernel));
    const hn::RebindToSigned<D> di;
    const auto bits = hn::BitCast(di, hn::Div(edge2, wanted2));
    const auto exponent =
        hn::Sub(hn::ShiftRight<52>(bits), hn::Set(di, 1023)); // floor(log2), never negative bits
    const auto half2 = hn::ShiftRight<1>(exponent);
    const V finer = hn::ConvertTo(d, hn::Add(half2, hn::Set(di, 1)));
    V fine = hn::Min(hn::Max(finer, zero), hn::Set(d, double{Level::kMax}));
    const auto fineBits = hn::ConvertTo(di, fine);
    const V perTexel =
        hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(di, 1023), hn::Add(fineBits, fineBits))));
    const V fine2 = hn::Mul(edge2, perTexel);
    const auto hasCoarse = hn::Gt(fine, zero);
    const V third = hn::Set(d, 1.0 / 3.0);
    V coarse = clamped(hn::Mul(hn::Sub(hn::Div(wanted2, fine2), one), third));
    coarse = clamped(hn::MulAdd(hn::Sub(coarse, half), hn::Set(d, 1 / band), half));
    coarse = hn::IfThenElseZero(hasCoarse, coarse);
    const V byRule = hn::MulSub(hn::Mul(hn::Set(d, kVertexKernel), fine2),
                                hn::MulAdd(hn::Set(d, 3.0), coarse, one),
                                inPoints);
    const V below = hn::Min(hn::Sub(byRule, base), zero);
    const V variance = hn::MulAdd(below, hn::Set(d, 1 / kStretch - 1), byRule);
    const auto onlyCoarse = hn::Eq(coarse, one);
    return {hn::IfThenElse(onlyCoarse, hn::Sub(fine, one), fine),
            hn::IfThenZeroElse(onlyCoarse, coarse),
            variance};
}

/// Probes on a line.
struct Line
{
    V step;    ///< from probe to probe, in the plane; 0: they are all one
    V support; ///< in steps
};

/// \param variance  of the weights along the line
/// \param minor     variance, beside which little is nothing
/// \param spacing   largest step
HWY_INLINE Line
lineOf(D d, V variance, V minor, V spacing, const ProbeSettings& settings, const ProbeCap& cap)
{
    const V one = hn::Set(d, 1.0);
    // Little is let go of, smoothly, because roots of little change fast.
    const V negligible = hn::Mul(minor, hn::Set(d, 0.01));
    const V sigma = hn::Div(variance, hn::Sqrt(hn::Add(variance, negligible)));
    const V support = hn::Mul(sigma, hn::Set(d, settings.support));
    // Two probes one sigma from the centre have the variance to a hair; closer than that the
    // spacing shrinks instead of the number.
    const V spaced = hn::Min(spacing, hn::Add(sigma, sigma));
    const V step = hn::Max(spaced, hn::Mul(support, hn::Set(d, cap.shortestStep)));
    const auto isStep = hn::Gt(step, hn::Zero(d));
    const V steps = hn::Div(support, hn::IfThenElse(isStep, step, one));
    return {step, hn::IfThenElse(isStep, steps, one)};
}

/// A query's plan, for the lanes of one register.
HWY_INLINE void planLanes(const PlanInputs& in,
                          std::size_t at,
                          const ProbeSettings& settings,
                          const ProbeCap& cap,
                          ProbePlans& out)
{
    const D d;
    const V zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0);
    const auto clamped = [&](V x) HWY_ATTR { return hn::Min(hn::Max(x, zero), one); };
    const Place place = placeOf(d, in, at);
    Axes axes = axesOf(d, in, at, place);
    bound(d, settings, cap, place, axes);
    const auto& [major, minor, axisX, axisY] = axes;

    // What a line across spreads is taken from the blur.
    const V anisotropy = hn::Sqrt(hn::Div(major, minor));
    const V shorter =
        clamped(hn::Mul(hn::Sub(hn::Set(d, kOneLine), anisotropy), hn::Set(d, 1 / (kOneLine - 1))));
    const V directed = clamped(hn::Mul(hn::Sub(anisotropy, one), hn::Set(d, 1 / (kDirected - 1))));
    const V share = hn::Mul(hn::Set(d, settings.across), hn::Mul(shorter, shorter));
    const V across = hn::Mul(hn::Mul(hn::Set(d, kAcrossVariance), minor), hn::Mul(share, directed));

    const Blend blend = blendOf(d, place, hn::Sub(minor, across), settings.band);
    const V variance = blend.variance;

    // The probes make up for what the blur lacks of the ellipse: along the major axis and, up to
    // half as much again as the line across was meant to, along the minor one: one level may blur
    // less than was wanted. Not beyond that: a round footprint has no direction, and one that is
    // round but for rounding must not get a random one.
    const V longer = hn::Max(hn::Sub(major, hn::Max(variance, minor)), zero);
    const V lacking = hn::Max(hn::Sub(minor, variance), zero);
    const V spread = hn::Min(lacking, hn::Mul(across, hn::Set(d, 1.5)));
    const auto isCross = hn::Gt(share, zero);
    const V mainVariance = hn::Div(hn::Add(longer, spread), hn::Sub(one, share));
    const V crossVariance = hn::Div(spread, hn::IfThenElse(isCross, share, one));
    const V wider = hn::Exp(d, hn::Mul(hn::Log(d, anisotropy), hn::Set(d, kWidening)));
    const V spacing = hn::Mul(hn::Mul(hn::Set(d, settings.spacing), wider), hn::Sqrt(variance));
    const Line mainLine = lineOf(d, mainVariance, minor, spacing, settings, cap);
    const Line crossLine = lineOf(d, crossVariance, minor, spacing, settings, cap);

    const V e1x = hn::Load(d, in.e1x + at);
    const V e2x = hn::Load(d, in.e2x + at);
    const V e2y = hn::Load(d, in.e2y + at);
    const V perX = hn::Div(one, e1x);
    const V perY = hn::Div(one, e2y);
    const V stepV = hn::Mul(hn::Mul(axisY, mainLine.step), perY);
    const V stepU = hn::Mul(hn::NegMulAdd(stepV, e2x, hn::Mul(axisX, mainLine.step)), perX);
    const V crossV = hn::Mul(hn::Mul(axisX, crossLine.step), perY);
    const V crossU =
        hn::Mul(hn::MulAdd(crossV, e2x, hn::Mul(axisY, crossLine.step)), hn::Neg(perX));

    hn::Store(place.u, d, out.u + at);
    hn::Store(place.v, d, out.v + at);
    hn::Store(stepU, d, out.stepU + at);
    hn::Store(stepV, d, out.stepV + at);
    hn::Store(mainLine.support, d, out.support + at);
    hn::Store(crossU, d, out.crossU + at);
    hn::Store(crossV, d, out.crossV + at);
    hn::Store(crossLine.support, d, out.crossSupport + at);
    hn::Store(share, d, out.crossShare + at);
    hn::Store(blend.fine, d, out.fine + at);
    hn::Store(blend.coarse, d, out.coarse + at);
}

/// Plans of `count` inputs; places beyond may hold anything.
HWY_INLINE void
planAll(const PlanInputs& in, std::size_t count, const ProbeSettings& settings, ProbePlans& out)
{
    const ProbeCap cap = probeCap(settings);
    for (std::size_t at = 0; at < count; at += hn::Lanes(D())) {
        planLanes(in, at, settings, cap, out);
    }
}

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks many lines over the mesh at once, a side of a line to a lane, all of them from face to face
// by turns: memory is asked for one turn ahead, and a side that is done gives its lane to the last.
// Tells the pieces of lines that probes lie on. Included once per instruction set (see Highway).
#include "core/filter/probe_walk.h"

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#if defined(TRIXEL_PROBE_LANES_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIXEL_PROBE_LANES_SIMD
#undef TRIXEL_PROBE_LANES_SIMD
#else
#define TRIXEL_PROBE_LANES_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace trixel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Lines to walk, structure of arrays.
struct WalkLines
{
    static constexpr std::size_t kSize = 256;
    static constexpr std::size_t kRoom = kSize + 16;

    std::size_t count = 0;
    alignas(64) double u[kRoom], v[kRoom]; ///< centre, inside the face
    alignas(64) double stepU[kRoom], stepV[kRoom];
    alignas(64) double perSide[kRoom];    ///< probes, at least one
    alignas(64) std::int64_t face[kRoom]; ///< number
    alignas(64) std::int64_t side[kRoom]; ///< id of the side ahead, even; the one back has the next
    /// By half of that id: set for lines that meet a border, or more faces than may be; their
    /// pieces are to be placed by `placeProbes` instead.
    bool isCut[kRoom];

    void add(const ProbeLine& line, int probesPerSide, std::size_t number)
    {
        u[count] = line.centre.x;
        v[count] = line.centre.y;
        stepU[count] = line.step.x;
        stepV[count] = line.step.y;
        perSide[count] = probesPerSide;
        face[count] = static_cast<std::int64_t>(indexOf(line.face));
        side[count] = static_cast<std::int64_t>(2 * number);
        ++count;
    }
};

/// Sides on their way, structure of arrays. Points of the plane are seen from the line's centre: x
/// steps along the line, y as many to its left.
struct SideLanes
{
    static constexpr std::size_t kRoom = 2 * WalkLines::kRoom;
    enum : std::size_t {
        RightX,
        RightY, ///< of the edge that was crossed, the end to the right of the line
        LeftX,
        LeftY,
        EntryU,
        EntryV, ///< where that was, in the face beyond it
        Begin,  ///< how far along the line that is
        Next,   ///< number of the probe to come
        Reach,  ///< how far to go
        Fields
    };

    std::size_t count = 0;
    alignas(64) double fields[Fields][kRoom];
    alignas(64) std::int64_t at[kRoom]; ///< face << 2 | edge that it was entered by
    /// Faces walked << 32 | id of the side.
    alignas(64) std::int64_t id[kRoom];

    /// Gives a lane to the last side.
    void drop(std::size_t lane)
    {
        --count;
        for (auto& field : fields) {
            field[lane] = field[count];
        }
        at[lane] = at[count];
        id[lane] = id[count];
    }
};

class LineWalker
{
public:
    LineWalker(const FilterSurface& surface, WalkLines& lines, SideLanes& sides, Pieces& pieces)
        : m_steps(surface.laneSteps().data())
        , m_lines(lines)
        , m_sides(sides)
        , m_pieces(pieces)
    {
    }

    /// Adds all pieces.
    void walk()
    {
        m_sides.count = 0;
        for (std::size_t k = 0; k < m_lines.count; k += hn::Lanes(D())) {
            begin(k);
        }
        while (m_sides.count > 0) {
            // A lane that is given away gets the last side: from the back, none goes twice.
            const std::size_t lanes = hn::Lanes(D());
            for (std::size_t k = (m_sides.count - 1) / lanes * lanes + lanes; k > 0; k -= lanes) {
                advance(k - lanes);
            }
        }
    }

private:
    using D = hn::ScalableTag<double>;
    using DI = hn::RebindToSigned<D>;
    using V = hn::Vec<D>;
    using VI = hn::Vec<DI>;
    using M = hn::Mask<D>;

    /// Sides in the face that they are about to leave, a lane each.
    struct Leaving
    {
        V rightX, rightY, leftX, leftY, entryU, entryV;
        V begin, next, reach;
        VI face, id;
        M atEdge0, atEdge2; ///< the edge to leave by
    };

    HWY_INLINE V gather(VI face, std::size_t offset) const
    {
        const VI bytes = hn::Add(hn::ShiftLeft<5>(face), hn::Set(DI(), std::int64_t(offset)));
        return hn::GatherOffset(D(), reinterpret_cast<const double*>(m_steps), bytes);
    }

    /// (u,v) of the point t along edges, from their start, rest being 1 - t.
    static HWY_INLINE V uOn(M isEdge0, M isEdge2, V t, V rest)
    {
        return hn::IfThenZeroElse(isEdge2, hn::IfThenElse(isEdge0, t, rest));
    }
    static HWY_INLINE V vOn(M isEdge0, M isEdge2, V t, V rest)
    {
        return hn::IfThenZeroElse(isEdge0, hn::IfThenElse(isEdge2, rest, t));
    }

    HWY_INLINE void addPieces(const Leaving& at, M some, V leave, V crossing, V end)
    {
        const D d;
        const DI di;
        const V half = hn::Set(d, 0.5);
        const V rest = hn::Sub(hn::Set(d, 1.0), crossing);
        const V exitU = uOn(at.atEdge0, at.atEdge2, crossing, rest);
        const V exitV = vOn(at.atEdge0, at.atEdge2, crossing, rest);
        const V length = hn::Max(hn::Sub(leave, at.begin), hn::Set(d, 1e-300));
        const V perLength = hn::Div(hn::Set(d, 1.0), length);
        const V perU = hn::Mul(hn::Sub(exitU, at.entryU), perLength);
        const V perV = hn::Mul(hn::Sub(exitV, at.entryV), perLength);
        const V first = hn::Sub(hn::Add(at.next, half), at.begin);
        Pieces& to = m_pieces;
        const std::size_t n = to.count;
        hn::CompressStore(hn::MulAdd(first, perU, at.entryU), some, d, to.u + n);
        hn::CompressStore(hn::MulAdd(first, perV, at.entryV), some, d, to.v + n);
        hn::CompressStore(perU, some, d, to.perU + n);
        hn::CompressStore(perV, some, d, to.perV + n);
        hn::CompressStore(at.next, some, d, to.begin + n);
        hn::CompressStore(end, some, d, to.end + n);
        hn::StoreU(hn::Set(d, 1.0), d, to.share + n);
        const auto someInts = hn::RebindMask(di, some);
        hn::CompressStore(at.face, someInts, di, to.face + n);
        hn::CompressStore(at.id, someInts, di, to.id + n);
        to.count += hn::CountTrue(d, some);
    }

    /// Leaves the faces of valid lanes; returns those that go on, and where they are then.
    HWY_INLINE M leave(Leaving& at, M valid, VI& next)
    {
        const D d;
        const DI di;
        const V zero = hn::Zero(d);
        const V one = hn::Set(d, 1.0);
        const V half = hn::Set(d, 0.5);
        const V between = hn::Sub(at.leftY, at.rightY);
        // A line along the edge leaves anywhere on it.
        const M crosses = hn::Gt(between, zero);
        V crossing = hn::Div(hn::Neg(at.rightY), hn::IfThenElse(crosses, between, one));
        crossing = hn::IfThenElse(crosses, hn::Min(hn::Max(crossing, zero), one), half);
        const V along = hn::MulAdd(crossing, hn::Sub(at.leftX, at.rightX), at.rightX);
        const V leave = hn::Max(along, at.begin);

        const V last = hn::Floor(hn::Add(at.reach, half));
        const V whole = hn::Floor(hn::Add(hn::Min(leave, at.reach), half));
        const V end = hn::Min(hn::Max(whole, at.next), last);
        const M some = hn::And(valid, hn::Gt(end, at.next));
        if (!hn::AllFalse(d, some)) {
            addPieces(at, some, leave, crossing, end);
        }

        const M isDone = hn::Ge(leave, at.reach);
        const VI edge = hn::IfThenElseZero(
            hn::RebindMask(di, hn::Not(at.atEdge0)),
            hn::IfThenElse(hn::RebindMask(di, at.atEdge2), hn::Set(di, 2), hn::Set(di, 1)));
        const VI bytes = hn::Add(hn::ShiftLeft<5>(at.face),
                                 hn::Add(hn::ShiftLeft<2>(edge),
                                         hn::Set(di, offsetof(FilterSurface::LaneSteps, across))));
        const VI low = hn::Set(di, 0xFFFFFFFF);
        next = hn::And(hn::GatherOffset(di, reinterpret_cast<const std::int64_t*>(m_steps), bytes),
                       low);
        at.id = hn::Add(at.id, hn::Set(di, std::int64_t{1} << 32));
        const auto ends = hn::Or(
            hn::Eq(next, low), hn::Gt(at.id, hn::Set(di, (std::int64_t{kMostSegments} << 32) - 1)));
        const M goesOn = hn::AndNot(isDone, valid);
        const M isCut = hn::And(goesOn, hn::RebindMask(d, ends));
        if (!hn::AllFalse(d, isCut)) {
            noteCut(isCut, at.id);
        }
        at.begin = leave;
        at.next = end;
        const VI entered = hn::And(next, hn::Set(di, 3));
        const M by0 = hn::RebindMask(d, hn::Eq(entered, hn::Zero(di)));
        const M by2 = hn::RebindMask(d, hn::Eq(entered, hn::Set(di, 2)));
        const V rest = hn::Sub(one, crossing);
        at.entryU = uOn(by0, by2, rest, crossing);
        at.entryV = vOn(by0, by2, rest, crossing);
        return hn::AndNot(isCut, goesOn);
    }

    HWY_NOINLINE void noteCut(M isCut, VI id)
    {
        HWY_ALIGN std::int64_t ids[HWY_MAX_BYTES / 8];
        const std::size_t count = hn::CompressStore(id, hn::RebindMask(DI(), isCut), DI(), ids);
        for (std::size_t k = 0; k < count; ++k) {
            m_lines.isCut[(ids[k] & 0xFFFFFFFF) >> 1] = true;
        }
    }

    /// Both sides of the lines from `first` on, as far as in the face of their centre.
    void begin(std::size_t first)
    {
        const D d;
        const DI di;
        const V one = hn::Set(d, 1.0);
        const M valid = hn::FirstN(d, m_lines.count - first);
        const auto load = [&](const double* from) HWY_ATTR {
            return hn::IfThenElseZero(valid, hn::Load(d, from + first));
        };
        const V u = load(m_lines.u);
        const V v = load(m_lines.v);
        const V stepU = load(m_lines.stepU);
        const V stepV = load(m_lines.stepV);
        const V perSide = load(m_lines.perSide);
        const VI face =
            hn::IfThenElseZero(hn::RebindMask(di, valid), hn::Load(di, m_lines.face + first));
        const V apexX = gather(face, 0);
        const V apexY = gather(face, 8);
        const V clearance = clearanceOf(hn::BitCast(di, gather(face, 24)));

        const V stepX = hn::MulAdd(stepV, apexX, stepU);
        const V stepY = hn::Mul(stepV, apexY);
        const V square = hn::MulAdd(stepX, stepX, hn::Mul(stepY, stepY));
        const V perSquare = hn::Div(one, square);
        // How far along the line and to its left a corner lies, of what it is from the centre.
        const auto xOf = [&](V du, V dv) HWY_ATTR {
            const V along =
                hn::MulAdd(stepX, hn::MulAdd(dv, apexX, du), hn::Mul(stepY, hn::Mul(dv, apexY)));
            return hn::Mul(along, perSquare);
        };
        const auto yOf = [&](V du, V dv) HWY_ATTR {
            const V cross = hn::NegMulAdd(stepV, du, hn::Mul(stepU, dv));
            return hn::Mul(hn::Mul(apexY, cross), perSquare);
        };
        const V restU = hn::Sub(one, u);
        const V restV = hn::Sub(one, v);
        const V minusU = hn::Neg(u);
        const V minusV = hn::Neg(v);
        const V x0 = xOf(minusU, minusV);
        const V y0 = yOf(minusU, minusV);
        const V x1 = xOf(restU, minusV);
        const V y1 = yOf(restU, minusV);
        const V x2 = xOf(minusU, restV);
        const V y2 = yOf(minusU, restV);
        // Where no border is near, nobody needs to know what is beyond the last probe.
        const V least = hn::Mul(perSide, hn::Mul(perSide, square));
        const M isClear = hn::Lt(least, hn::Mul(clearance, clearance));
        const V reach = hn::IfThenElse(isClear, hn::Sub(perSide, hn::Set(d, 0.5)), perSide);
        const VI id = hn::Load(di, m_lines.side + first);
        Leaving leaving;
        leaving.entryU = u;
        leaving.entryV = v;
        leaving.reach = reach;
        leaving.face = face;
        leaving.id = id;
        beginSide(x0, y0, x1, y1, x2, y2, leaving, valid);
        leaving.entryU = u;
        leaving.entryV = v;
        leaving.id = hn::Add(id, hn::Set(di, 1));
        beginSide(hn::Neg(x0),
                  hn::Neg(y0),
                  hn::Neg(x1),
                  hn::Neg(y1),
                  hn::Neg(x2),
                  hn::Neg(y2),
                  leaving,
                  valid);
    }

    /// \param x0, y0, x1, y1, x2, y2  corners of the face, as seen on the way
    HWY_INLINE void beginSide(V x0, V y0, V x1, V y1, V x2, V y2, Leaving& leaving, M valid)
    {
        const D d;
        const V zero = hn::Zero(d);
        M left0 = hn::Gt(y0, zero);
        M left1 = hn::Gt(y1, zero);
        M left2 = hn::Gt(y2, zero);
        // Where the centre is on the boundary and rounding has the line pass outside, the corner
        // nearest to the line counts for the other side.
        const M all = hn::And(hn::And(left0, left1), left2);
        const M any = hn::Or(hn::Or(left0, left1), left2);
        const M isOutside = hn::Or(all, hn::Not(any));
        const V off0 = hn::Abs(y0);
        const V off1 = hn::Abs(y1);
        const V off2 = hn::Abs(y2);
        const M is0 = hn::And(hn::Le(off0, off1), hn::Le(off0, off2));
        const M is1 = hn::AndNot(is0, hn::Le(off1, off2));
        const M is2 = hn::Not(hn::Or(is0, is1));
        left0 = hn::Xor(left0, hn::And(isOutside, is0));
        left1 = hn::Xor(left1, hn::And(isOutside, is1));
        left2 = hn::Xor(left2, hn::And(isOutside, is2));

        const M at0 = hn::AndNot(left0, left1);
        const M at1 = hn::AndNot(left1, left2);
        const M at2 = hn::Not(hn::Or(at0, at1));
        leaving.atEdge0 = at0;
        leaving.atEdge2 = at2;
        leaving.rightX = hn::IfThenElse(at0, x0, hn::IfThenElse(at2, x2, x1));
        leaving.rightY = hn::IfThenElse(at0, y0, hn::IfThenElse(at2, y2, y1));
        leaving.leftX = hn::IfThenElse(at0, x1, hn::IfThenElse(at2, x0, x2));
        leaving.leftY = hn::IfThenElse(at0, y1, hn::IfThenElse(at2, y0, y2));
        leaving.begin = zero;
        leaving.next = zero;
        VI next;
        const M goesOn = leave(leaving, valid, next);
        append(leaving, next, goesOn);
    }

    HWY_INLINE void append(const Leaving& from, VI next, M goesOn)
    {
        const D d;
        const DI di;
        SideLanes& to = m_sides;
        const auto put = [&](V value, std::size_t field) HWY_ATTR {
            hn::CompressStore(value, goesOn, d, to.fields[field] + to.count);
        };
        put(from.rightX, SideLanes::RightX);
        put(from.rightY, SideLanes::RightY);
        put(from.leftX, SideLanes::LeftX);
        put(from.leftY, SideLanes::LeftY);
        put(from.entryU, SideLanes::EntryU);
        put(from.entryV, SideLanes::EntryV);
        put(from.begin, SideLanes::Begin);
        put(from.next, SideLanes::Next);
        put(from.reach, SideLanes::Reach);
        const auto ints = hn::RebindMask(di, goesOn);
        hn::CompressStore(next, ints, di, to.at + to.count);
        hn::CompressStore(from.id, ints, di, to.id + to.count);
        const std::size_t end = to.count + hn::CountTrue(d, goesOn);
        for (; to.count < end; ++to.count) {
            hwy::Prefetch(m_steps + (to.at[to.count] >> 2));
        }
    }

    /// One face on for the sides from `first` on.
    HWY_INLINE void advance(std::size_t first)
    {
        const D d;
        const DI di;
        SideLanes& sides = m_sides;
        if (first >= sides.count) {
            return; // given away meanwhile
        }
        const std::size_t lanes = std::min(hn::Lanes(d), sides.count - first);
        const M valid = hn::FirstN(d, lanes);
        const auto load = [&](std::size_t field)
                              HWY_ATTR { return hn::Load(d, sides.fields[field] + first); };
        const VI at = hn::IfThenElseZero(hn::RebindMask(di, valid), hn::Load(di, sides.at + first));
        Leaving leaving;
        leaving.face = hn::ShiftRight<2>(at);
        const VI entered = hn::And(at, hn::Set(di, 3));
        const V apexX = gather(leaving.face, 0);
        const V apexY = gather(leaving.face, 8);
        const V rightX = load(SideLanes::RightX);
        const V rightY = load(SideLanes::RightY);
        const V leftX = load(SideLanes::LeftX);
        const V leftY = load(SideLanes::LeftY);
        const M by0 = hn::RebindMask(d, hn::Eq(entered, hn::Zero(di)));
        const M by1 = hn::RebindMask(d, hn::Eq(entered, hn::Set(di, 1)));
        const M by2 = hn::Not(hn::Or(by0, by1));

        // As LaneSteps::opposite has it; the edge runs from left to right here.
        const V one = hn::Set(d, 1.0);
        const V zx = hn::IfThenElse(by1, hn::Sub(one, apexX), apexX);
        const V zy = hn::IfThenElse(by1, hn::Neg(apexY), apexY);
        const V perSquare = hn::Div(one, hn::MulAdd(zx, zx, hn::Mul(zy, zy)));
        const V inverseX = hn::Mul(zx, perSquare);
        const V inverseY = hn::Mul(zy, perSquare); // its negative
        const V x =
            hn::IfThenElse(by0, apexX, hn::IfThenElse(by2, hn::Sub(one, inverseX), inverseX));
        const V y = hn::IfThenElse(by0, apexY, hn::IfThenElse(by2, inverseY, hn::Neg(inverseY)));
        const V alongX = hn::Sub(rightX, leftX);
        const V alongY = hn::Sub(rightY, leftY);
        const V farX = hn::Add(leftX, hn::NegMulAdd(y, alongY, hn::Mul(x, alongX)));
        const V farY = hn::Add(leftY, hn::MulAdd(x, alongY, hn::Mul(y, alongX)));
        // Leaves by the next edge counter-clockwise, or the one after it.
        // A vertex on the line, but for rounding, counts as right of it.
        const V rounding = hn::Mul(hn::Set(d, kSideRounding), hn::Sub(leftY, rightY));
        const M isLeft = hn::Gt(farY, rounding);
        leaving.rightX = hn::IfThenElse(isLeft, rightX, farX);
        leaving.rightY = hn::IfThenElse(isLeft, rightY, farY);
        leaving.leftX = hn::IfThenElse(isLeft, farX, leftX);
        leaving.leftY = hn::IfThenElse(isLeft, farY, leftY);
        leaving.atEdge0 = hn::Or(hn::And(by2, isLeft), hn::AndNot(isLeft, by1));
        leaving.atEdge2 = hn::Or(hn::And(by1, isLeft), hn::AndNot(isLeft, by0));
        leaving.entryU = load(SideLanes::EntryU);
        leaving.entryV = load(SideLanes::EntryV);
        leaving.begin = load(SideLanes::Begin);
        leaving.next = load(SideLanes::Next);
        leaving.reach = load(SideLanes::Reach);
        leaving.id = hn::Load(di, sides.id + first);
        VI next;
        const M goesOn = leave(leaving, valid, next);

        const auto store = [&](V value, std::size_t field)
                               HWY_ATTR { hn::Store(value, d, sides.fields[field] + first); };
        store(leaving.rightX, SideLanes::RightX);
        store(leaving.rightY, SideLanes::RightY);
        store(leaving.leftX, SideLanes::LeftX);
        store(leaving.leftY, SideLanes::LeftY);
        store(leaving.entryU, SideLanes::EntryU);
        store(leaving.entryV, SideLanes::EntryV);
        store(leaving.begin, SideLanes::Begin);
        store(leaving.next, SideLanes::Next);
        const auto onInts = hn::RebindMask(di, goesOn);
        hn::Store(hn::IfThenElseZero(onInts, next), di, sides.at + first);
        hn::Store(leaving.id, di, sides.id + first);
        for (std::size_t k = 0; k < lanes; ++k) {
            hwy::Prefetch(m_steps + (sides.at[first + k] >> 2));
        }
        dropDone(first, hn::AndNot(goesOn, valid));
    }

    HWY_INLINE void dropDone(std::size_t first, M done)
    {
        const D d;
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, done, bytes);
        for (unsigned bits = bytes[0]; bits != 0;) {
            const unsigned lane = 31U - static_cast<unsigned>(__builtin_clz(bits));
            m_sides.drop(first + lane);
            bits ^= 1U << lane;
        }
    }

    /// The float in the upper half of a word, never negative, made a double: denormals are as good
    /// as nothing and infinity as good as 2^128.
    static HWY_INLINE V clearanceOf(VI words)
    {
        const VI bits = hn::ShiftLeft<29>(hn::ShiftRight<32>(words));
        return hn::BitCast(D(), hn::Add(bits, hn::Set(DI(), std::int64_t{1023 - 127} << 52)));
    }

    const FilterSurface::LaneSteps* m_steps;
    WalkLines& m_lines;
    SideLanes& m_sides;
    Pieces& m_pieces;
};

} // namespace trixel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

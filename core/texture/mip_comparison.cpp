// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/mip_comparison.h"

#include "core/base/check.h"

#include <algorithm>

namespace trixel {

namespace {

/// The same texels in memory of their own.
FaceTexels copyOf(const FaceTexels& face)
{
    return face.isConstant() ? FaceTexels::constant(face.level(), face.bytes())
                             : FaceTexels::full(face.level(), face.texelBytes(), face.bytes());
}

} // namespace

Result<MipComparison>
MipComparison::build(const TexelFormat& format, const FaceTexels& face, Progress& progress)
{
    StageProgress first(progress, 0, 0.4);
    const Result<MipChain> right = MipChain::build(format, face, ReductionRule::Triangles, first);
    if (!right) {
        return tl::unexpected(right.error());
    }
    StageProgress second(progress, 0.4, 0.8);
    const Result<MipChain> box = MipChain::build(format, face, ReductionRule::Box, second);
    if (!box) {
        return tl::unexpected(box.error());
    }
    MipComparison comparison;
    comparison.m_format = format;
    comparison.m_base = face.level();
    for (int n = 0; n <= face.level().log2(); ++n) {
        if (!progress.report(0.8)) {
            return cancelled();
        }
        comparison.m_levels.push_back(comparison.factsOf(Level(n), *right, *box));
    }
    return comparison;
}

MipComparison::Facts
MipComparison::factsOf(Level level, const MipChain& right, const MipChain& box) const
{
    Facts facts;
    const FaceTexels& texels = right.at(level);
    facts.constant = texels.collapsed().isConstant();
    facts.rightDrawn = right.at(std::min(level, kFinestDrawn));
    if (level == m_base) {
        if (level <= kFinestDrawn) {
            facts.rightDrawn = copyOf(facts.rightDrawn);
        }
        facts.boxDrawn = facts.rightDrawn;
        return facts;
    }
    facts.right = texels;
    facts.box = box.at(level);
    facts.difference = differenceBetween(m_format, facts.right, facts.box);
    // From afar one sees the mean of what the box left, not what it would make of it next.
    facts.boxDrawn = reduced(m_format, facts.box, level.log2() - kFinestDrawn.log2());
    return facts;
}

const MipComparison::Facts& MipComparison::facts(Level level) const
{
    check(level <= m_base, "a level that the face has");
    return m_levels[static_cast<std::size_t>(level.log2())];
}

const FaceTexels& MipComparison::at(Level level, ReductionRule rule) const
{
    check(level < m_base, "a level that was made");
    return rule == ReductionRule::Box ? facts(level).box : facts(level).right;
}

const FaceTexels& MipComparison::drawn(Level level, ReductionRule rule) const
{
    return rule == ReductionRule::Box ? facts(level).boxDrawn : facts(level).rightDrawn;
}

double MipComparison::worstDifference() const
{
    double worst = 0;
    for (const Facts& level : m_levels) {
        worst = std::max(worst, level.difference.worst);
    }
    return worst;
}

std::vector<float> MipComparison::values(const FaceTexels& face,
                                         Level level,
                                         TexelCoord texel,
                                         ReductionRule rule) const
{
    check(face.level() == m_base && face.texelBytes() == m_format.texelBytes(),
          "the face that was built from");
    const FaceTexels& texels = level == m_base ? face : at(level, rule);
    std::vector<float> values(m_format.channels);
    decode(m_format.type, texels.texel(indexOf(texelIndex(level, texel))), values);
    return values;
}

} // namespace trixel

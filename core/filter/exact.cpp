// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/exact_answer.h"
#include "core/filter/methods.h"

namespace trixel {
namespace {

class Exact final : public FilterMethod
{
public:
    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        Unfolding unfolding;
        filterEach(scene,
                   queries,
                   results,
                   [&](const QueryEllipse& ellipse, FaceId face, int group, GroupValue& value) {
                       return exactAnswer(scene, unfolding, ellipse, face, group, value);
                   });
    }
};

} // namespace

MethodEntry exactMethod()
{
    MethodEntry entry;
    entry.name = "exact";
    entry.title = "Exact";
    entry.about = "The Gaussian over every texel of the base level, in double precision: what the "
                  "others are judged by.";
    entry.claims = {.affineKept = Claim::Yes,
                    .rotationFree = Claim::Yes,
                    .edgeContinuous = Claim::Yes,
                    .levelContinuous = Claim::Yes};
    entry.make = [](double) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<Exact>();
    };
    return entry;
}

} // namespace trixel

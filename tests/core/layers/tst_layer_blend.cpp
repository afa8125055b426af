// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_blend.h"

#include <gtest/gtest.h>

#include <array>

using namespace trixel;

namespace {

struct Known
{
    LayerBlend blend;
    float dark;  ///< of 0.25 below and 0.5
    float light; ///< of 0.75 below and 0.5
};

constexpr std::array kKnown{Known{LayerBlend::Normal, 0.5F, 0.5F},
                            Known{LayerBlend::Multiply, 0.125F, 0.375F},
                            Known{LayerBlend::Screen, 0.625F, 0.875F},
                            Known{LayerBlend::Overlay, 0.25F, 0.75F},
                            Known{LayerBlend::Darken, 0.25F, 0.5F},
                            Known{LayerBlend::Lighten, 0.5F, 0.75F},
                            Known{LayerBlend::Add, 0.75F, 1.25F},
                            Known{LayerBlend::Subtract, -0.25F, 0.25F},
                            Known{LayerBlend::Difference, 0.25F, 0.25F}};

} // namespace

TEST(LayerBlend, givesTheKnownValues)
{
    ASSERT_EQ(kKnown.size(), kLayerBlends.size());
    for (const Known& known : kKnown) {
        EXPECT_EQ(blended(known.blend, 0.25F, 0.5F), known.dark) << nameOf(known.blend);
        EXPECT_EQ(blended(known.blend, 0.75F, 0.5F), known.light) << nameOf(known.blend);
    }
    EXPECT_EQ(blended(LayerBlend::Overlay, 0.25F, 0.75F), 0.375F); // which of the two counts
    EXPECT_EQ(blended(LayerBlend::Overlay, 0.75F, 0.25F), 0.625F);
}

TEST(LayerBlend, eachHasANameAndTheNameGivesItBack)
{
    for (const LayerBlend blend : kLayerBlends) {
        EXPECT_EQ(layerBlendFromName(nameOf(blend)), blend);
    }
    EXPECT_EQ(layerBlendFromName("dissolve"), std::nullopt);
    EXPECT_EQ(nameOf(LayerBlend::Difference), "difference");
}

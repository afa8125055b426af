// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/brush.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using namespace trixel;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

} // namespace

TEST(Brush, theDefaultIsValid)
{
    EXPECT_TRUE(validate(Brush{}));
}

TEST(Brush, everySettingOutOfRangeIsRefusedByNameAndValue)
{
    struct Case
    {
        float Brush::*setting;
        const char* name;
        std::vector<float> refused;
    };
    const std::vector<Case> cases{
        {&Brush::radius, "radius", {0.0F, -1.0F, kNan, kInfinity}},
        {&Brush::hardness, "hardness", {-0.01F, 1.01F, kNan, kInfinity}},
        {&Brush::opacity, "opacity", {-0.01F, 1.01F, kNan, kInfinity}},
        {&Brush::flow, "flow", {-0.01F, 1.01F, kNan, kInfinity}},
        {&Brush::spacing, "spacing", {0.0F, -1.0F, 4.01F, kNan, kInfinity}},
    };
    for (const Case& c : cases) {
        for (const float value : c.refused) {
            Brush brush;
            brush.*(c.setting) = value;
            const Status status = validate(brush);
            ASSERT_FALSE(status) << c.name << " " << value;
            EXPECT_EQ(status.error().message.find(std::string(c.name) + ": expected "), 0U);
        }
    }
    Brush brush;
    brush.color[2] = kNan;
    ASSERT_FALSE(validate(brush));
    EXPECT_EQ(validate(brush).error().message, "color: expected finite numbers, found nan");
    brush = Brush{};
    brush.radius = -2.5F;
    EXPECT_EQ(validate(brush).error().message,
              "radius: expected a finite number above 0, found -2.5");
}

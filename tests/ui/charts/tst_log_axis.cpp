// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/log_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace trixel::ui {
namespace {

std::vector<std::string> textsOf(const LogAxis& axis, int most)
{
    std::vector<std::string> texts;
    for (const Tick& tick : axis.ticks(most)) {
        if (!tick.text.isEmpty()) {
            texts.push_back(QString(tick.text).replace(QChar(0x00A0), ' ').toStdString());
        }
    }
    return texts;
}

std::string textOf(double value, Quantity quantity)
{
    return quantityText(value, quantity).replace(QChar(0x00A0), ' ').toStdString();
}

TEST(QuantityTest, numbersReadAsPeopleWriteThem)
{
    EXPECT_EQ(textOf(80, Quantity::Nanoseconds), "80 ns");
    EXPECT_EQ(textOf(999.9, Quantity::Nanoseconds), "1 µs");
    EXPECT_EQ(textOf(5438, Quantity::Nanoseconds), "5.44 µs");
    EXPECT_EQ(textOf(1.5e6, Quantity::Nanoseconds), "1.5 ms");
    EXPECT_EQ(textOf(3e9, Quantity::Nanoseconds), "3 s");
    EXPECT_EQ(textOf(0.5, Quantity::Nanoseconds), "0.5 ns");
    EXPECT_EQ(textOf(0.0146, Quantity::Fraction), "1.46 %");
    EXPECT_EQ(textOf(1, Quantity::Fraction), "100 %");
    EXPECT_EQ(textOf(1e-6, Quantity::Fraction), "0.0001 %");
    EXPECT_EQ(textOf(2.5e-8, Quantity::Fraction), "2.5·10⁻⁶ %");
    EXPECT_EQ(textOf(1e-9, Quantity::Number), "10⁻⁹");
    EXPECT_EQ(textOf(12'000, Quantity::Bytes), "12 kB");
    EXPECT_EQ(textOf(250'000, Quantity::Number), "250000");
    EXPECT_EQ(textOf(0, Quantity::Nanoseconds), "0 ns");
    EXPECT_EQ(textOf(std::nan(""), Quantity::Fraction), "–");
}

TEST(LogAxisTest, ticksStandAtRoundNumbers)
{
    const LogAxis times(std::vector{12.0, 1800.0}, Quantity::Nanoseconds);
    EXPECT_EQ(textsOf(times, 8),
              (std::vector<std::string>{
                  "10 ns", "20 ns", "50 ns", "100 ns", "200 ns", "500 ns", "1 µs", "2 µs"}));
}

TEST(LogAxisTest, fewerNumbersWhereThereIsLittleRoom)
{
    const LogAxis axis(std::vector{1e-6, 1.0}, Quantity::Fraction);
    for (int most = 2; most < 20; ++most) {
        EXPECT_LE(textsOf(axis, most).size(), static_cast<std::size_t>(std::max(most, 3)));
        EXPECT_GE(textsOf(axis, most).size(), 2U);
    }
    EXPECT_EQ(textsOf(axis, 7).front(), "0.0001 %");
    EXPECT_EQ(textsOf(axis, 7).back(), "100 %");
}

TEST(LogAxisTest, placeGrowsWithTheValueAndStaysInside)
{
    const LogAxis axis(std::vector{3.0, 40'000.0}, Quantity::Nanoseconds);
    double last = 0;
    for (double value = 3; value <= 40'000; value *= 1.1) {
        EXPECT_GT(axis.place(value), last);
        last = axis.place(value);
    }
    EXPECT_LT(last, 1);
    EXPECT_NEAR(axis.place(std::sqrt(3.0 * 40'000)), 0.5, 1e-9);
}

TEST(LogAxisTest, zeroAndTheVanishinglySmallShareALineAtTheEnd)
{
    const LogAxis axis(std::vector{0.0, 1e-3, 1e-2}, Quantity::Fraction);
    EXPECT_EQ(textsOf(axis, 10).front(), "0");
    EXPECT_LT(axis.place(0), axis.place(1e-3) - 0.05);
    EXPECT_GE(axis.place(0), 0);

    const LogAxis wide(std::vector{1e-30, 1e-3, 1.0}, Quantity::Fraction);
    EXPECT_TRUE(wide.isBelow(1e-30));
    EXPECT_EQ(textsOf(wide, 10).front(), "≤10⁻²⁸ %");
    EXPECT_LT(wide.place(1e-3), 0.2); // the least that is left

    const LogAxis rounding(std::vector{0.0, 1.06e-8, 0.008, 0.26}, Quantity::Fraction, 5);
    EXPECT_EQ(textsOf(rounding, 10).front(), "≤2·10⁻⁶ %");
    EXPECT_TRUE(rounding.isBelow(1.06e-8));
    EXPECT_FALSE(rounding.isBelow(0.008));
}

TEST(LogAxisTest, infinityHasALineOfItsOwnAboveAll)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const LogAxis axis(std::vector{1e-3, 1.0, kInfinity}, Quantity::Number);
    const Tick last = axis.ticks(10).back();
    EXPECT_EQ(last.text.toStdString(), "∞");
    EXPECT_EQ(last.place, axis.place(kInfinity));
    EXPECT_GT(last.place, axis.place(1) + 0.05);

    const LogAxis finite(std::vector{1e-3, 1.0}, Quantity::Number);
    EXPECT_NE(finite.ticks(10).back().text.toStdString(), "∞");
    EXPECT_GT(finite.place(1), axis.place(1)); // the room is kept where there is need
}

TEST(LogAxisTest, oneValueNoValueAndNonsenseGiveAnAxis)
{
    for (const std::vector<double>& values :
         {std::vector<double>{},
          std::vector{5.0},
          std::vector{0.0},
          std::vector{std::nan(""), -1.0, std::numeric_limits<double>::infinity()},
          std::vector{5e-324, 1.7e308}}) {
        const LogAxis axis(values, Quantity::Number);
        EXPECT_FALSE(axis.ticks(5).empty());
        EXPECT_LT(axis.ticks(5).size(), 200U);
        for (const Tick& tick : axis.ticks(5)) {
            EXPECT_GE(tick.place, 0);
            EXPECT_LE(tick.place, 1);
        }
    }
    EXPECT_NEAR(LogAxis(std::vector{5.0}, Quantity::Number).place(5), 0.5, 1e-9);
}

} // namespace
} // namespace trixel::ui

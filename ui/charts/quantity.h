// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>

namespace trixel::ui {

/// What the numbers of an axis are.
enum class Quantity {
    Nanoseconds, ///< read as ns, µs, ms or s
    Bytes,       ///< read as B, kB, MB or GB
    Fraction,    ///< read as per cent
    Number       ///< read as it is
};

/// The kind of a study's cost unit: "ns" and "bytes" are known, all else is a number.
Quantity quantityOf(std::string_view unit);

/// A number as people read it, with its unit: "1.46 %", "80 ns", "1.2 µs". Zero is "0" with the
/// base unit; a value that is not finite is "–".
/// \param digits  significant digits; trailing zeros are left out
QString quantityText(double value, Quantity quantity, int digits = 3);

} // namespace trixel::ui

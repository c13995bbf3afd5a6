// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// column_digits: to which resolution a log of normal detail writes each column of trajectory.csv.
//
// The resolution belongs to the column, by the unit that its name ends in: far below what any
// sensor of a legged robot tells, far above what a double holds.

#include <string>
#include <string_view>

namespace sidestep {

/// The unit that a column's name ends in, without the underscore before it: "m", "kgm2ps"; empty
/// for a plain number.
std::string_view ColumnUnit(std::string_view column);

/// Decimal places of a column in SI units: 7 is 1e-7. A name without a unit is of a plain number.
int DecimalsOf(std::string_view column);

/// Appends `value` rounded to so many decimal places, 0 to 9, without trailing zeros and never as
/// "-0". A value of 1e15 and more, and one that is not finite, is written as AppendNumber does.
void AppendRounded(std::string& text, double value, int decimals);

}  // namespace sidestep

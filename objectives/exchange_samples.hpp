// SPDX-License-Identifier: MIT
// Private to objectives/: where the rows of a discretised problem lie.
#pragma once

namespace camopt {

/// Samples of one rule closer than this part of their segment are one sample.
inline constexpr double same_sample = 1e-9;
/// A maximum is bracketed by rows at this part of the distance to the nearest sample on either side.
inline constexpr double bracket = 0.25;
/// A row whose multiplier is less than this part of the largest presses nowhere.
inline constexpr double idle_row = 1e-6;
/// Rows around a place that is pressed on: where rows on both sides of it press, at this part of the square
/// of their distance (all in parts of the segment; of 1/4, 0.35, 1/2 and 1 it takes the fewest rounds on
/// scenes with and without a cam), and never closer than the other part: so close, a slope that is left free
/// exceeds its peak by 1e-8 of it at most, which the next round settles.
inline constexpr double pair_reach = 0.35;
inline constexpr double closest_pair = 1e-3;
/// Rows at such places that are closer to others than this part of their segment say the same: an interior
/// point loses digits over them (measured: at 1e-4 it came to nothing better than "acceptable" once).
inline constexpr double too_close = 3e-4;

}  // namespace camopt

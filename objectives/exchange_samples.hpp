// SPDX-License-Identifier: MIT
// Private to objectives/: where the exchange adds rows.
#pragma once

namespace camopt {

/// Samples of one rule closer than this part of their segment coincide.
inline constexpr double same_sample = 1e-9;
/// A maximum is bracketed by rows at this part of the distance to the nearest sample on either side.
inline constexpr double bracket = 0.25;
/// A row whose multiplier is below this part of the largest is inactive.
inline constexpr double idle_row = 1e-6;
/// Rows next to a predicted maximum: between active rows on both sides, at this part of the square of their
/// distance (all in parts of the segment; of 1/4, 0.35, 1/2 and 1 it takes the fewest rounds on scenes with
/// and without a cam), and never closer than the second constant: at that distance a free slope exceeds its
/// peak by at most 1e-8 of it, which the next round corrects.
inline constexpr double pair_reach = 0.35;
inline constexpr double closest_pair = 1e-3;
/// Rows closer to others than this part of their segment are nearly parallel: an interior point method loses
/// digits over them (measured: at 1e-4 one solve reached only "acceptable").
inline constexpr double too_close = 3e-4;

}  // namespace camopt

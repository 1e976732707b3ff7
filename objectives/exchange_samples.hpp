// SPDX-License-Identifier: MIT
// Private to objectives/: where the rows of a discretised problem lie.
#pragma once

namespace camopt {

/// Samples of one rule closer than this part of their segment are one sample.
inline constexpr double same_sample = 1e-9;
/// A maximum is bracketed by rows at this part of the distance to the nearest sample on either side.
inline constexpr double bracket = 0.25;

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A valve lobe as a table for engine programs.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// lobe.csv, one row a step of cam angle over the revolution, the nose at 0:
///   theta_deg         cam angle from the nose (a table for [measured] with zero = "nose")
///   crank_angle_deg   after top dead centre; without a centerline from the nose
///   s_U, valve_U      follower and valve lift, U = mm or in; a swinging follower has s_deg
///   v_U_deg, a_U_deg2, j_U_deg3   derivatives of the follower by the cam angle
/// digits: significant; none: as many as read back. Throws InputError for another motion and for a step that
/// does not divide 360 degrees.
struct LobeTable {
    LengthUnit unit = LengthUnit::millimetre;
    double step_deg = 1.0;
    std::optional<int> digits = {};
};
[[nodiscard]] std::string lobe_csv(const Solution& solution, const LobeTable& table);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// pareto.csv: one line a point of a front, by the first goal.
//
// Columns: point (from 0; empty for what lies between), solve (its number in the order of the solves), end
// ("attained", "cut_off", "beyond" or empty), both goals (dimensions in mm), arc, minimized, cap (on the
// other goal, its unit), verdict, reason, objective, lower_bound, gap, limit_first and limit_second (the
// any-curve limit of both goals for this point), the figures, the variable dimensions in mm, active_limits,
// iterations, seconds_total. A finished front has its spaced points here and what failed; a stopped one
// everything.
#pragma once

#include "studies/pareto/pareto_front.hpp"

#include <string>
#include <vector>

namespace camopt {

[[nodiscard]] std::string pareto_csv(const ParetoFront& front);

/// The points that stand in the table, in its order.
[[nodiscard]] std::vector<const FrontPoint*> tabulated_points(const ParetoFront& front);

/// The name of a goal with its unit: "velocity", "base_radius_mm"; "weighted_velocity" where the scene's
/// other weights stay in force.
[[nodiscard]] std::string goal_column(const ParetoFront& front, int goal);

/// A goal's value in that unit.
[[nodiscard]] double goal_value(const ParetoFront& front, int goal, double value);

/// What no curve can pass, for both goals of a point; none where it is not known or not finite.
[[nodiscard]] std::optional<std::array<double, 2>> any_curve_point(const ParetoFront& front,
                                                                   const FrontPoint& point);

[[nodiscard]] const char* name_of(FrontEnd value);

}  // namespace camopt

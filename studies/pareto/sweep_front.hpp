// SPDX-License-Identifier: MIT
// The Pareto front of a sweep.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

/// Relative width within which two figures count as equal. Peaks of optima are known to about solver.gap
/// (1e-7), so less would let rounding decide.
inline constexpr double front_tolerance = 1e-6;

/// Sets SweepRow::on_front in every row.
///
/// Only rows that agree in every setting that is no weight are compared: cams of another base radius, curves
/// of other segments are other questions, each with a front of its own. A feasible row is on the front unless
/// another feasible row dominates it: is in no criterion (SweepColumns::criteria; the offset by its
/// magnitude) worse, and in at least one better, by more than front_tolerance. Infeasible and failed rows are
/// never on it. A criterion that a row does not have plays no part in its comparisons.
void mark_front(SweepTable& table);

// A figure that a front can trade against another: a peak, a root mean square, or a variable dimension of the
// cam. How to weigh it, how to cap it, and what a solution makes of it.
//
// Values are normalised as in core/motion.hpp; dimensions are in m. Functions throw InputError where said.

/// The terms of the objective whose rows say that a front can trade them.
using FrontFigure = CostFigure;

using FrontGoal = std::variant<FrontFigure, DimensionIndex>;

/// "velocity", "acceleration", "base_radius", …: the name of its weight in a scene.
[[nodiscard]] std::string name_of(const FrontGoal& goal);

/// Throws InputError, listing what this scene has, where it has no goal of that name. Dimensions must be
/// variable and signless.
[[nodiscard]] FrontGoal front_goal(std::string_view name, const Scene& scene);

/// Peaks and dimensions can be kept below a number; a root mean square cannot, nor can the peaks of a program
/// whose own limit is one in time.
[[nodiscard]] bool can_be_capped(const Scene& scene, const FrontGoal& goal);

/// The scene's own hard limit on it.
[[nodiscard]] std::optional<double> limit_on(const Scene& scene, const FrontGoal& goal);

/// Demands goal <= value; value must not lie above the scene's own limit, nor below a dimension's least.
void set_cap(Scene& scene, const FrontGoal& goal, double value);

/// A cap as --set takes it: its key, and a value in the unit of the key.
struct CapSetting {
    std::string key;
    double value = 0.0;
};
[[nodiscard]] CapSetting cap_setting(const Scene& scene, const FrontGoal& goal, double value);

[[nodiscard]] double weight_of(const Scene& scene, const FrontGoal& goal);
void set_weight(Scene& scene, const FrontGoal& goal, double weight);
/// All weights of the scene times a number >= 0.
void scale_weights(Scene& scene, double factor);

/// The row must have a motion.
[[nodiscard]] double value_of(const SweepRow& row, const FrontGoal& goal);

/// What the objective divides it by. The reference peaks must be finite where a weight is set.
[[nodiscard]] double reference_of(const Scene& scene, const FrontGoal& goal);

}  // namespace camopt

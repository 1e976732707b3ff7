// SPDX-License-Identifier: MIT
// The Pareto front of a sweep.
#pragma once

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

}  // namespace camopt

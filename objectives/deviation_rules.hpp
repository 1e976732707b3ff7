// SPDX-License-Identifier: MIT
// The distance of a motion from the rows (x_k, t_k) of a measured table, as terms of the objective:
//
//   deviation       D >= |y(x_k) − t_k| for every row            linear
//   deviation_rms   sqrt((1/m) Σ_k (y(x_k) − t_k)²) <= D         convex quadratic, one row
//
// y, t and D in lifts, x in unit angles.
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/cost_table.hpp"

namespace camopt {

struct MeasuredRow {
    double x = 0.0, y = 0.0;
};

/// The rows that lie on the motion from begin to end.
[[nodiscard]] std::vector<MeasuredRow> measured_rows(const Scene& scene, double begin, double end);

/// The largest distance with its x, and the root mean square of all.
struct Deviation {
    Extremum largest;
    double rms = 0.0;
};
[[nodiscard]] Deviation deviation_of(const std::vector<MeasuredRow>& rows, const Motion& motion);

/// What a term is divided by: the scene's number, or a thousandth of the lift.
[[nodiscard]] double deviation_reference(const Scene& scene, const ResponseTerm& term);

void add_deviation_terms(CamModel& model, const Scene& scene);

}  // namespace camopt

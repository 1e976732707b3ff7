// SPDX-License-Identifier: MIT
// From the optimizer's x to what is reported: the motion, its peaks, the cam, every limit.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// Fills motion, curve, segments, peaks, cam, constraints and design of the solution from x.
void report_motion(Solution& solution, const CamProblem& problem, const Eigen::VectorXd& x);

/// The spline of one stretch of a program, over x.
[[nodiscard]] SplineCurve stretch_curve(const MotionFamily& family, const SplineCurve& run, int stretch);

/// Which limits fight and where, from the rows of the proof of infeasibility.
void report_conflict(Solution& solution);

/// A limit on a largest value (sign +1) or a least one (−1), and what was reached.
[[nodiscard]] ConstraintReport limit_report(const WrittenLimit& limit, const CamExtreme& worst, int sign);

/// The cam of a motion with the figures of it, and the smallest any motion would allow where that is known.
[[nodiscard]] CamReport cam_report(const Scene& scene, const DiskCam& cam, const Motion& motion);

/// Every limit of the scene on the cam, as written and as kept by that cam.
[[nodiscard]] std::vector<ConstraintReport> cam_constraints(const Scene& scene, const CamReport& report);

}  // namespace camopt

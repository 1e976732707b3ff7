// SPDX-License-Identifier: MIT
// From the optimizer's x to what is reported: the motion, its peaks, the cam, every limit.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// report_delivered of the optimizer's x, and the design.
void report_motion(Solution& solution, const CamProblem& problem, const Eigen::VectorXd& x);

/// The scene of a solution that was found for one that poses the same problem: the spring that was chosen
/// stays.
void set_scene(Solution& solution, Scene scene);

/// Numbers that were searched too are entries of the design like any other, before the others.
void add_to_design(Solution& solution, std::vector<std::string> names, std::span<const double> values);

/// What a solve delivers: all that is reported of the motion and its cam follows from it and the scene. Of a
/// DRD or RR scene one spline, of a program one part a segment.
struct MotionAndCam {
    std::shared_ptr<const MotionChain> motion;
    std::vector<double> dimensions;  ///< of the scene's cam, in the order of scene.cam
};

/// Fills motion, curve, segments, peaks, cam and constraints of a solution that has its scene.
void report_delivered(Solution& solution, MotionAndCam delivered);

/// The part of a spline over [begin, end] of x, where the spline's own x is x + shift; both at breakpoints.
[[nodiscard]] SplineCurve part_of_run(const SplineCurve& run, double begin, double end, double shift);

/// Says that angles are the master's, where the motion has a phase.
void note_phase(Solution& solution);

/// Which limits fight and where, from the rows of the proof of infeasibility.
void report_conflict(Solution& solution);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Set points and regions of a scene beside what a motion makes of them, in the units they were written in.
#pragma once

#include "scene/motion/set_points.hpp"
#include "studies/delivered/solution.hpp"
#include "studies/laws/law_motion.hpp"

namespace camopt {

/// The motions of the solution's scene: those it was solved with, or made from the scene.
[[nodiscard]] std::shared_ptr<const MotionFamily> family_of(const Solution& solution);

/// One wanted number. A region's velocity is looked at along all of it: `found` is the farthest from it.
struct SetPointReport {
    PlacedPoint point;
    int order = 0;                      ///< of the derivative
    std::string key;                    ///< "motion.via[0].velocity_mm_s"
    std::string unit;                   ///< "mm/s"; empty: normalised
    double wanted = 0.0, found = 0.0;   ///< in the unit
    double at = 0.0;                    ///< x of `found`
    double distance = 0.0, size = 1.0;  ///< |found − wanted| and |wanted| of y^(order) over x of the motion
};

/// In the order of the scene. `degree`: of the motion's polynomials, by whose values a region is judged.
[[nodiscard]] std::vector<SetPointReport> set_point_reports(const MotionSpec& spec, int degree,
                                                            const Motion& motion);

/// The name a constraint on the derivative of this order has: "via_velocity".
[[nodiscard]] const char* set_point_name(int order);

/// A law of the catalogue in the place of a solution's motion; in a program on every spline segment, by its
/// own angle and between the displacements found. Throws InputError for an unknown law.
[[nodiscard]] LawMotion law_in_place(const Solution& solution, std::string_view law);

/// Fewer than twice as many rows as free numbers of the fit.
[[nodiscard]] bool follows_noise(const MeasuredReport& measured);
/// How much less than that of the measured motion the optimum's objective is, in percent of it; none where
/// there is nothing to compare: of noise, or of the very motion that is sought, none is better. The solution
/// has a measured motion.
[[nodiscard]] std::optional<double> gain_percent(const Solution& solution);

// What the elastic follower train makes of the delivered motion: terms and limits of the scene.

/// Fills `train` and appends the limits to constraints; nothing for a scene without dynamics.
void report_responses(Solution& solution);

/// Of any motion of the scene's kind. The scene has dynamics.
[[nodiscard]] TrainReport train_report(const Scene& scene, const Motion& motion);

/// The limits of the scene on its train, as the motion of the report keeps them.
[[nodiscard]] std::vector<ConstraintReport> response_constraints(const Scene& scene,
                                                                 const TrainReport& train);

/// Harmonics of a motion of the scene, whose spring has a natural frequency.
[[nodiscard]] SurgeReport surge_report(const Scene& scene, const Motion& motion);

// What a motion makes of the terms and limits that the program brought (scene/own_rule.hpp).

/// In the order of the scene.
[[nodiscard]] std::vector<OwnTermReport> own_term_reports(const Scene& scene, const Motion& motion);
[[nodiscard]] std::vector<ConstraintReport> own_constraints(const Scene& scene, const Motion& motion);

// The objective as scene files define it, of what is delivered: nothing of the optimizer's takes part.
//
//   Σ w_k P_k / P̂_k  +  Σ_d w_d |d| / unit
//
// over the peaks and root mean squares P of the motion, normalised as the scene says, and the cam's
// dimensions d. The tie-break is no part of it.

/// From solution.peaks, solution.reference_peaks and the delivered dimensions (without a cam: without them).
[[nodiscard]] double defined_objective(const Solution& solution);

}  // namespace camopt

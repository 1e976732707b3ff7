// SPDX-License-Identifier: MIT
// The last look at what is delivered, for every way it was found: is the published curve the motion that the
// verdict speaks of?
//
// From the published splines and dimensions alone: the splines are as smooth as their space says, and their
// coefficients give them back; the objective is what its definition makes of the curve, and that is what is
// reported; every condition and every limit of the scene is met. What is not so ends the verdict: `failed`,
// with a reason and a note that says what and where. Rounding is no fault; what counts as rounding is named
// here.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// A jump of y … y''' that is this much of the derivative's own peak is still the same motion for every
/// purpose. Where breakpoints lie very close (or are very many) y''' is a difference of nearly equal numbers
/// divided by the cube of their distance, and rounding alone makes it jump: peaks and limits of such a curve
/// are those of no motion of the space.
inline constexpr double largest_joint_jump = 1e-6;

/// The objective that a solver believes in and that of the curve may differ by this, relative, in sums that
/// are rounded differently.
inline constexpr double objective_rounding = 1e-9;

/// A condition that is met to this, relative, or to the tolerance of the solve, is met: projections onto the
/// conditions end in rounding.
inline constexpr double condition_rounding = 1e-9;

/// A figure of a cam that passes its limit by this, relative, is at the limit: rules are solved to the
/// tolerance of the solve in the form that is best to solve (tan φ, the curvature in place of its radius),
/// figures come from a search of their own between samples.
inline constexpr double figure_rounding = 1e-8;

/// The cam of a delivered motion has figures: its follower reaches all of the motion.
[[nodiscard]] bool cam_can_be_built(const Solution& solution);

/// Between which lifts motions leave a cam that can be built, where that of this one cannot be; infinite: a
/// side that it does not leave. None: not even a follower at rest has a cam.
[[nodiscard]] std::optional<std::array<double, 2>> buildable_reach(const Solution& solution);

/// Of a failed audit: pieces that do not meet, or that their coefficients do not give back, are no one
/// motion; no figure of them would be that of what is published, so nothing is delivered.
[[nodiscard]] constexpr bool is_no_motion(Reason reason) {
    return reason == Reason::breakpoints_too_close || reason == Reason::coefficients_too_coarse;
}

struct JointJump {
    double relative = 0.0;  ///< by the largest magnitude of that derivative, at the joints or (where it is
                            ///< small there) anywhere
    double at = 0.0;        ///< x
    int order = 0;
};

/// The worst jump of a derivative up to min(continuity, 3) at an interior breakpoint.
[[nodiscard]] JointJump worst_joint_jump(const SplineCurve& curve, const Peaks& motion = {});

/// A cost without a lost area is never negative: a bound below that says nothing, and goes with its proof;
/// but for one that an optimum rests on.
void drop_idle_bound(Certificate& certificate, const ObjectiveSpec& objective);

/// Sets the objective (and with it the gap) to that of the delivered curve. The verdict becomes `failed`
/// where the audit finds a fault: "breakpoints_too_close", "coefficients_too_coarse",
/// "objective_not_of_the_curve", "condition_not_met" or "limit_not_kept"; nothing is left of a proof then.
/// Where no motion was delivered there is no objective either.
void audit_delivered(Solution& solution);

/// The same of the motion of a given cam: violated limits are no fault of it. The verdict is `feasible` for
/// the reason given_cam, or `failed`.
void audit_given(Solution& solution);

/// Keys of the limits that the delivered motion or its cam violates by more than rounding, each once.
[[nodiscard]] std::vector<std::string> violated_limits(const Solution& solution);

/// Nothing is delivered: no motion, and nothing that was said of it.
void withdraw_motion(Solution& solution);

// Whether a delivered motion meets what its scene demands exactly: its ends and joints, the top of a rise and
// return, displacements of a program, exact points, symmetry, ends without jerk. From the motion alone,
// regardless of what the optimizer built in or eliminated.

/// A condition, and by how much the motion misses it.
struct ConditionMiss {
    std::string condition;  ///< in words: "y' = 1 at x = 0.5 (motion.via[0].velocity)"
    double relative = 0.0;  ///< by the larger of the wanted value and the derivative's peak (y: of 1)
    double at = 0.0;        ///< x
};

/// Those that are missed by more than `tolerance`, the worst first. Nothing where no motion was delivered.
[[nodiscard]] std::vector<ConditionMiss> missed_conditions(const Solution& solution, double tolerance);

}  // namespace camopt

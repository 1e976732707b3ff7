// SPDX-License-Identifier: MIT
// The limit no curve can pass: the least weighted peaks over all motions with bounded jerk.
//
//   min wV V + wA A + wJ J   over all curves y(x) of the kind with |y'| <= V, |y''| <= A, |y'''| <= J
//
// DRD (rest to rest, y'' = 0 at both ends). The quickest motion for given V, A, J is the seven-piece
// double-S:
//   1/V + V/A + A/J <= 1,   V²/A + VA/J <= 1,   A² <= VJ.
// RR (the rise ends in a turning point with free acceleration), with a = peak acceleration, d = deceleration:
//   1/V + V/(2a) + a/(2J) + V/(2d) + d³/(24 V J²) <= 1,   V/a + a/J + V/d + d/(2J) <= 1,
//   a² <= VJ,   d² <= 2VJ,   a <= A,   d <= A.
// With return ratio ρ = length - 1 != 1 the shorter half decides (the longer one may dwell): with τ = min(1,
// ρ) V = V1/τ, A = A1/τ², J = J1/τ³, where V1, A1, J1 belong to a half of length 1. Both are geometric
// programs. A weight of 0 without a cap is exact, no small weight: J, or A and J, are then infinite, their
// terms drop out, and the limit is approached by curves but reached by none.
//
// Normalised: x in units of the rise, y of the lift; w = weight / reference peak. Errors: a weight that is
// negative or not finite, all weights 0, a cap <= 0, a DRD length other than 1, an RR length <= 1:
// InputError. Source: double-S profiles, e.g. L. Biagiotti, C. Melchiorri, Trajectory Planning (2008),
// section 3.4.
#pragma once

#include "core/text/names.hpp"

namespace camopt {

struct AnyCurveLimitInput {
    MotionType type = MotionType::drd;
    double length = 1.0;                                             ///< DRD: 1; RR: 1 + return / rise
    double velocity_weight = 0.0;                                    ///< wV = α / V̂, >= 0
    double acceleration_weight = 0.0;                                ///< wA = β / Â, >= 0
    double jerk_weight = 0.0;                                        ///< wJ = γ / Ĵ, >= 0
    std::optional<double> velocity_cap, acceleration_cap, jerk_cap;  ///< > 0, on the normalised peaks

    void validate() const;
};

enum class AnyCurveStatus {
    reached,        ///< by a curve with bounded jerk
    approached,     ///< by curves whose jerk, or acceleration and jerk, grow without bound
    infeasible,     ///< no curve satisfies the caps
    not_converged,  ///< the numbers gave out; the objective is then 0, a limit that holds anyway
};

struct AnyCurveLimit {
    AnyCurveStatus status = AnyCurveStatus::not_converged;
    double objective = 0.0;  ///< +infinity where infeasible
    /// Peaks of the limit; none where infinite in the limit, infeasible or not converged.
    std::optional<double> velocity, acceleration, jerk;
    /// Reached: where a curve that reaches it switches its jerk, and its ends, in x, ascending (equal ones: a
    /// piece that vanishes). DRD: eight; y''' between them is J, 0, -J, 0, -J, 0, J. RR: the shorter stroke
    /// and its mirror image, twelve; J, 0, -J, 0, -J, 0, J, 0, J, 0, -J, and rest beside it where the other
    /// stroke is longer.
    std::vector<double> breakpoints;

    [[nodiscard]] bool feasible() const { return status != AnyCurveStatus::infeasible; }
};

[[nodiscard]] AnyCurveLimit any_curve_limit(const AnyCurveLimitInput& input);

}  // namespace camopt

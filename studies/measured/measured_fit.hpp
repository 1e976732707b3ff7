// SPDX-License-Identifier: MIT
// The motion of a family that is nearest to a measured one: least squares with the family's own conditions.
//
//   min over q:  (1/m) Σ_k (y(x_k; q) − s_k / lift)²  + ε ∫ y'''²   with   E q = e
//
// x_k = angle / unit angle. E: ends, continuity and all that the family demands. ε is far below what could be
// seen in y: it only picks the smoothest where the rows leave a part of the spline to itself.
#pragma once

#include "objectives/deviation_rules.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// Entries of the nearest motion. Throws InputError where there are fewer rows than free numbers.
[[nodiscard]] Eigen::VectorXd nearest_design(const MotionFamily& family, const Scene& scene);

/// The measured motion as a spline of the scene's space, without its set points, symmetry and limits: what
/// was measured need not keep them. `scene` has a measured motion.
[[nodiscard]] MeasuredReport measured_report(const Scene& scene, const Peaks& reference);

/// Of each stroke between given displacements. `turns_back`: strokes meet without a dwell.
[[nodiscard]] std::vector<LawMatch> nearest_laws(const MotionFamily& family, bool turns_back,
                                                 const std::vector<MeasuredRow>& rows);

/// Whether the search began from the measured motion, too: one from several starts does.
[[nodiscard]] bool began_from_measured(const Solution& solution);

}  // namespace camopt

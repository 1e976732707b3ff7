// SPDX-License-Identifier: MIT
// The energy of one segment whose ends move, with exact partials:
//
//   E = ∫_0^h (y^{(r)})² dτ = Σ_{m,l >= r} a_m a_l h^{m+l−2r+1} / ((m − r)! (l − r)! (m + l − 2r + 1)),
//   dE/dh = y^{(r)}(h)².
#pragma once

#include "splines/free_knot_form.hpp"

#include <Eigen/Core>

namespace camopt {

/// Partials by a_{i,r} … a_{i,p}, t_i, t_{i+1} (also where an end is fixed).
struct SegmentEnergy {
    double value = 0.0;
    Eigen::VectorXd slope;
    Eigen::MatrixXd curvature;
};

[[nodiscard]] SegmentEnergy segment_energy(const FreeKnotForm& form, const Eigen::VectorXd& x, int segment,
                                           int order);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A solution made by hand: the best cubic spline of four segments, known in closed form.
//   y''' = 32, −32, −32, 32:  V = 2 at x = 1/2, A = 8 at x = 1/4, J = 32.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt::test {

/// DRD, lift 10 mm, rise 90 deg, 300 rpm, references 1.76, 5.53, 69, proof of two rows.
[[nodiscard]] Solution sample_solution();

/// The same with a translating roller: base radius 30 mm, roller 10 mm, pressure angle limit 30 deg, 2 kg on
/// a spring of 10 N/mm with 60 N, contact 8 mm wide.
[[nodiscard]] Solution cam_solution();

/// Its cam with a base radius of 5 mm and a roller of 30 mm, which is too large: undercut.
[[nodiscard]] Solution undercut_solution();

/// A whole turn without a cam: dwell 60 deg, the spline above over 90 deg, dwell 165 deg, modified sine back
/// over 45 deg. Its law is twice as steep as its spline: V of the motion is 3.52 in units of the first
/// spline segment.
[[nodiscard]] Solution program_solution();

/// A cam whose pressure angle and cam radius limits fight: no motion, conflict, relaxation.
[[nodiscard]] Solution infeasible_cam_solution();

/// The same scene with a cap that cannot be satisfied: no curve, a relaxation.
[[nodiscard]] Solution infeasible_solution();

}  // namespace camopt::test

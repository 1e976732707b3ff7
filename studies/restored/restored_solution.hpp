// SPDX-License-Identifier: MIT
// A delivered result made whole again, without solving: the scene and the record of its result give the
// Solution that was written.
//
// Motion and dimensions are those of the record, bit for bit. What follows from them and the scene (peaks,
// the cam's figures, what limits reach, the references) is made by the functions that a solve uses. What
// tells of the run (solver, evaluations, seconds, notes, design vector, forward check) is the record's. The
// certificate stands in a file of its own and is set by who reads it; the peaks of the limit of any curve are
// not kept.
#pragma once

#include "studies/delivered/result_record.hpp"

namespace camopt {

/// Of a record without a motion what a solve says of the scene without one; what it found out about changes
/// (relaxation, explanation, conflict) is not in a record and left empty.
///
/// The scene must have the formulas of its mechanism. Throws InputError where the record is no motion of this
/// scene: parts that do not fit its segments, dimensions that its cam has not or fixes otherwise.
[[nodiscard]] Solution restored_solution(const Scene& scene, const ResultRecord& record);

}  // namespace camopt

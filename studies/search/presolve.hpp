// SPDX-License-Identifier: MIT
// Presolve: what is infeasible before anything is searched, and its proof: conditions on the motion that
// cannot be met together, and a limit that is violated where every motion of the scene rests, at a
// displacement the scene itself gives, with s' = 0.
#pragma once

#include "objectives/rules/model.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// Notes the conditions that follow from others.
void report_redundant(Solution& solution, const MotionFamily& family);

/// Sets verdict, proof and notes of a family that has contradictions.
void report_contradictions(Solution& solution, const MotionFamily& family);

struct RestConflict {
    std::string key;  ///< of the limit
    KnownPoint where;
    double violation = 0.0;  ///< relative to the limit
    RowFields fields = {};   ///< of the violated row; without a key: that of the limit
};

/// The worst one. Only limits that are not convex (the others are proved by duality), know no higher
/// derivative than s' and have no dimension to move.
[[nodiscard]] std::optional<RestConflict> rest_conflict(const CamModel& model, double tolerance);

/// True: the solution is infeasible, and says by which limit and where.
[[nodiscard]] bool report_rest_conflict(Solution& solution, const CamModel& model);

/// Of a case of directions that the given displacements contradict (contradicting_directions).
void report_contradicted_case(Solution& solution, const std::string& key, double apart);

// A prescribed motion (MotionSpec::prescribed): only the dimensions of its cam may be free.

/// The rules that no free dimension has a say in are judged and leave the model. True: the motion breaks one
/// of them, and the solution is infeasible.
[[nodiscard]] bool settle_prescribed(Solution& solution, CamModel& model);

/// Of a model without variables: the only motion there is, proved by that.
[[nodiscard]] Certificate certificate_of_constant(const CamModel& model);

}  // namespace camopt

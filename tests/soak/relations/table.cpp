// SPDX-License-Identifier: MIT
// The table of the relations. A new one: its function, its line here.
#include "tests/soak/relations/relation.hpp"

namespace camopt::soak {

namespace {

constexpr Check check_rows[] = {
    {"accepted", "a valid scene is read and solved without an exception", check_accepted},
    {"written", "the scene that was read, written and read again, is the same in every bit", check_written},
    {"json", "both texts can be read, hold no NaN, and no number is missing that the verdict needs",
     check_json},
    {"time", "solver.max_seconds is kept within 10 %", check_time},
    {"peaks", "published peaks are those of the published knots and coefficients", check_peaks},
    {"objective", "the objective is its definition of the published curve", check_objective},
    {"conditions", "ends, top, exact points, symmetry and given displacements are met", check_conditions},
    {"joints", "y, y', y'' and what else is promised are continuous", check_joints},
    {"caps", "no peak passes its cap", check_caps},
    {"bound", "no bound above its objective; optimal means a gap within solver.gap", check_bound},
    {"proof", "the bound follows from the numbers of certificate.json", check_proof},
    {"infeasibility", "the proof that there is no motion follows from certificate.json", check_infeasibility},
    {"cam_figures", "published figures of the cam follow from its geometry", check_cam_figures},
    {"cam_limits", "the geometry, the forces and an elastic follower satisfy every limit", check_cam_limits},
    {"reported_limits", "the worst value reported of a limit is the true one", check_reported_limits},
    {"dimensions", "delivered dimensions lie in their ranges", check_dimensions},
};

constexpr Comparison comparison_rows[] = {
    {"refined", "more breakpoints among the old ones: never worse", compare_refined},
    {"smoothness", "less continuity, or a higher degree of the same continuity: never worse",
     compare_smoothness},
    {"freed", "free breakpoints: never worse than those they start from", compare_freed},
    {"hurried", "many more segments in little time: the time is kept, no bound is too high", compare_hurried},
    {"dropped_condition", "without one condition: never worse", compare_dropped_condition},
    {"loosened", "one limit loosened: never worse", compare_loosened},
    {"tightened", "one limit tightened: never better", compare_tightened},
    {"own_figures", "caps at what the optimum itself reaches: the same", compare_own_figures_as_caps},
    {"least_caps", "caps about the least possible: kept above it, no motion below it", compare_least_caps},
    {"lift", "all lengths scaled: the same", compare_lift},
    {"angle", "all angles of a motion scaled: the same", compare_angle},
    {"units", "other units: the same", compare_units},
    {"weights", "a common factor on all weights: the same motion", compare_weights},
    {"references", "a factor on a reference and its weight: the same", compare_references},
    {"speed", "twice the speed with a quarter of the mass: the same", compare_speed},
    {"reversed", "time reversed: the same", compare_reversed},
    {"mirrored", "mirror image (rotation and offset): the same", compare_mirrored},
    {"solvers", "another solver: the same", compare_solvers},
    {"designs", "another design vector of the same space: the same", compare_designs},
    {"repeated", "the same call twice: the same in every digit", compare_repeated},
    {"relaxed", "a relaxation with a margin has a motion, with less it has none", compare_relaxed},
    {"dimension_ranges", "a wider range of a dimension: never worse; fixed at the found value: no better",
     compare_dimension_ranges},
};

}  // namespace

std::span<const Check> checks() {
    return check_rows;
}
std::span<const Comparison> comparisons() {
    return comparison_rows;
}

}  // namespace camopt::soak

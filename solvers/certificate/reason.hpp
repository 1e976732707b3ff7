// SPDX-License-Identifier: MIT
// Why a verdict is not better than it is, each with the word that files and messages have for it.
#pragma once

#include "solvers/solver.hpp"

#include <iosfwd>
#include <string_view>

namespace camopt {

enum class Reason {
    none,  ///< "": nothing is missing
    // How the search ended: as Termination.
    not_run,
    converged,
    acceptable,
    infeasible,
    unbounded,
    iteration_limit,
    time_limit,
    interrupted,
    numerical_failure,
    evaluation_error,
    unsupported,
    // What is known of the scene.
    no_feasible_point,       ///< nothing that keeps the limits was found, and no proof that there is nothing
    limits_contradict,       ///< proved: no motion keeps them
    conditions_contradict,   ///< no curve of the spline space meets all the conditions
    limit_broken_at_rest,    ///< a limit is broken where the follower stands
    limits_within_rounding,  ///< "limits_within_rounding_of_infeasible": of such a point nothing is proved
    // How far the proof came.
    stationary,          ///< "stationary, not proved optimal"
    free_displacements,  ///< the search over free displacements left a gap
    free_angles,         ///< the search over the angles of a program left a gap
    // What the delivered motion failed by.
    breakpoints_too_close,
    coefficients_too_coarse,
    condition_not_met,
    cam_cannot_be_built,
    limit_not_kept,
    objective_not_of_the_curve
};

/// The word in files and messages, as in the comments above where it is not the name.
[[nodiscard]] const char* name_of(Reason value);
/// The reason of this name; throws InputError for a word that is none.
[[nodiscard]] Reason reason_named(std::string_view name);
/// A search that ended like this is the reason.
[[nodiscard]] Reason reason_of(Termination termination);

/// By its word.
[[nodiscard]] inline bool operator==(Reason value, std::string_view name) {
    return name == name_of(value);
}
std::ostream& operator<<(std::ostream& stream, Reason value);

}  // namespace camopt

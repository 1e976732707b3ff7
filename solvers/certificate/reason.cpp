// SPDX-License-Identifier: MIT
#include "solvers/certificate/reason.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <array>
#include <ostream>

namespace camopt {
namespace {

struct Named {
    Reason reason;
    const char* name;
};

constexpr std::array named_reasons = {
    Named{Reason::none, ""},
    Named{Reason::not_run, "not_run"},
    Named{Reason::converged, "converged"},
    Named{Reason::acceptable, "acceptable"},
    Named{Reason::infeasible, "infeasible"},
    Named{Reason::unbounded, "unbounded"},
    Named{Reason::iteration_limit, "iteration_limit"},
    Named{Reason::time_limit, "time_limit"},
    Named{Reason::interrupted, "interrupted"},
    Named{Reason::numerical_failure, "numerical_failure"},
    Named{Reason::evaluation_error, "evaluation_error"},
    Named{Reason::unsupported, "unsupported"},
    Named{Reason::no_feasible_point, "no_feasible_point"},
    Named{Reason::limits_contradict, "limits_contradict"},
    Named{Reason::conditions_contradict, "conditions_contradict"},
    Named{Reason::limit_broken_at_rest, "limit_broken_at_rest"},
    Named{Reason::limits_within_rounding, "limits_within_rounding_of_infeasible"},
    Named{Reason::stationary, "stationary, not proved optimal"},
    Named{Reason::free_displacements, "free_displacements"},
    Named{Reason::free_angles, "free_angles"},
    Named{Reason::breakpoints_too_close, "breakpoints_too_close"},
    Named{Reason::coefficients_too_coarse, "coefficients_too_coarse"},
    Named{Reason::condition_not_met, "condition_not_met"},
    Named{Reason::cam_cannot_be_built, "cam_cannot_be_built"},
    Named{Reason::limit_not_kept, "limit_not_kept"},
    Named{Reason::objective_not_of_the_curve, "objective_not_of_the_curve"},
};

}  // namespace

const char* name_of(Reason value) {
    return named_reasons[static_cast<std::size_t>(value)].name;
}

Reason reason_named(std::string_view name) {
    for (const Named& row : named_reasons)
        if (name == row.name) return row.reason;
    std::string allowed;
    for (const Named& row : named_reasons)
        if (row.reason != Reason::none)
            allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : ", ", row.name);
    throw InputError(fmt::format("reason: found \"{}\"; allowed: {}", name, allowed));
}

Reason reason_of(Termination termination) {
    return reason_named(name_of(termination));
}

std::ostream& operator<<(std::ostream& stream, Reason value) {
    return stream << name_of(value);
}

}  // namespace camopt

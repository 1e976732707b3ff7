// SPDX-License-Identifier: MIT
#include "tests/soak/relations/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

/// Two solves agree this far: the gaps of convex scenes (1e-7 each) and what the tolerance of the limits is
/// worth.
constexpr double agreement = 1e-6;

bool found_motion(const Outcome& outcome) {
    return outcome.has_motion() && outcome.verdict != "failed" && outcome.objective;
}

}  // namespace

double scale_of(double value) {
    return std::max(1.0, std::abs(value));
}

bool ended_early(const Outcome& outcome) {
    return outcome.termination == "time_limit" || outcome.reason == "time_limit" || !outcome.refusal.empty();
}

Finding never_worse(const Outcome& loose, const Outcome& tight, double factor) {
    if (!loose.refusal.empty() || !tight.refusal.empty()) return no_case;
    if (!found_motion(tight)) return holds;
    if (loose.verdict == "infeasible")
        return fmt::format("infeasible, but the tighter scene is {} with {:.12g}", tight.verdict,
                           factor * *tight.objective);
    const double objective = factor * *tight.objective;
    const double slack = agreement * std::max(std::abs(factor), scale_of(objective));
    if (loose.lower && *loose.lower > objective + slack)
        return fmt::format("bound {:.12g} above the objective {:.12g} of the tighter scene ({})",
                           *loose.lower, objective, tight.verdict);
    if (!tight.is_proved() || ended_early(loose)) return holds;
    if (loose.verdict == "failed")
        return fmt::format("failed ({}), but the tighter scene is optimal with {:.12g}", loose.reason,
                           objective);
    if (!loose.is_proved() || !loose.objective) return holds;
    const double unproved = loose.gap.value_or(0.0) * scale_of(*loose.objective);
    if (*loose.objective > objective + slack + unproved)
        return fmt::format("{:.12g}, but the tighter scene has {:.12g}", *loose.objective, objective);
    return holds;
}

Finding same_answer(const Outcome& left, const Outcome& right, double factor) {
    const Finding one = never_worse(left, right, 1.0 / factor);
    const Finding other = never_worse(right, left, factor);
    if (!one || !other) return no_case;
    if (!one->empty()) return "the first scene: " + *one;
    if (!other->empty()) return "the second scene: " + *other;
    return holds;
}

}  // namespace camopt::soak

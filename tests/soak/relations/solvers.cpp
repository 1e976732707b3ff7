// SPDX-License-Identifier: MIT
// Other ways to the same answer: another solver, another design vector, the same call again.
#include "tests/soak/relations/relation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::soak {

namespace {

/// Up to where a dense solver is quick.
constexpr int most_dense_segments = 14;

/// Where two texts part, with a few letters about it.
std::string parting(const std::string& left, const std::string& right) {
    const auto [one, other] = std::ranges::mismatch(left, right);
    const auto at = static_cast<std::size_t>(one - left.begin());
    const std::size_t begin = at < 60 ? 0 : at - 60;
    return fmt::format("…{}… and …{}…", left.substr(begin, 90), right.substr(begin, 90));
}

}  // namespace

Finding compare_solvers(Trial& trial) {
    std::vector<std::string> others;
    for (const std::string& name : available_solvers()) {
        const bool dense = name == "nlopt.slsqp" && trial.numbers().spline_segments <= most_dense_segments &&
                           trial.numbers().breakpoints.size() <= most_dense_segments;
        if ((name == "structured" || name == "ipopt" || dense) && name != trial.base().outcome.solver)
            others.push_back(name);
    }
    if (others.empty()) return no_case;
    const std::string name = trial.draw().one_of(others);
    SceneText other = trial.text();
    other.at("solver").set("name", quoted(name));
    const Solved solved = trial.solve(other);
    // A rival that gives up claims nothing.
    if (name.starts_with("nlopt") && solved.outcome.verdict == "failed") return holds;
    const Finding found = same_answer(trial.base().outcome, solved.outcome);
    return found && !found->empty() ? Finding(name + ": " + *found) : found;
}

Finding compare_designs(Trial& trial) {
    const SceneNumbers& numbers = trial.numbers();
    std::vector<std::string> others = {"coefficients", "states"};
    if (numbers.continuity == numbers.degree - 1) others.push_back("ordinates");
    std::erase(others, trial.base().outcome.design);
    const std::string design = trial.draw().one_of(others);
    SceneText other = trial.text();
    other.at("spline").set("design", quoted(design));
    const Finding found = same_answer(trial.base().outcome, trial.solve(other).outcome);
    return found && !found->empty() ? Finding(design + ": " + *found) : found;
}

Finding compare_repeated(Trial& trial) {
    const Outcome& first = trial.base().outcome;
    const Solved again = trial.solve(trial.text());
    // Time decides then, and time is never the same.
    const double half = 0.4 * trial.numbers().max_seconds;
    for (const Outcome* one : {&first, &again.outcome})
        if (ended_early(*one) || !one->unsettled.empty() || one->wall_seconds > half) return no_case;
    if (first.repeatable == again.outcome.repeatable) return holds;
    return parting(first.repeatable, again.outcome.repeatable);
}

}  // namespace camopt::soak

// SPDX-License-Identifier: MIT
#include "report/words/plan_text.hpp"

#include "report/view/number_text.hpp"
#include "report/words/solution_text.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

std::string counted(int count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string searched_line(const SolvePlan& plan) {
    std::vector<std::string> parts;
    if (!plan.prescribed) parts.emplace_back("the motion");
    if (plan.displacements > 0) parts.push_back(counted(plan.displacements, "free displacement"));
    if (plan.dimensions > 0) parts.push_back(counted(plan.dimensions, "dimension") + " of the cam");
    if (plan.breakpoints > 0) parts.push_back(counted(plan.breakpoints, "breakpoint"));
    if (plan.angles > 0) parts.push_back("the angles of " + counted(plan.angles, "segment"));
    if (parts.empty()) return "Searched: nothing, the motion is prescribed";
    return fmt::format("Searched: {}", fmt::join(parts, ", "));
}

std::string starts_sentence(const SolvePlan& plan) {
    if (plan.breakpoints > 0)
        return fmt::format(
            "first on the given breakpoints, then the structured solver moves them from at most {}: the "
            "given ones, then random ones (seed {})",
            counted(plan.starts, "start"), plan.seed);
    return fmt::format(
        "a convex relaxation first ({}), then the best of at most {}: {}its optimum, the smoothest motion, "
        "random ones (seed {})",
        plan.relaxations.size() > 1
            ? "without the limits that are not convex, then with those that are for sensible displacements"
            : "without the limits that are not convex",
        counted(plan.starts, "start"), plan.from_measured ? "the measured motion, " : "", plan.seed);
}

std::string verdict_sentence(const SolvePlan& plan) {
    if (plan.contradiction) return "its conditions contradict each other: infeasible, proved";
    if (plan.breakpoints > 0)
        return fmt::format(
            "{}local or feasible; infeasibility is not proved",
            plan.proof == ProofKind::none ? "" : "optimal if the limit of any curve is reached, else ");
    if (plan.angles > 0)
        return fmt::format(
            "{}{}",
            plan.proof == ProofKind::boxes ? "optimal or infeasible if the boxes prove it, else " : "",
            plan.angles == 2 ? "local or feasible" : "feasible");
    if (plan.proof == ProofKind::boxes)
        return "optimal or infeasible if the relaxation or a bound over boxes proves it, else local or "
               "feasible with a bound";
    if (plan.proof == ProofKind::none) return "local or feasible, without a bound";
    return plan.reason.empty() && plan.solver != "structured"
               ? fmt::format("optimal or infeasible, both with a proof; if {} fails, feasible", plan.solver)
               : "optimal or infeasible, both with a proof";
}

}  // namespace

std::vector<std::string> plan_lines(const SolvePlan& plan) {
    std::vector<std::string> lines = {searched_line(plan)};
    if (plan.prescribed && plan.dimensions == 0)
        lines.push_back("Solved: by no solver, " +
                        no_solver_words(plan.reason.empty() ? plan.solver : "auto"));
    else
        lines.push_back(fmt::format("Solved: {}by {} ({}), design vector: {}, at most {} s",
                                    plan.relaxations.empty() || plan.solver == "structured"
                                        ? ""
                                        : "by structured where the convex relaxation decides, else ",
                                    plan.solver, plan.reason.empty() ? "named in the scene" : "chosen",
                                    name_of(plan.design), short_text(plan.seconds)));
    if (!plan.reason.empty()) lines.push_back("Reason: " + plan.reason);
    if (plan.angles > 0)
        lines.push_back(
            fmt::format("Angles: each set of angles that is tried is solved by its own plan; boxes of angles "
                        "are {}bounded",
                        plan.proof == ProofKind::boxes ? "" : "not "));
    if (!plan.relaxations.empty() || plan.breakpoints > 0) lines.push_back("Steps: " + starts_sentence(plan));
    if (plan.strokes_first_free)
        lines.emplace_back(
            "Strokes: rules of motion.within_lift and motion.monotone are added if the motion leaves a "
            "range");
    if (!plan.next_solver.empty())
        lines.push_back(fmt::format("Without a {}: {} is tried next",
                                    plan.relaxations.empty() ? "proof" : "motion", plan.next_solver));
    if (plan.cost_scale != 1.0)
        lines.push_back(fmt::format("Scale: the objective is divided by {} while it is solved",
                                    short_text(plan.cost_scale)));
    if (plan.tie_break) lines.emplace_back("Ties: of equal optima the smoothest motion");
    lines.push_back("Expected verdict: " + verdict_sentence(plan));
    if (plan.explain_seconds > 0.0)
        lines.push_back(fmt::format("Without a motion: changes that help are searched for at most {} s",
                                    short_text(plan.explain_seconds)));
    return lines;
}

}  // namespace camopt

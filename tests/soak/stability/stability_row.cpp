// SPDX-License-Identifier: MIT
#include "tests/soak/stability/stability_row.hpp"

#include "core/errors.hpp"
#include "solvers/registry.hpp"
#include "tests/soak/relations/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace camopt::stability {

namespace {

// Reported and recomputed objective are the same sum of the same peaks: only their rounding may differ.
constexpr double same_number = 1e-11;

void fail(StabilityRow& row, const std::string& why) {
    row.judgement = Judgement::wrong;
    row.why += (row.why.empty() ? "" : "; ") + why;
}

bool is_finite(double value) {
    return std::isfinite(value);
}

/// The bound must not pass the truth.
void judge_bound(StabilityRow& row, const soak::Outcome& outcome) {
    const auto& most = row.expected.most;
    // A motion may use its tolerance; the truth of limits that are kept exactly is no lower.
    if (outcome.lower && most && *outcome.lower > *most + std::abs(*most) * (row.expected.digits + 1e-9))
        fail(row, fmt::format("the proved bound {} passes the truth", *outcome.lower));
}

void judge_motion(StabilityRow& row, const soak::Solved& solved) {
    row.found = static_cast<double>(objective_of(solved.numbers, solved.figures, solved.dimensions));
    soak::Miss worst = missed_conditions(solved);
    worst.note(largest_jump(solved, 0, 2));
    worst.note(passed_caps(solved));
    worst.note(passed_follower_limits(solved));
    row.violation = static_cast<double>(worst.amount);
    row.jerk_jump = static_cast<double>(largest_jump(solved, 3, 3).amount);
    if (!is_finite(*row.found)) return fail(row, "the objective is not finite");
    const double reported = solved.outcome.objective.value_or(HUGE_VAL);
    if (!(std::abs(reported - *row.found) <= same_number * std::abs(*row.found) + row.expected.rounding))
        fail(row, fmt::format("reported objective {} is not that of the motion", reported));
    if (!(*row.violation <= row.expected.violation))
        fail(row, fmt::format("violated by {:.2g}: {}", *row.violation, worst.what));
}

void judge_verdict(StabilityRow& row, const soak::Outcome& outcome) {
    row.verdict = outcome.verdict;
    row.reason = outcome.reason;
    row.gap = outcome.gap;
    if (std::ranges::any_of(row.expected.verdicts,
                            [&](Verdict verdict) { return outcome.verdict == name_of(verdict); }))
        return;
    const bool weaker =
        outcome.verdict == "local" || outcome.verdict == "feasible" || outcome.verdict == "failed";
    if (!weaker || outcome.reason.empty())
        return fail(row, fmt::format("verdict {} {}", row.verdict, row.reason));
    row.judgement = Judgement::unsolved;
    row.why = row.reason;
}

}  // namespace

const char* name_of(Judgement value) {
    switch (value) {
        case Judgement::ok:
            return "ok";
        case Judgement::unsolved:
            return "unsolved";
        case Judgement::wrong:
            return "wrong";
        case Judgement::absent:
            return "absent";
    }
    return "";
}

Expectation exactly(double objective, std::string source, double accuracy) {
    Expectation expected;
    expected.least = expected.most = objective;
    expected.accuracy = accuracy;
    expected.source = std::move(source);
    return expected;
}

Expectation at_most(double value, std::string source) {
    Expectation expected;
    expected.most = value;
    expected.accuracy = 0.0;
    expected.source = std::move(source);
    return expected;
}

bool is_available(const std::string& backend) {
    return backend == "auto" || std::ranges::any_of(solver_entries(), [&](const SolverEntry& entry) {
               return entry.name == backend && entry.available;
           });
}

void judge_objective(StabilityRow& row, double gap_asked) {
    const Expectation& expected = row.expected;
    if (!row.found) return;
    if (!is_finite(*row.found)) return fail(row, row.quantity + " is not finite");
    double allowed = expected.accuracy + expected.digits;
    if (expected.honest_gap) allowed += gap_asked;
    if (row.judgement == Judgement::unsolved) allowed += row.gap.value_or(HUGE_VAL);
    if (expected.least) {
        const double low = (*expected.least - *row.found) / std::abs(*expected.least);
        if (low > expected.accuracy + expected.digits) fail(row, fmt::format("too small by {:.2g}", low));
        row.relative_error = -std::max(low, 0.0);
    }
    if (expected.most) {
        const double scale = *expected.most == 0.0 ? 1.0 : std::abs(*expected.most);
        const double high = (*row.found - *expected.most) / scale;
        if (high > allowed) fail(row, fmt::format("too large by {:.2g}", high));
        if (high > 0.0 || !expected.least) row.relative_error = std::max(high, 0.0);
    }
}

StabilityRow solved_row(const SceneText& scene, const Expectation& expected) {
    StabilityRow row;
    row.backend = scene.word("solver", "name", "auto");
    row.expected = expected;
    if (!is_available(row.backend)) {
        row.judgement = Judgement::absent;
        row.why = "not in this build";
        return row;
    }
    try {
        const soak::Solved solved = soak::solved_from(scene, soak::Scope::memory);
        const soak::Outcome& outcome = solved.outcome;
        row.scene = scene.text();
        row.solution = outcome.solution;
        row.seconds = outcome.wall_seconds;
        if (outcome.refusal.empty()) judge_verdict(row, outcome);
        // `failed` claims nothing about the motion beside it.
        if (solved.motion && outcome.verdict != "failed") judge_motion(row, solved);
        judge_objective(row, solved.numbers.gap.value_or(1e-7));
        judge_bound(row, outcome);
        for (const soak::Check& check : soak::checks())
            if (const soak::Finding found = check.of(solved); found && !found->empty())
                fail(row, fmt::format("{}: {}", check.name, *found));
    } catch (const std::exception& error) {
        fail(row, error.what());
    }
    return row;
}

StabilityRow figure_row(std::string quantity, double found, const Expectation& expected) {
    StabilityRow row;
    row.quantity = std::move(quantity);
    row.expected = expected;
    row.expected.verdicts.clear();
    row.found = found;
    judge_objective(row, 0.0);
    return row;
}

StabilityRow refused_row(const std::function<void()>& attempt, std::string source) {
    StabilityRow row;
    row.quantity = "refusal";
    row.expected.verdicts.clear();
    row.expected.source = std::move(source);
    try {
        attempt();
        fail(row, "not refused");
    } catch (const InputError& error) {
        row.reason = error.what();
    }
    return row;
}

}  // namespace camopt::stability

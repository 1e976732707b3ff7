// SPDX-License-Identifier: MIT
#include "benchmarks/stability/stability_row.hpp"

#include "benchmarks/stability/motion_audit.hpp"
#include "core/errors.hpp"
#include "solvers/registry.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
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

/// The proof's own numbers must give the bound, and the bound must not pass the truth.
void judge_proof(StabilityRow& row, const Certificate& certificate) {
    if (!certificate.lower_bound) return;
    const double bound = *certificate.lower_bound;
    if (!is_finite(bound)) fail(row, "the bound is not finite");
    if (certificate.proof && certificate.proof->statement == "objective" &&
        recomputed_bound(*certificate.proof) < bound - 1e-13 * std::abs(bound))
        fail(row, "the stored proof gives less than its bound");
    const auto& most = row.expected.most;
    // A motion may use its tolerance; the truth of limits that are kept exactly is no lower.
    if (most && bound > *most + std::abs(*most) * (row.expected.digits + 1e-9))
        fail(row, fmt::format("the proved bound {} passes the truth", bound));
}

void judge_motion(StabilityRow& row, const Solution& solution) {
    const MotionAudit report = audit(solution);
    const Certificate& certificate = solution.certificate;
    row.found = static_cast<double>(report.objective);
    row.violation = static_cast<double>(report.violation);
    row.jerk_jump = static_cast<double>(report.jerk_jump);
    if (!is_finite(*row.found)) return fail(row, "the objective is not finite");
    const double difference = std::abs(certificate.objective - *row.found);
    if (!(difference <= same_number * std::abs(*row.found) + row.expected.rounding))
        fail(row, fmt::format("reported objective {} is not that of the motion", certificate.objective));
    if (!(*row.violation <= row.expected.violation))
        fail(row, fmt::format("violated by {:.2g}: {}", *row.violation, report.worst));
    if (!(*row.jerk_jump <= largest_joint_jump))
        fail(row, fmt::format("y''' jumps by {:.2g}", *row.jerk_jump));
    if (certificate.gap && certificate.verdict == Verdict::optimal &&
        !(*certificate.gap <= solution.scene.solver.wanted_gap(solution.solver.convex)))
        fail(row, "called optimal with a larger gap than asked for");
}

void judge_verdict(StabilityRow& row, const Certificate& certificate) {
    row.verdict = name_of(certificate.verdict);
    row.reason = name_of(certificate.reason);
    row.gap = certificate.gap;
    if (std::ranges::find(row.expected.verdicts, certificate.verdict) != row.expected.verdicts.end()) return;
    const bool weaker = certificate.verdict == Verdict::local || certificate.verdict == Verdict::feasible ||
                        certificate.verdict == Verdict::failed;
    if (!weaker || certificate.reason == Reason::none)
        return fail(row, fmt::format("verdict {} {}", row.verdict, row.reason));
    row.judgement = Judgement::unsolved;
    row.why = row.reason;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
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

StabilityRow solved_row(const Scene& scene, const Expectation& expected) {
    StabilityRow row;
    row.backend = scene.solver.name;
    row.expected = expected;
    if (!is_available(scene.solver.name)) {
        row.judgement = Judgement::absent;
        row.why = "not in this build";
        return row;
    }
    const auto begin = std::chrono::steady_clock::now();
    try {
        const Solution& solution = row.solution.emplace(solve_without_explaining(scene, {}));
        row.seconds = seconds_since(begin);
        judge_verdict(row, solution.certificate);
        // `failed` claims nothing about the motion beside it.
        if (solution.motion && solution.certificate.verdict != Verdict::failed) judge_motion(row, solution);
        judge_objective(row, scene.solver.wanted_gap());
        judge_proof(row, solution.certificate);
    } catch (const std::exception& error) {
        row.seconds = seconds_since(begin);
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

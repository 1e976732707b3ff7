// SPDX-License-Identifier: MIT
#include "studies/search/convex_solve.hpp"

#include "solvers/registry.hpp"
#include "solvers/structured/structured_options.hpp"
#include "studies/search/planned_run.hpp"

namespace camopt {

namespace {

// A proof that comes at all comes within these; where doubles end, more of either only take time.
constexpr int most_rounds_of_next = 20, most_iterations_of_next = 200;
// Of a small gap: what closes it at all does so at once.
constexpr double nearly_proved = 1e-4, share_where_nearly_proved = 0.05;
constexpr long long long_patience = 60;

/// Keeps the better of two results: what proves more, of what does not the motion of the least objective with
/// the largest bound of either. Whether it is the motion of `other`.
bool keep_better(ContinuousResult& result, ContinuousResult other, const JudgeOptions& judge) {
    result.seconds += other.seconds;
    other.seconds = result.seconds;  // of both attempts, whichever is kept
    if (is_proved(result.certificate)) return false;
    const bool takes = is_better(other.certificate, result.certificate, judge.gap);
    if (takes) std::swap(result, other);
    Certificate& kept = result.certificate;
    // Its bound is one for all motions that are no worse than its own, and says nothing of one that is better
    // since it violates limits.
    Certificate& left = other.certificate;
    if (is_proved(kept) || result.x.size() == 0 || !left.proof || is_relaxed(left) || is_relaxed(kept) ||
        left.lower_bound <= kept.lower_bound ||
        bound_passes(kept.objective, *left.lower_bound, judge.tolerance) ||
        !(kept.objective <= left.objective))
        return takes;
    kept.lower_bound = left.lower_bound;
    kept.gap = relative_gap(kept.objective, *left.lower_bound);
    kept.proof = std::move(left.proof);
    kept.proof_kind = left.proof_kind;
    result.proof_source = std::move(other.proof_source);
    settle_verdict(kept, result.exchange.termination, judge);
    return takes;
}

/// Problems whose numbers are hard: another backend tries from the same grid. Where only the tolerance gives
/// room none finds more.
void try_next_solver(const ConvexRun& run, ExchangeOptions exchange, ContinuousResult& result,
                     NextSolver& next) {
    const Certificate& found = result.certificate;
    if (run.next_solver.empty() || is_proved(found) || is_relaxed(found) || run.control.ending()) return;
    exchange.backend.native.clear();  // they belong to the first backend
    exchange.backend.max_iterations = std::min(exchange.backend.max_iterations, most_iterations_of_next);
    exchange.most_rounds = std::min(exchange.most_rounds, most_rounds_of_next);
    next.reason = found.reason;
    ContinuousResult other =
        solve_continuous(run.problem, *make_solver(run.next_solver), exchange, run.judge, run.control);
    next.found = keep_better(result, std::move(other), run.judge);
}

/// With finer and more patient steps, then with exact ones, from the same grid. Each ends at the first
/// failure; where little is missing, or another backend follows, all together take a share of the time.
void try_harder(const ConvexRun& run, ExchangeOptions exchange, ContinuousResult& result) {
    const bool is_near = result.certificate.gap.value_or(infinity) <= nearly_proved;
    const double share = is_near ? share_where_nearly_proved : run.next_solver.empty() ? 1.0 : share_of_first;
    const SolveControl timed = run.control.sooner(share * run.control.deadline.seconds_left());
    exchange.backend.has_optimum = result.inside.violation <= 0.0;  // the first attempt found no ray
    const auto proves = [&](const ExchangeOptions& options) {
        if (is_proved(result.certificate) || timed.ending()) return true;
        keep_better(result, solve_continuous(run.problem, run.solver, options, run.judge, timed), run.judge);
        return is_proved(result.certificate);
    };
    ExchangeOptions fine = exchange, exact = exchange;
    fine.backend.native.emplace("regularisation", fine_regularisation);
    fine.backend.native.emplace("patience", long_patience);
    exact.backend.exact_steps = ExactSteps::always;
    if (proves(fine) || proves(exact)) return;
    fine.enough = nullptr;  // rows of a later round may make a problem well posed that was not
    proves(fine);
}

}  // namespace

bool is_better(const Certificate& one, const Certificate& two, double gap) {
    const bool moves = has_feasible_motion(one.verdict), other_moves = has_feasible_motion(two.verdict);
    if (!moves || !other_moves) return moves || (!other_moves && is_proved(one) && !is_proved(two));
    if (is_proved(one)) return true;
    // What violates limits is below what does not, and no better for that.
    if (is_relaxed(one) != is_relaxed(two)) return one.gap.value_or(infinity) < two.gap.value_or(infinity);
    const double less = two.objective - one.objective;
    const bool equal = std::abs(less) <= gap * std::max(1.0, std::abs(one.objective));
    return equal ? one.verdict < two.verdict : less > 0.0;
}

ContinuousResult solve_convex(const ConvexRun& run, ExchangeOptions exchange, NextSolver& next) {
    ExchangeOptions plain = exchange;
    plain.staged = false;
    const bool structured = run.solver.name() == "structured";
    if (structured) {
        if (run.next_solver.empty()) exchange.backend.exact_steps = ExactSteps::after_failure;
        // A round that fails is followed by others that fail: other steps are tried at once.
        exchange.enough = [](const ExchangeResult& found) {
            return found.last.termination == Termination::numerical_failure;
        };
    }
    ContinuousResult result = solve_continuous(run.problem, run.solver, exchange, run.judge, run.control);
    if (result.certificate.reason == Reason::unbounded) {
        forget_proof(result.certificate);  // of motions up to the farthest that proofs cover
        return result;
    }
    if (structured && !is_proved(result.certificate)) try_harder(run, exchange, result);
    try_next_solver(run, std::move(plain), result, next);
    return result;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "solvers/exchange/exchange.hpp"
#include "solvers/structured/structured_solver.hpp"

namespace camopt {

namespace {

/// The delivered point: f(x) and what its limits are relaxed by.
struct JudgedPoint {
    const Eigen::VectorXd& x;
    double objective = infinity;
    double slack = 0.0;  ///< >= its violation
};

/// Of one solve for its multipliers.
BackendOptions solved_once(const ExchangeOptions& exchange) {
    BackendOptions options;
    options.tolerance = exchange.backend.tolerance;
    options.max_seconds = exchange.backend.max_seconds;
    return options;
}

/// A proof that no point that satisfies the limits to within `slack` has less than proof.bound, which is at
/// most the objective (to round-off). On the problem's current grid, by the structured solver; convex
/// problems only. Nullopt if no finite bound is found.
std::optional<DualityProof> relaxed_proof(ContinuousProblem& problem, const JudgedPoint& point,
                                          const BackendOptions& options, const SolveControl& control) {
    if (!problem.grid().shape().convex || !problem.convex(point.objective)) return {};
    const RelaxedProblem relaxed(problem, point.slack);
    const BackendResult dual = make_structured_solver()->minimize(relaxed.grid(), point.x, options, control);
    if (!dual.row_multipliers || !dual.row_multipliers->allFinite()) return {};
    DualityProof proof = duality_proof(relaxed.grid(), dual.x, *dual.row_multipliers,
                                       relaxed.box(point.objective, 0.0), "objective");
    if (!std::isfinite(proof.bound)) return {};
    proof.limits_relaxed_by = point.slack;
    return proof;
}

// Rows this close to their bound may have a multiplier when a backend gives none.
constexpr double active_row = 1e-6;
// Violation that is rounding, and the cost of a repair that is not worth it.
constexpr double rounding_of_limits = 1e-12, dear_repair = 1e-9;
// Factor on the step towards the interior that the violation requires.
constexpr double pull = 1.0 + 1e-6;

bool is_closed(const Certificate& certificate, const JudgeOptions& judge) {
    return certificate.gap && *certificate.gap <= judge.gap;
}

void adopt(ContinuousResult& result, DualityProof proof, std::string source) {
    Certificate& certificate = result.certificate;
    certificate.lower_bound = proof.bound;
    certificate.gap = relative_gap(certificate.objective, proof.bound);
    certificate.proof = std::move(proof);
    certificate.proof_kind = ProofKind::duality;
    result.proof_source = std::move(source);
}

/// Keeps the better of the current proof and that of these multipliers. `at`: the point they belong to, where
/// curved rows and costs have the tangents that they balance; the delivered point may be a little off it.
void try_proof(ContinuousResult& result, const ContinuousProblem& problem, const Eigen::VectorXd& multipliers,
               const Eigen::VectorXd& at, const std::string& source) {
    const Nlp& grid = problem.grid();
    if (multipliers.size() != grid.shape().constraints() || !multipliers.allFinite()) return;
    Certificate& certificate = result.certificate;
    const double stationarity = stationarity_of(grid, result.x, multipliers, active_row);
    certificate.stationarity = std::min(certificate.stationarity.value_or(infinity), stationarity);
    if (!grid.shape().convex || !problem.convex(certificate.objective)) return;
    DualityProof proof =
        duality_proof(grid, at, multipliers, problem.box(certificate.objective, 0.0), "objective");
    if (!std::isfinite(proof.bound)) return;
    if (certificate.lower_bound && *certificate.lower_bound >= proof.bound) return;
    adopt(result, std::move(proof), source);
}

void prove(ContinuousResult& result, ContinuousProblem& problem, const Solver& solver,
           const ExchangeOptions& exchange, const JudgeOptions& judge, const SolveControl& control) {
    const BackendResult& last = result.exchange.last;
    if (last.row_multipliers)
        try_proof(result, problem, *last.row_multipliers, last.x, std::string(solver.name()));
    else if (!was_stopped(result.exchange.termination))
        try_proof(result, problem, fitted_multipliers(problem.grid(), result.x, active_row, control),
                  result.x, "fitted");
    if (is_closed(result.certificate, judge) || !problem.grid().shape().convex || control.ending()) return;
    if (solver.name() == "structured" && was_stopped(result.exchange.termination)) return;
    // The grid of another backend's last round is a relaxation too: its dual is a bound for all curves.
    const BackendOptions options = solved_once(exchange);
    const BackendResult dual = make_structured_solver()->minimize(problem.grid(), result.x, options, control);
    if (dual.row_multipliers) try_proof(result, problem, *dual.row_multipliers, dual.x, "structured");
}

// Where limits leave little room, the repair of a violation costs its size times the condition of the scene:
// the exchange goes on with these parts of its tolerance while the gap is open. Of backends that take longer
// to come closer, where not much is missing.
constexpr std::array closer_parts = {1e-2, 1e-4};
constexpr double nearly_closed = 1e-4;

/// The best points so far, moved inside the limits and as they were found.
struct Points {
    Candidate inside;  ///< towards which they are moved
    double tolerance = 0.0;
    Candidate found = {};

    /// The better one of a search, moved inside.
    Candidate repaired(const ContinuousProblem& problem, const ExchangeResult& search) {
        for (const Candidate* one : {&search.best, &search.latest})
            if (one->x.size() > 0 && (found.x.size() == 0 || is_better(*one, found, tolerance))) found = *one;
        Candidate best = pulled_inside(problem, search.best, inside);
        Candidate latest = pulled_inside(problem, search.latest, inside);
        return is_better(latest, best, tolerance) ? latest : best;
    }
};

void deliver(ContinuousResult& result, const Candidate& point) {
    result.x = point.x;
    result.certificate.objective = point.objective;
    result.certificate.worst_violation = point.violation;
    if (result.certificate.lower_bound)
        result.certificate.gap = relative_gap(point.objective, *result.certificate.lower_bound);
}

/// Goes on with the exchange from the delivered point, to these tolerances; delivers what `choice` takes of
/// what it finds, if anything, and tries its multipliers.
template <class Choice>
void go_on(ContinuousResult& result, ContinuousProblem& problem, const Solver& solver,
           const ExchangeOptions& closer, const SolveControl& control, const Choice& choice) {
    const Certificate& certificate = result.certificate;
    const Candidate now{result.x, certificate.objective, certificate.worst_violation};
    const ExchangeResult found = minimize_by_exchange(problem, solver, now, closer, control);
    result.exchange.rounds += found.rounds;
    result.exchange.iterations += found.iterations;
    result.exchange.seconds_solver += found.seconds_solver;
    const Candidate point = choice(found, now);
    if (point.x.size() > 0) deliver(result, point);
    if (found.last.row_multipliers)
        try_proof(result, problem, *found.last.row_multipliers, found.last.x, std::string(solver.name()));
}

/// Closes a gap that the repair has left.
void come_closer(ContinuousResult& result, ContinuousProblem& problem, const Solver& solver,
                 const ExchangeOptions& exchange, const JudgeOptions& judge, const SolveControl& control,
                 Points& points) {
    const double widest = solver.name() == "structured" ? infinity : nearly_closed;
    for (const double part : closer_parts) {
        const Certificate& certificate = result.certificate;
        const bool open = certificate.gap && !is_closed(certificate, judge) && *certificate.gap <= widest;
        if (!open || !problem.convex(certificate.objective) || control.ending()) return;
        ExchangeOptions closer = exchange;
        closer.tolerance *= part;
        closer.backend.tolerance *= part;
        go_on(result, problem, solver, closer, control,
              [&](const ExchangeResult& found, const Candidate& now) {
                  const Candidate better = points.repaired(problem, found);
                  return is_better(better, now, judge.tolerance) ? better : Candidate{};
              });
    }
}

/// Once more with multipliers that are balanced to rounding.
void sharpen_proof(ContinuousResult& result, const JudgeOptions& judge) {
    Certificate& certificate = result.certificate;
    if (!certificate.gap || is_closed(certificate, judge) || !certificate.proof) return;
    DualityProof proof = std::move(*certificate.proof);
    sharpen(proof, certificate.objective);
    adopt(result, std::move(proof), result.proof_source);
}

/// The first point of a solve: the problem's own start if it is feasible, else the point of least violation
/// of the elastic problem, which also proves infeasibility.
struct FirstPoint {
    Candidate inside;
    std::optional<DualityProof> infeasible;
    bool searched = false;  ///< it took a search that ended
    double seconds_solver = 0.0;
};

FirstPoint first_point(ContinuousProblem& problem, const ExchangeOptions& exchange, const JudgeOptions& judge,
                       const SolveControl& control) {
    FirstPoint first{judged(problem, problem.start()), {}, false, 0.0};
    const bool kept = first.inside.violation <= judge.tolerance;
    if (kept || control.ending() || !problem.grid().shape().convex) return first;
    Feasibility feasibility = find_feasible(problem, exchange, control);
    first.seconds_solver = feasibility.seconds_solver;
    first.searched = feasibility.point.x.size() > 0;
    if (first.searched) first.inside = std::move(feasibility.point);
    if (first.inside.violation > judge.tolerance) first.infeasible = std::move(feasibility.proof);
    return first;
}

void report_infeasible(ContinuousResult& result, FirstPoint first) {
    Certificate& certificate = result.certificate;
    certificate.verdict = Verdict::infeasible;
    certificate.reason = Reason::limits_contradict;
    certificate.worst_violation = first.inside.violation;
    certificate.proof = std::move(first.infeasible);
    certificate.proof_kind = ProofKind::duality;
    result.proof_source = "structured";
}

}  // namespace

void settle_passed_bound(ContinuousResult& result, ContinuousProblem& problem,
                         const ExchangeOptions& exchange, const JudgeOptions& judge,
                         const SolveControl& control) {
    Certificate& certificate = result.certificate;
    const auto passes = [&](double bound) {
        return bound_passes(certificate.objective, bound, judge.tolerance);
    };
    if (!certificate.lower_bound) return;
    if (!passes(*certificate.lower_bound)) {
        // Above it by rounding of the limits: what the proof claims of other motions is not less true below.
        certificate.lower_bound = std::min(*certificate.lower_bound, certificate.objective);
        return;
    }
    forget_proof(certificate);
    result.proof_source.clear();
    if (!(certificate.worst_violation <= judge.tolerance)) return;  // nothing is delivered
    const BackendOptions options = solved_once(exchange);
    const double least = std::max(rounding_of_limits, 2.0 * certificate.worst_violation);
    for (const double slack : {least, std::max(judge.tolerance, least)}) {
        std::optional<DualityProof> proof =
            relaxed_proof(problem, {result.x, certificate.objective, slack}, options, control);
        if (proof && !passes(proof->bound)) {
            adopt(result, std::move(*proof), "structured, limits relaxed");
            certificate.lower_bound = std::min(*certificate.lower_bound, certificate.objective);
            return;
        }
        if (least >= judge.tolerance) return;  // the next one is the same
    }
}

void settle_verdict(Certificate& certificate, Termination termination, const JudgeOptions& options) {
    if (!(certificate.worst_violation <= options.tolerance)) {
        certificate.verdict = Verdict::failed;
        certificate.reason = was_stopped(termination) ? reason_of(termination) : Reason::no_feasible_point;
        certificate.gap.reset();  // the gap would refer to a point that is not returned
    } else if (is_closed(certificate, options)) {
        certificate.verdict = Verdict::optimal;
        certificate.reason = Reason::none;
    } else if (certificate.stationarity && *certificate.stationarity <= options.stationarity) {
        certificate.verdict = Verdict::local;
        certificate.reason = was_stopped(termination) ? reason_of(termination) : Reason::stationary;
    } else {
        certificate.verdict = Verdict::feasible;
        certificate.reason = reason_of(termination);
    }
}

Candidate pulled_inside(const ContinuousProblem& problem, const Candidate& point, const Candidate& inside) {
    if (point.x.size() == 0 || point.violation <= 0.0) return point;
    if (inside.x.size() == 0 || inside.violation >= 0.0) return point;
    const double part = point.violation / (point.violation - inside.violation);
    // Slightly further than the line requires, so that round-off leaves no violation.
    const Candidate pulled = judged(problem, point.x + std::min(1.0, pull * part) * (inside.x - point.x));
    // Limits without room: the violation is rounding of their values, and its repair leads elsewhere.
    const bool moves = relative_gap(pulled.objective, point.objective) > dear_repair;
    if (point.violation <= rounding_of_limits && moves) return point;
    return pulled.violation < point.violation ? pulled : point;
}

namespace {

/// Limits with little room: where the repair costs more than the gap, the point as it was found, within the
/// tolerance of its limits, is the optimum.
void use_tolerance(ContinuousResult& result, ContinuousProblem& problem, const Candidate& found,
                   const ExchangeOptions& exchange, const JudgeOptions& judge, const SolveControl& control) {
    const Certificate& certificate = result.certificate;
    if (!certificate.gap || is_closed(certificate, judge) || !(found.violation <= judge.tolerance)) return;
    if (!(found.objective < certificate.objective)) return;
    ContinuousResult tried = result;
    deliver(tried, found);
    settle_passed_bound(tried, problem, exchange, judge, control);
    if (is_closed(tried.certificate, judge)) result = std::move(tried);
}

/// Where the repair of a violation is dear, the point was left as it was found, and its objective may be
/// below the optimum by the violation times the condition of the scene: the exchange goes on until its rows
/// hold the limits themselves.
void hold_limits(ContinuousResult& result, ContinuousProblem& problem, const Solver& solver,
                 ExchangeOptions exchange, const JudgeOptions& judge, const SolveControl& control,
                 const Candidate& inside) {
    constexpr double part = 1e-2;
    constexpr int few_rounds = 8;
    const Certificate& before = result.certificate;
    const bool kept = before.worst_violation > 0.0 && is_closed(before, judge);
    if (!kept || !problem.convex(before.objective) || control.ending()) return;
    exchange.tolerance = 0.1 * part * before.worst_violation;
    exchange.backend.tolerance *= closer_parts.back();
    exchange.backend.exact_steps = ExactSteps::always;
    exchange.most_rounds = few_rounds;
    ContinuousResult held = result;
    go_on(held, problem, solver, exchange, control, [&](const ExchangeResult& found, const Candidate& now) {
        const Candidate pulled = pulled_inside(problem, found.latest, inside);
        const bool dear = relative_gap(pulled.objective, found.latest.objective) > dear_repair;
        const Candidate& closer = dear ? found.latest : pulled;
        return closer.violation < part * now.violation ? closer : Candidate{};
    });
    sharpen_proof(held, judge);
    const bool holds = held.certificate.worst_violation < before.worst_violation;
    if (holds && is_closed(held.certificate, judge)) result = std::move(held);
}

/// A point that still violates limits may be below every one that does not, and a proof whose bound is its
/// objective says nothing of that. Where the violation is worth more than rounding, the bound is that of all
/// points that violate the limits as much.
void admit_violation(ContinuousResult& result, ContinuousProblem& problem, const ExchangeOptions& exchange,
                     const JudgeOptions& judge, const SolveControl& control) {
    constexpr double room = 2.0, worthless = 5e-9;
    Certificate& certificate = result.certificate;
    const bool counts = certificate.worst_violation > 0.0 && is_closed(certificate, judge);
    if (!counts || !problem.convex(certificate.objective) || control.ending()) return;
    const JudgedPoint point{result.x, certificate.objective, room * certificate.worst_violation};
    std::optional<DualityProof> proof = relaxed_proof(problem, point, solved_once(exchange), control);
    if (proof && relative_gap(point.objective, proof->bound) <= worthless) return;
    forget_proof(certificate);
    if (proof) adopt(result, std::move(*proof), "structured, limits relaxed");
}

/// From the first point by exchange; repaired, proved and judged.
ContinuousResult searched(ContinuousProblem& problem, const Solver& solver, const FirstPoint& first,
                          const ExchangeOptions& exchange, const JudgeOptions& judge,
                          const SolveControl& control) {
    ContinuousResult result;
    const Stopwatch watch;
    result.inside = first.inside;
    result.exchange = minimize_by_exchange(problem, solver, first.inside, exchange, control);
    if (first.searched && result.exchange.best.x.size() == 0) result.exchange.best = first.inside;
    Points points{first.inside, judge.tolerance};
    const Candidate best = points.repaired(problem, result.exchange);
    deliver(result, best);
    result.seconds.solver = result.exchange.seconds_solver;
    result.seconds.judgement = watch.seconds() - result.seconds.solver;
    bool no_room = false;
    if (best.x.size() > 0 && best.violation <= judge.tolerance) {
        prove(result, problem, solver, exchange, judge, control);
        sharpen_proof(result, judge);
        come_closer(result, problem, solver, exchange, judge, control, points);
        sharpen_proof(result, judge);
        use_tolerance(result, problem, points.found, exchange, judge, control);
        hold_limits(result, problem, solver, exchange, judge, control, first.inside);
        admit_violation(result, problem, exchange, judge, control);
        const bool had_bound = result.certificate.lower_bound.has_value();
        settle_passed_bound(result, problem, exchange, judge, control);
        no_room = had_bound && !result.certificate.lower_bound;
    }
    result.seconds.proof = watch.seconds() - result.seconds.solver - result.seconds.judgement;
    settle_verdict(result.certificate, result.exchange.termination, judge);
    if (no_room && result.certificate.verdict == Verdict::local)
        result.certificate.verdict = Verdict::feasible;
    if (no_room && result.certificate.verdict == Verdict::feasible)
        result.certificate.reason = Reason::limits_within_rounding;
    if (result.certificate.verdict == Verdict::failed) result.x.resize(0);
    return result;
}

// What a motion without room may use of the tolerance: all but what rounding takes of the rest. The room that
// this leaves is smaller than what an exchange comes close by, and than what steps of doubles see.
constexpr double usable = 0.999, part_of_room = 0.1;

/// Whether only the tolerance of its limits makes a convex problem feasible, and its optimum is not found.
bool has_no_room(const ContinuousResult& result, const ContinuousProblem& problem,
                 const JudgeOptions& judge) {
    const double least = result.inside.violation;
    return problem.grid().shape().convex && result.certificate.verdict != Verdict::optimal &&
           least > rounding_of_limits && least < usable * judge.tolerance;
}

/// With all limits relaxed by the tolerance; kept where more is proved.
void search_with_room(ContinuousResult& result, ContinuousProblem& problem, const Solver& solver,
                      FirstPoint first, ExchangeOptions exchange, const JudgeOptions& judge,
                      const SolveControl& control) {
    const double slack = usable * judge.tolerance;
    exchange.tolerance *= part_of_room;
    exchange.backend.tolerance *= part_of_room;
    exchange.backend.exact_steps = ExactSteps::always;
    RelaxedProblem relaxed(problem, slack);
    first.inside.violation -= slack;
    ContinuousResult found = searched(relaxed, solver, first, exchange, judge, control);
    found.seconds += result.seconds;
    result.seconds = found.seconds;
    found.certificate.worst_violation += slack;
    const auto gap_of = [](const ContinuousResult& one) { return one.certificate.gap.value_or(infinity); };
    if (!(found.certificate.worst_violation <= judge.tolerance) || !(gap_of(found) < gap_of(result))) return;
    found.exchange.rounds += result.exchange.rounds;
    found.exchange.iterations += result.exchange.iterations;
    found.inside.violation += slack;
    double& relaxed_by = found.certificate.proof->limits_relaxed_by;
    if (relaxed_by == 0.0) found.proof_source += ", limits relaxed";
    relaxed_by += slack;
    result = std::move(found);
}

}  // namespace

ContinuousResult solve_continuous(ContinuousProblem& problem, const Solver& solver,
                                  const ExchangeOptions& exchange, const JudgeOptions& judge,
                                  const SolveControl& control) {
    const SolveControl timed = control.sooner(exchange.backend.max_seconds);
    const Stopwatch watch;
    FirstPoint first = first_point(problem, exchange, judge, timed);
    const ContinuousSeconds before{first.seconds_solver, watch.seconds() - first.seconds_solver, 0.0};
    ContinuousResult result;
    if (first.infeasible) {
        report_infeasible(result, std::move(first));
    } else {
        result = searched(problem, solver, first, exchange, judge, timed);
        if (has_no_room(result, problem, judge) && !timed.ending())
            search_with_room(result, problem, solver, first, exchange, judge, timed);
    }
    result.seconds += before;
    return result;
}

}  // namespace camopt

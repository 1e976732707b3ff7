// SPDX-License-Identifier: MIT
#include "studies/search/solve_from_starts.hpp"

#include "objectives/scene_model.hpp"
#include "solvers/certificate/certificate.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/bound/box_bound.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/start_search.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace camopt {

namespace {

// Rows this close to their bound may carry a multiplier.
constexpr double active_row = 1e-6;
// Searches before the first bound over boxes: often their best is the optimum, and the bound shows it.
constexpr int starts_before_bound = 2;
// Boxes halved before the other starts: two motions that mirror each other may both be best.
constexpr int parts_between_starts = 3, most_parts = 60, most_bound_rounds = 3;
// What is proved is rounded outward once more where it is recomputed.
constexpr double box_part_of_gap = 0.9;
constexpr int samples_a_piece = 6;

/// Rows that later searches added carry no multiplier.
Eigen::VectorXd padded(const Eigen::VectorXd& multipliers, int rows) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rows);
    if (multipliers.size() <= rows) all.head(multipliers.size()) = multipliers;
    return all;
}

void judge_search(ContinuousResult& result, const StartSearch& search, const SolveControl& control) {
    const Candidate& found = search.best().found;
    Certificate& certificate = result.certificate;
    certificate.objective = found.objective;
    certificate.worst_violation = found.violation;
    if (found.x.size() == 0) return;
    result.x = found.x;
    const Nlp& grid = search.problem().grid();
    const int rows = grid.shape().constraints();
    const double own = stationarity_of(grid, found.x, padded(search.best().multipliers, rows), active_row);
    const double fitted =
        stationarity_of(grid, found.x, fitted_multipliers(grid, found.x, active_row, control), active_row);
    certificate.stationarity = std::isfinite(own) ? std::min(own, fitted) : fitted;
}

/// What a relaxation gives. `settled`: the answer of the whole already.
struct Relaxed {
    ContinuousResult result;
    std::shared_ptr<const CamProblem> problem;  ///< what its bound is of
    bool settled = false;
};

Relaxed solve_relaxed(CamModel part, const CamProblem& whole, const ExchangeOptions& exchange,
                      const JudgeOptions& judge, const SolveControl& control, GridMemory* memory) {
    ExchangeOptions options = exchange;
    options.backend.native.clear();  // they belong to the backend the user chose
    const auto problem = std::make_shared<CamProblem>(memory != nullptr ? memory->problem(std::move(part))
                                                                        : CamProblem(std::move(part)));
    Relaxed relaxed{solve_continuous(*problem, *make_structured_solver(), options, judge, control), problem};
    if (memory != nullptr) memory->keep(*problem);
    Certificate& certificate = relaxed.result.certificate;
    drop_idle_bound(certificate);
    relaxed.settled = certificate.verdict == Verdict::infeasible;
    if (certificate.verdict != Verdict::optimal) return relaxed;
    const Candidate kept = judged(whole, relaxed.result.x);
    if (kept.violation > judge.tolerance) return relaxed;
    certificate.worst_violation = kept.violation;
    relaxed.settled = true;
    return relaxed;
}

/// The entries whose motion is nearest to another one, of the same space written otherwise.
Eigen::VectorXd same_motion(const MotionFamily& family, const MotionChain& motion) {
    std::vector<AffineRow> rows;
    std::vector<double> values;
    for (const MotionFamily::Piece& piece : family.pieces()) {
        for (int k = 0; k <= samples_a_piece; ++k) {
            const double x = piece.begin + (piece.end - piece.begin) * k / samples_a_piece;
            const Side side = k < samples_a_piece ? Side::right : Side::left;
            const MotionPoint point = motion.at(x, side);
            for (int order = 0; order < 3; ++order) {
                rows.push_back(family.functional(x, order, side));
                values.push_back(point.derivative[static_cast<std::size_t>(order)] - rows.back().offset);
            }
        }
    }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), family.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < rows[i].columns.size(); ++k)
            matrix(static_cast<Eigen::Index>(i), rows[i].columns[k]) = rows[i].weights[k];
    const Eigen::Map<const Eigen::VectorXd> right(values.data(), matrix.rows());
    return matrix.completeOrthogonalDecomposition().solve(right);
}

/// What bounding over boxes needs beside the search.
struct BoxSearch {
    const std::function<CamModel()>& in_coefficients;
    const JudgeOptions& judge;
    const SolveControl& control;
    std::optional<CamModel> model = {};
    std::optional<BoxBound> bound = {};

    [[nodiscard]] bool is_settled(double objective) const {
        if (!bound) return false;
        return bound->infeasible || relative_gap(objective, bound->bound) <= judge.gap;
    }
    /// Of the motion at hand; infinity: none.
    void run(double objective, int parts) {
        if (control.ending()) return;
        if (!model) model = in_coefficients();
        BoxBoundOptions options;
        options.gap = box_part_of_gap * judge.gap;
        options.most_parts = parts;
        const bool in_vain = !std::isfinite(objective);
        bound = bound_over_boxes(*model, objective, options,
                                 in_vain ? control.sooner(control.in_vain.seconds_left()) : control);
    }
    /// Its own motion, which breaks limits, as a point of another form of the problem.
    [[nodiscard]] Eigen::VectorXd start(const CamProblem& problem) const {
        if (!bound || bound->x.size() == 0) return {};
        const CamProblem own(*model);
        Eigen::VectorXd x = problem.start();
        const MotionFamily& family = problem.model().design;
        x.head(family.size()) =
            same_motion(family, own.motion(bound->x)).cwiseQuotient(design_scales(problem.model()));
        const auto parameters = static_cast<Eigen::Index>(problem.model().parameters.size());
        if (own.model().parameters.size() == problem.model().parameters.size())
            x.tail(parameters) = bound->x.tail(parameters);
        return problem.completed(x);
    }
};

/// Searches and bounds in turn: two starts, a bound by one part, a start from the bound's own motion, the
/// other starts, and the boxes halved. Ends where bound and motion meet.
void search_and_bound(StartSearch& search, BoxSearch& boxes, int starts, unsigned seed,
                      const Eigen::VectorXd& relaxed) {
    const auto objective = [&]() -> double {
        if (!search.found()) return infinity;
        return search.best().found.objective;
    };
    const int first = std::min(starts, starts_before_bound);
    search.run(0, first, seed, relaxed);
    boxes.run(objective(), parts_between_starts);
    if (boxes.is_settled(objective())) return;
    double bounded = objective();
    if (boxes.bound) {
        const Eigen::VectorXd own = boxes.start(search.problem());
        if (own.size() > 0 && own.allFinite()) search.run_from(own);
    }
    if (boxes.is_settled(objective())) return;
    search.run(first, starts, seed, relaxed);
    if (!boxes.bound) return;
    for (int round = 0; round < most_bound_rounds && !boxes.is_settled(objective()); ++round) {
        if (round > 0 && objective() == bounded) return;
        bounded = objective();
        boxes.run(bounded, most_parts);
        if (!boxes.bound || boxes.is_settled(objective())) return;
        const Eigen::VectorXd own = boxes.start(search.problem());
        if (own.size() > 0 && own.allFinite()) search.run_from(own);
    }
}

/// The bound over boxes where it says more than the one at hand.
void take_box_bound(ContinuousResult& result, const BoxSearch& boxes) {
    Certificate& certificate = result.certificate;
    if (!boxes.bound) return;
    if (boxes.bound->infeasible) {
        certificate.verdict = Verdict::infeasible;
        certificate.reason = Reason::limits_contradict;
        certificate.lower_bound.reset();
        certificate.gap.reset();
    } else {
        const double bound = std::min(boxes.bound->bound, certificate.objective);
        if (!std::isfinite(bound) || (certificate.lower_bound && *certificate.lower_bound >= bound)) return;
        certificate.lower_bound = bound;
        certificate.gap = relative_gap(certificate.objective, bound);
    }
    certificate.proof.reset();
    certificate.proof_kind = ProofKind::boxes;
    certificate.box_proof = boxes.bound->proof;
    result.proof_source = "boxes";
}

/// One search from what the last one found; nothing where that is of another motion, or ends outside the
/// limits.
std::optional<StartsResult> look_from_last(const CamModel& model, const Solver& solver,
                                           const ExchangeOptions& exchange, const JudgeOptions& judge,
                                           const SolveControl& control, GridMemory& memory) {
    CamProblem problem = memory.problem(model);
    const Eigen::VectorXd last = memory.last_found(problem);
    if (last.size() == 0) return std::nullopt;
    StartSearch search(std::move(problem), solver, exchange, judge, control);
    search.continue_from(last);
    memory.keep(search.problem());
    StartsResult all;
    all.starts = 1;
    all.result.exchange = search.totals();
    judge_search(all.result, search, control);
    settle_verdict(all.result.certificate, all.result.exchange.termination, judge);
    if (all.result.certificate.verdict == Verdict::failed) return std::nullopt;
    memory.keep_found(search.problem(), all.result.x);
    return all;
}

}  // namespace

bool needs_starts(const CamModel& model) {
    return std::ranges::any_of(model.rules, [](const PlacedRule& rule) {
        return rule->curvature(-infinity, infinity) == Curvature::general;
    });
}

StartsResult solve_from_starts(const CamModel& model, const Solver& solver, const ExchangeOptions& exchange,
                               const JudgeOptions& judge, int starts, unsigned seed,
                               const SolveControl& control, const std::function<CamModel()>& in_coefficients,
                               GridMemory* memory) {
    const SolveControl timed = control.sooner(exchange.backend.max_seconds);
    if (memory != nullptr && memory->only_looks)
        if (std::optional<StartsResult> seen = look_from_last(model, solver, exchange, judge, timed, *memory))
            return std::move(*seen);
    StartsResult all;
    const CamProblem whole(model);
    CamModel always_convex = convex_part(model, ConvexOver::every_motion);
    CamModel usually_convex = convex_part(model, ConvexOver::sensible_motion);
    const bool more_rules = usually_convex.rules.size() > always_convex.rules.size();
    Relaxed relaxed = solve_relaxed(std::move(always_convex), whole, exchange, judge, timed, memory);
    if (!relaxed.settled && more_rules && !timed.ending()) {
        Relaxed tighter = solve_relaxed(std::move(usually_convex), whole, exchange, judge, timed, memory);
        const bool unproved = !tighter.result.certificate.lower_bound;
        if (unproved && !tighter.settled) {  // keep the bound at hand, start from the better motion
            if (tighter.result.x.size() > 0) relaxed.result.x = tighter.result.x;
        } else {
            relaxed = std::move(tighter);
        }
    }
    if (relaxed.settled) {
        if (memory != nullptr) memory->forget_found();
        all.result = std::move(relaxed.result);
        return all;
    }
    StartSearch search(CamProblem(model), solver, exchange, judge, timed);
    BoxSearch boxes{in_coefficients, judge, timed};
    const bool looks = memory != nullptr && memory->only_looks;
    if (looks)  // a picture before its proof
        search.run(0, starts, seed, relaxed.result.x);
    else
        search_and_bound(search, boxes, starts, seed, relaxed.result.x);
    all.starts = search.ran();
    ContinuousResult& result = all.result;
    result.exchange = search.totals();
    judge_search(result, search, timed);
    Certificate& bound = relaxed.result.certificate;
    if (bound.lower_bound) {
        result.certificate.lower_bound = bound.lower_bound;
        result.certificate.gap = relative_gap(result.certificate.objective, *bound.lower_bound);
        result.certificate.proof = std::move(bound.proof);
        result.certificate.proof_kind = bound.proof_kind;
        result.proof_source = "structured, convex relaxation";
        settle_passed_bound(result, *relaxed.problem, exchange, judge, timed);
    }
    take_box_bound(result, boxes);
    if (result.certificate.verdict == Verdict::infeasible)
        result.x.resize(0);
    else
        settle_verdict(result.certificate, result.exchange.termination, judge);
    if (result.certificate.verdict == Verdict::failed) result.x.resize(0);
    if (memory != nullptr && result.x.size() > 0) memory->keep_found(search.problem(), result.x);
    return all;
}

}  // namespace camopt

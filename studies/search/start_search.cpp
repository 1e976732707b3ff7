// SPDX-License-Identifier: MIT
#include "studies/search/start_search.hpp"

#include "solvers/registry.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/bound/box_bound.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/stroke_excursions.hpp"

#include <Eigen/QR>

#include <cmath>

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

// Of the size of each variable: a search that comes nearer than this to a minimum would end at it. It needs
// one or two more passes there, of four in all.
constexpr double same_minimum = 1e-2;

bool is_beside(const Eigen::VectorXd& x, const Eigen::VectorXd& known) {
    if (x.size() != known.size()) return false;
    return ((x - known).array().abs() <= same_minimum * known.array().abs().max(1.0)).all();
}

/// Rows that later searches added carry no multiplier.
Eigen::VectorXd padded(const Eigen::VectorXd& multipliers, int rows) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rows);
    if (multipliers.size() <= rows) all.head(multipliers.size()) = multipliers;
    return all;
}

/// What a relaxation gives. `settled`: the answer of the whole already.
struct Relaxed {
    ContinuousResult result;
    std::shared_ptr<CamProblem> problem;  ///< what its bound is of
    bool settled = false;
};

/// The steps of solve_from_starts().
class GeneralSolve {
 public:
    GeneralSolve(const PlannedRun& run, const CamModel& model, const Solver& solver)
        : plan_(run.plan),
          posed_(run.posed),
          known_(run.known),
          leaves_strokes_(run.leaves_strokes),
          model_(model),
          solver_(solver),
          exchange_(exchange_options(run.posed.scene)),
          judge_{posed_.scene.solver.tolerance, posed_.scene.solver.wanted_gap(false)},
          control_(run.control.sooner(exchange_.backend.max_seconds)),
          first_control_(control_) {
        if (plan_.next_solver.empty()) return;
        const double left = std::min(control_.in_vain.seconds_left(), control_.deadline.seconds_left());
        first_control_.in_vain = control_.deadline.sooner(share_of_first * left);
    }

    [[nodiscard]] StartsResult run() {
        StartsResult all;
        if (plan_.look && continue_from_last(all)) return all;
        Relaxed relaxed = solve_relaxations();
        if (relaxed.settled) {
            known_.found = {};
            const bool leaves = leaves_strokes_ != nullptr && leaves_strokes(relaxed);
            all.result = std::move(relaxed.result);
            if (leaves) {
                *leaves_strokes_ = true;
                all.result.x.resize(0);
            }
            all.relaxation = std::move(relaxed.problem);
            return all;
        }
        StartSearch search(CamProblem(model_), solver_, exchange_, judge_, first_control_);
        if (plan_.proof == ProofKind::boxes)
            search_and_bound(search, relaxed.result.x);
        else
            search_to_end(search, 0, relaxed.result.x);
        take_search(all, search);
        all.next_solver_ran = next_ != nullptr;
        all.found_by_next = next_ && search.found();
        take_bound(all.result, relaxed);
        take_box_bound(all.result);
        Certificate& certificate = all.result.certificate;
        if (certificate.verdict != Verdict::infeasible)
            settle_verdict(certificate, all.result.exchange.termination, judge_);
        if (certificate.verdict == Verdict::infeasible || certificate.verdict == Verdict::failed)
            all.result.x.resize(0);
        if (all.result.x.size() > 0) known_.keep_found(search.problem(), all.result.x);
        return all;
    }

 private:
    const SolvePlan& plan_;
    const PosedScene& posed_;
    KnownSolutions& known_;
    bool* leaves_strokes_;
    const CamModel& model_;
    const Solver& solver_;
    ExchangeOptions exchange_;
    JudgeOptions judge_;
    SolveControl control_;
    SolveControl first_control_;              ///< of the planned solver, which leaves the next one its time
    std::unique_ptr<Solver> next_ = {};       ///< once the planned solver has found nothing
    std::optional<CamModel> box_model_ = {};  ///< written in few variables
    std::optional<BoxBound> bound_ = {};      ///< over boxes
    ContinuousSeconds seconds_ = {};          ///< of relaxations and bounds

    /// One search from what the last one found; false: that is of another motion, or it ends outside the
    /// limits.
    [[nodiscard]] bool continue_from_last(StartsResult& all) {
        CamProblem problem = known_.problem(model_);
        const Eigen::VectorXd last = known_.last_found(problem);
        if (last.size() == 0) return false;
        StartSearch search(std::move(problem), solver_, exchange_, judge_, control_);
        search.continue_from(last);
        known_.keep(search.problem());
        StartsResult seen;
        take_search(seen, search);
        settle_verdict(seen.result.certificate, seen.result.exchange.termination, judge_);
        if (seen.result.certificate.verdict == Verdict::failed) return false;
        known_.keep_found(search.problem(), seen.result.x);
        all = std::move(seen);
        return true;
    }

    /// The planned ones, one after the other until one settles the whole.
    [[nodiscard]] Relaxed solve_relaxations() {
        const CamProblem whole(model_);
        Relaxed relaxed;
        for (const ConvexOver range : plan_.relaxations) {
            if (relaxed.problem && (relaxed.settled || control_.ending())) break;
            Relaxed next = solve_relaxation(convex_part(model_, range), whole);
            const bool unproved = !next.settled && !next.result.certificate.lower_bound;
            if (!relaxed.problem || !unproved)
                relaxed = std::move(next);
            else if (next.result.x.size() > 0)  // keep the current bound, start from the better motion
                relaxed.result.x = next.result.x;
        }
        return relaxed;
    }

    [[nodiscard]] Relaxed solve_relaxation(CamModel part, const CamProblem& whole) {
        ExchangeOptions options = exchange_;
        options.backend.native.clear();  // they belong to the backend the user chose
        const auto problem = std::make_shared<CamProblem>(known_.problem(std::move(part)));
        Relaxed relaxed{solve_continuous(*problem, *make_structured_solver(), options, judge_, control_),
                        problem};
        known_.keep(*problem);
        seconds_ += relaxed.result.seconds;
        relaxed.result.seconds = seconds_;
        Certificate& certificate = relaxed.result.certificate;
        drop_idle_bound(certificate, posed_.scene.objective);
        relaxed.settled = certificate.verdict == Verdict::infeasible;
        if (certificate.verdict != Verdict::optimal) return relaxed;
        const Candidate kept = judged(whole, relaxed.result.x);
        if (kept.violation > judge_.tolerance) return relaxed;
        certificate.worst_violation = kept.violation;
        relaxed.settled = true;
        return relaxed;
    }

    /// Breaking the tie would take long, and seldom bring the motion back.
    [[nodiscard]] bool leaves_strokes(const Relaxed& relaxed) const {
        const bool found =
            relaxed.result.certificate.verdict == Verdict::optimal && relaxed.result.x.size() > 0;
        return found && leaves_its_strokes(posed_.scene, relaxed.problem->model().design,
                                           relaxed.problem->motion(relaxed.result.x));
    }

    /// The starts from `first` on; of the next solver all, if nothing was found.
    void search_to_end(StartSearch& search, int first, const Eigen::VectorXd& relaxed) {
        search.run(first, plan_.starts, plan_.seed, relaxed);
        if (search.found() || plan_.next_solver.empty() || control_.ending()) return;
        next_ = make_solver(plan_.next_solver);
        search.go_on_with(*next_, control_);
        search.run(0, plan_.starts, plan_.seed, relaxed);
    }

    /// Searches and bounds in turn: two starts, a bound by one part, a start from the bound's own motion, the
    /// other starts, and the boxes halved. Ends where bound and motion meet.
    void search_and_bound(StartSearch& search, const Eigen::VectorXd& relaxed) {
        const int first = std::min(plan_.starts, starts_before_bound);
        search.run(0, first, plan_.seed, relaxed);
        bound_boxes(search, parts_between_starts);
        if (is_settled(search)) return;
        double bounded = objective_of(search);
        start_from_bound(search);
        if (is_settled(search)) return;
        search_to_end(search, first, relaxed);
        for (int round = 0; bound_ && round < most_bound_rounds && !is_settled(search); ++round) {
            if (round > 0 && objective_of(search) == bounded) return;
            bounded = objective_of(search);
            bound_boxes(search, most_parts);
            if (is_settled(search)) return;
            start_from_bound(search);
        }
    }

    /// By up to 2.4e-7 of it: the last digit can change the order in which boxes are halved, and with it
    /// their number, and a search's last digits are those of its solver.
    [[nodiscard]] static double rounded_up(double objective) {
        constexpr int bits = 22;
        if (!std::isfinite(objective)) return objective;
        const double unit = std::ldexp(1.0, std::ilogb(std::max(1.0, std::abs(objective))) - bits);
        return std::ceil(objective / unit) * unit;
    }
    [[nodiscard]] static double objective_of(const StartSearch& search) {
        if (!search.found()) return infinity;
        return search.best().found.objective;
    }
    [[nodiscard]] bool is_settled(const StartSearch& search) const {
        if (!bound_) return false;
        return bound_->infeasible || relative_gap(objective_of(search), bound_->bound) <= judge_.gap;
    }
    void bound_boxes(const StartSearch& search, int parts) {
        if (control_.ending()) return;
        const Stopwatch watch;
        if (!box_model_) box_model_ = posed_.model_as(DesignKind::coefficients);
        BoxBoundOptions options;
        options.gap = box_part_of_gap * judge_.gap;
        options.most_parts = parts;
        bound_ =
            bound_over_boxes(*box_model_, rounded_up(objective_of(search)), options,
                             search.found() ? control_ : control_.sooner(control_.in_vain.seconds_left()));
        seconds_.proof += watch.seconds();
    }
    /// From the bound's own motion, which breaks limits, as a point of another form of the problem.
    void start_from_bound(StartSearch& search) const {
        if (!bound_ || bound_->x.size() == 0) return;
        const CamProblem own(*box_model_);
        const CamProblem& problem = search.problem();
        Eigen::VectorXd x = problem.start();
        const MotionFamily& family = problem.model().design;
        x.head(family.size()) =
            same_motion(family, own.motion(bound_->x)).cwiseQuotient(design_scales(problem.model()));
        const auto parameters = static_cast<Eigen::Index>(problem.model().parameters.size());
        if (own.model().parameters.size() == problem.model().parameters.size())
            x.tail(parameters) = bound_->x.tail(parameters);
        x = problem.completed(x);
        if (x.allFinite()) search.run_from(x);
    }

    void take_search(StartsResult& all, const StartSearch& search) const {
        all.starts = search.ran();
        all.result.exchange = search.totals();
        all.result.seconds = search.seconds();
        all.result.seconds += seconds_;
        const Candidate& found = search.best().found;
        Certificate& certificate = all.result.certificate;
        certificate.objective = found.objective;
        certificate.worst_violation = found.violation;
        if (found.x.size() == 0) return;
        all.result.x = found.x;
        const Nlp& grid = search.problem().grid();
        const Eigen::VectorXd multipliers = padded(search.best().multipliers, grid.shape().constraints());
        const double own = stationarity_of(grid, found.x, multipliers, active_row);
        const double fitted = stationarity_of(
            grid, found.x, fitted_multipliers(grid, found.x, active_row, control_), active_row);
        certificate.stationarity = std::isfinite(own) ? std::min(own, fitted) : fitted;
    }

    void take_bound(ContinuousResult& result, Relaxed& relaxed) const {
        Certificate& bound = relaxed.result.certificate;
        if (!bound.lower_bound) return;
        result.certificate.lower_bound = bound.lower_bound;
        result.certificate.gap = relative_gap(result.certificate.objective, *bound.lower_bound);
        result.certificate.proof = std::move(bound.proof);
        result.certificate.proof_kind = bound.proof_kind;
        result.proof_source = "structured, convex relaxation";
        settle_passed_bound(result, *relaxed.problem, exchange_, judge_, control_);
    }

    /// The bound over boxes where it says more than the current one.
    void take_box_bound(ContinuousResult& result) const {
        if (!bound_) return;
        Certificate& certificate = result.certificate;
        if (bound_->infeasible) {
            certificate.verdict = Verdict::infeasible;
            certificate.reason = Reason::limits_contradict;
            certificate.lower_bound.reset();
            certificate.gap.reset();
        } else {
            const double bound = std::min(bound_->bound, certificate.objective);
            if (!std::isfinite(bound) || (certificate.lower_bound && *certificate.lower_bound >= bound))
                return;
            certificate.lower_bound = bound;
            certificate.gap = relative_gap(certificate.objective, bound);
        }
        certificate.proof.reset();
        certificate.proof_kind = ProofKind::boxes;
        certificate.box_proof = bound_->proof;
        result.proof_source = "boxes";
    }
};

}  // namespace

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

void StartSearch::run(int first, int end, unsigned seed, const Eigen::VectorXd& relaxed) {
    for (int k = first; k < end && !ends(k); ++k) run_from(start_of(k, seed, relaxed));
}

void StartSearch::run_from(const Eigen::VectorXd& start) {
    const bool in_vain = !found();
    keep(
        search(start, in_vain ? control_->sooner(control_->in_vain.seconds_left()) : beside_best(*control_)));
    // The limit of a search in vain does not hold for one that was on its way.
    if (in_vain && found() && totals_.termination == Termination::time_limit && !control_->ending())
        keep(search(best_.found.x, *control_));
    ++ran_;
}

void StartSearch::continue_from(const Eigen::VectorXd& x) {
    keep(search(x, *control_));
    ++ran_;
}

void StartSearch::go_on_with(const Solver& solver, const SolveControl& control) {
    solver_ = &solver;
    control_ = &control;
    exchange_.backend.native.clear();
    ran_ = 0;
}

Eigen::VectorXd StartSearch::start_of(int index, unsigned seed, const Eigen::VectorXd& relaxed) const {
    const Eigen::VectorXd& measured = problem_.model().start_design;
    switch (start_kind(measured.size() > 0, index)) {
        case StartKind::measured:
            return start_from(measured);
        case StartKind::relaxation:
            if (relaxed.size() > 0) return relaxed;
            [[fallthrough]];
        case StartKind::smoothest:
            return problem_.start();
        case StartKind::random:
            break;
    }
    return problem_.random_start(seed + static_cast<unsigned>(index));
}

/// A motion that the scene brings, with the dimensions any search starts from.
Eigen::VectorXd StartSearch::start_from(const Eigen::VectorXd& design) const {
    Eigen::VectorXd x = problem_.start();
    x.head(design.size()) = design.cwiseQuotient(design_scales(problem_.model()));
    return problem_.completed(x);
}

/// Whether the first starts are all there will be: then it is told why.
bool StartSearch::ends(int done) {
    if (done == 0) return false;
    std::optional<Termination> ending = control_->ending();
    if (!ending && !found() && control_->in_vain.passed()) ending = Termination::time_limit;
    if (ending) totals_.termination = *ending;
    return ending.has_value();
}

SolveControl StartSearch::beside_best(SolveControl control) const {
    if (best_.converged)
        control.known = [best = best_.found.x](const Eigen::VectorXd& x) { return is_beside(x, best); };
    return control;
}

/// Nothing where it ended beside the best that is known.
SearchState StartSearch::search(const Eigen::VectorXd& start, const SolveControl& control) {
    ExchangeOptions exchange = exchange_;
    // The rows active at the best minimum are likely those of a search that comes near it.
    if (best_.converged && best_.multipliers.size() > 0)
        exchange.backend.near = PathPoint{best_.found.x, best_.multipliers, 0.0, infinity};
    const Stopwatch watch;
    ExchangeResult ran = minimize_by_exchange(problem_, *solver_, start, exchange, control);
    seconds_ += {.solver = ran.seconds_solver, .judgement = watch.seconds() - ran.seconds_solver};
    totals_.rounds += ran.rounds;
    totals_.iterations += ran.iterations;
    if (ran.known) return {};
    totals_.termination = ran.termination;
    totals_.last = std::move(ran.last);
    SearchState search{ran.best, {}, ran.converged && ran.termination == Termination::converged};
    if (is_better(ran.latest, search.found, judge_.tolerance)) search.found = ran.latest;
    if (totals_.last.row_multipliers) search.multipliers = *totals_.last.row_multipliers;
    return search;
}

void StartSearch::keep(SearchState search) {
    if (search.found.x.size() == 0) return;
    const bool first = best_.found.x.size() == 0;
    if (first || is_better(search.found, best_.found, judge_.tolerance)) best_ = std::move(search);
}

StartsResult solve_from_starts(const PlannedRun& run, const CamModel& model, const Solver& solver) {
    return GeneralSolve(run, model, solver).run();
}

}  // namespace camopt

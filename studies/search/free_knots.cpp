// SPDX-License-Identifier: MIT
#include "studies/search/free_knots.hpp"

#include "scene/limit_table.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/search/free_knot_descent.hpp"
#include "studies/search/stroke_excursions.hpp"

#include <fmt/format.h>

#include <random>

namespace camopt {

namespace {

// Random segments are between this and 1 plus this, before they are brought to the length of the motion.
constexpr double shortest_random = 0.3;
// The lower bound for every curve is computed to rounding; this part of it is given away for that.
constexpr double limit_rounding = 1e-11;
// Of the seconds that the first breakpoints took: kept for the solve on the last ones.
constexpr double kept_for_last = 1.5;
// Steps of each start; the best one is then continued to the end. Later steps of a start gain little
// (quintic, 6 segments: 5e-7 each from the 40th to the 150th), another start more (4e-3).
constexpr int steps_of_start = 40;
// Part of the gap within which of the limit nothing is left to gain.
constexpr double nothing_left = 0.01;

// Pieces of the limit curve that are shorter than this part of the motion are rounding of ones that vanish.
constexpr double vanishing_piece = 1e-7;

/// The second half becomes the mirror image of the first one.
void mirror(std::vector<double>& points) {
    const std::size_t segments = points.size() - 1;
    const double length = points.back();
    for (std::size_t i = 0; i <= segments / 2; ++i) {
        points[segments - i] = length - points[i];
        if (2 * i == segments) points[i] = 0.5 * length;
    }
}

/// Between those that no search moves; mirrored where the motion is symmetric.
std::vector<double> random_breakpoints(const Scene& scene, unsigned seed) {
    std::vector<double> points = start_breakpoints(scene);
    const std::vector<double> held = held_breakpoints(scene);
    const std::size_t segments = points.size() - 1;
    std::mt19937 engine(seed);
    std::vector<double> widths(segments);
    for (std::size_t i = 0; i < segments; ++i) {
        const bool repeat = scene.motion.symmetric && 2 * i >= segments;
        // Plain arithmetic on the engine: the standard's distributions differ from library to library.
        widths[i] = repeat ? widths[segments - 1 - i]
                           : shortest_random + static_cast<double>(engine()) / 4294967295.0;
    }
    for (std::size_t first = 0, last = 1; last <= segments; ++last) {
        if (last < segments && std::ranges::find(held, points[last]) == held.end()) continue;
        double sum = 0.0;
        for (std::size_t i = first; i < last; ++i) sum += widths[i];
        const double length = points[last] - points[first];
        for (std::size_t i = first; i + 1 < last; ++i) points[i + 1] = points[i] + widths[i] * length / sum;
        first = last;
    }
    if (scene.motion.symmetric) mirror(points);
    return points;
}

/// The ends of the pieces of a curve, less those that vanish.
std::vector<double> pieces_of(const std::vector<double>& switches, double length) {
    std::vector<double> ends = {0.0};
    for (const double at : switches)
        if (at - ends.back() > vanishing_piece * length && length - at > vanishing_piece * length)
            ends.push_back(at);
    ends.push_back(length);
    return ends;
}

/// Into how many equal parts to cut each piece; empty: there are more pieces than segments, or, where the
/// parts are to be symmetric, an odd number of segments is left and no piece lies in the middle.
std::vector<int> parts_of(const std::vector<double>& ends, int segments, bool symmetric) {
    const std::size_t pieces = ends.size() - 1;
    std::vector<int> parts(pieces, 1);
    int left = segments - static_cast<int>(pieces);
    const bool one_in_the_middle = symmetric && left % 2 != 0;
    if (left < 0 || (one_in_the_middle && pieces % 2 == 0)) return {};
    if (one_in_the_middle) {
        ++parts[pieces / 2];
        --left;
    }
    for (; left > 0; left -= symmetric ? 2 : 1) {
        std::size_t longest = 0;
        const auto width = [&](std::size_t i) { return (ends[i + 1] - ends[i]) / parts[i]; };
        for (std::size_t i = 1; i < pieces; ++i)
            if (width(i) > width(longest)) longest = i;
        ++parts[longest];
        if (symmetric) ++parts[pieces - 1 - longest];
    }
    return parts;
}

bool limits_peaks_alone(const Scene& scene) {
    return scene.motion.via.empty() && scene.motion.corridors.empty() && scene.own_limits.empty() &&
           !(scene.cam && scene.cam->face_half_width) &&
           std::ranges::none_of(
               peak_limit_rows(),
               [&](const PeakLimitRow& row) { return row.side != 0 && row.in(scene.limits).has_value(); }) &&
           std::ranges::none_of(limit_rows(),
                                [&](const LimitRow& row) { return row.in(scene.limits).has_value(); });
}

/// Whether a motion of the search keeps to the ranges of its strokes.
bool holds_strokes(const PlannedRun& run, const FreeKnotResult& found) {
    const CamProblem& problem = *found.problem;
    return !run.plan.strokes_first_free ||
           !leaves_its_strokes(run.posed.scene, problem.model().design, problem.motion(found.found.x));
}

struct FreeKnotSearch {
    FreeKnotResult best;
    int starts = 0, steps = 0, rounds = 0, iterations = 0;
    EvaluationCounts evaluations;
};

/// The starts one after the other, the first from the motion of `first`; in units of the posed objective
/// until the best is handed out.
class BreakpointSearch {
 public:
    BreakpointSearch(const PlannedRun& run, const Solution& first, const SolveControl& control)
        : run_(run), scene_(run.posed.scene), first_(first), control_(control) {
        options_.exchange = exchange_options(scene_);
        options_.exchange.backend.native.clear();  // they belong to the backend the user chose
        options_.tolerance = scene_.solver.tolerance;
        if (!first.any_curve_limit) return;
        const double limit = first.any_curve_limit->objective / run.posed.units.cost;
        options_.enough = limit + nothing_left * scene_.solver.wanted_gap() * std::max(1.0, limit);
    }

    FreeKnotSearch run() {
        for (int k = 0; k < run_.plan.starts; ++k) {
            if (const std::optional<Termination> ending = control_.ending()) {
                search_.best.termination = *ending;
                break;
            }
            options_.most_steps = steps_of_start;
            take(descent(k));
            ++search_.starts;
            if (reached_limit()) break;
        }
        if (search_.best.termination == Termination::iteration_limit && !reached_limit()) continue_best();
        search_.best.found.objective *= run_.posed.units.cost;
        search_.evaluations = solver_.counts();
        return std::move(search_);
    }

 private:
    const PlannedRun& run_;
    const Scene& scene_;
    const Solution& first_;
    const SolveControl& control_;
    CountingSolver solver_{make_structured_solver()};
    FreeKnotOptions options_;
    HeldStrokes strokes_;
    FreeKnotSearch search_;

    [[nodiscard]] bool reached_limit() const {
        const Candidate& best = search_.best.found;
        return best.violation <= scene_.solver.tolerance && best.objective <= options_.enough;
    }

    /// From where its steps ended.
    void continue_best() {
        if (const std::optional<Termination> ending = control_.ending()) {
            search_.best.termination = *ending;
            return;
        }
        options_.most_steps = FreeKnotOptions().most_steps - steps_of_start;
        const MotionChain motion = search_.best.problem->motion(search_.best.found.x);
        FreeKnotResult result = descent_from(search_.best.breakpoints, &motion);
        const bool worse = result.found.x.size() == 0 ||
                           is_better(search_.best.found, result.found, scene_.solver.tolerance);
        if (!worse) search_.best = std::move(result);
    }

    FreeKnotResult descent(int index) {
        if (index == 0) return descent_from(start_breakpoints(scene_), first_.motion.get());
        return descent_from(random_breakpoints(scene_, run_.plan.seed + static_cast<unsigned>(index)),
                            nullptr);
    }

    FreeKnotResult descent_from(const std::vector<double>& points, const MotionChain* start) {
        const MovingBreakpoints moving(scene_, run_.posed.reference, strokes_, points, run_.posed.units);
        FreeKnotResult result = descend(moving, start, solver_, options_, control_);
        search_.steps += result.steps;
        search_.rounds += result.rounds;
        search_.iterations += result.iterations;
        if (strokes_.held || !run_.plan.strokes_first_free || result.found.x.size() == 0) return result;
        if (holds_strokes(run_, result)) return result;
        strokes_.held = true;
        return descent_from(points, start);
    }

    void take(FreeKnotResult result) {
        if (result.found.x.size() == 0) return;
        const bool first = search_.best.found.x.size() == 0;
        if (first || is_better(result.found, search_.best.found, scene_.solver.tolerance))
            search_.best = std::move(result);
    }
};

void add(EvaluationCounts& to, const EvaluationCounts& more) {
    to.cost += more.cost;
    to.gradient += more.gradient;
    to.constraints += more.constraints;
    to.jacobian += more.jacobian;
    to.hessian += more.hessian;
    to.profile_points += more.profile_points;
}

/// With a motion that stood the audit.
bool is_delivered(const Solution& solution) {
    return solution.motion != nullptr && solution.certificate.verdict != Verdict::failed;
}

/// From a verdict for fixed breakpoints to one for free ones.
void judge_freely(Solution& solution, const FreeKnotSearch& search, const Scene& scene) {
    Certificate& certificate = solution.certificate;
    const std::optional<double> gap = certificate.gap;
    forget_proof(certificate);
    solution.solver.proof_source.clear();
    if (!is_delivered(solution)) {
        solution.conflict.clear();
        if (solution.motion) return;  // the audit has said what is wrong with it
        const bool impossible = no_motion_keeps_all_caps(scene);
        const Termination ended = search.best.termination;
        certificate.verdict = impossible ? Verdict::infeasible : Verdict::failed;
        certificate.reason = impossible           ? Reason::limits_contradict
                             : was_stopped(ended) ? reason_of(ended)
                                                  : Reason::no_feasible_point;
        if (impossible) certificate.proof_kind = ProofKind::any_curve_limit;
        solution.notes.emplace_back(
            impossible ? "no curve satisfies all limits on its peaks, regardless of the breakpoints"
                       : "no motion was found on any breakpoints tried; infeasibility is not proved");
        return;
    }
    certificate.stationarity = search.best.stationarity;
    if (solution.any_curve_limit) {
        const double limit = solution.any_curve_limit->objective;
        certificate.lower_bound = limit - limit_rounding * std::abs(limit);
        certificate.gap = relative_gap(certificate.objective, *certificate.lower_bound);
        certificate.proof_kind = ProofKind::any_curve_limit;
    }
    const JudgeOptions judge{scene.solver.tolerance, scene.solver.wanted_gap()};
    settle_verdict(certificate, search.best.termination, judge);
    if (gap && *gap <= scene.solver.wanted_gap() && certificate.verdict != Verdict::optimal) {
        solution.notes.push_back(fmt::format(
            "proved: no spline of these breakpoints is better (gap {:.1e}); other breakpoints may be", *gap));
    }
}

/// What is said of a solution on breakpoints that were found by `search`.
void report_search(Solution& solution, const FreeKnotSearch& search, const Scene& scene, std::string_view how,
                   std::string note) {
    set_scene(solution, scene);
    solution.solver.convex = false;
    solution.solver.starts = search.starts;
    if (search.starts > 0) solution.notes.push_back(std::move(note));
    judge_freely(solution, search, scene);
    if (!solution.solver.choice.empty())
        solution.solver.choice = fmt::format("the breakpoints are free: {}, and for given breakpoints: {}",
                                             how, solution.solver.choice);
}

void report_breakpoints(Solution& solution, const std::vector<double>& points) {
    if (!solution.motion) return;
    std::vector<std::string> names;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) names.push_back(fmt::format("x[{}]", k));
    add_to_design(solution, std::move(names), std::span(points).subspan(1, points.size() - 2));
}

/// The motion that a search ended at, where no time is left to solve on its breakpoints.
void deliver_found(Solution& solution, const FreeKnotResult& found) {
    withdraw_motion(solution);
    solution.design.names.clear();
    solution.conflict.clear();
    solution.certificate.objective = found.found.objective;
    solution.certificate.worst_violation = found.found.violation;
    solution.certificate.verdict = Verdict::feasible;
    solution.certificate.gap.reset();
    solution.family = found.problem->family();
    report_motion(solution, *found.problem, found.found.x);
}

/// On the switching points of the limit curve, if they make an optimum.
std::optional<Solution> solve_on_limit_curve(const PlannedRun& run, const SolveScene& solve) {
    const Scene& scene = run.posed.scene;
    const std::vector<double> points = limit_breakpoints(scene, run.posed.reference);
    if (points.empty()) return {};
    Solution solution = solve(with_breakpoints(scene, points), run.control);
    FreeKnotSearch nothing_searched;
    nothing_searched.starts = 1;
    nothing_searched.best.stationarity = solution.certificate.stationarity.value_or(infinity);
    report_search(solution, nothing_searched, scene,
                  "they are the switching points of the best of all curves",
                  "free breakpoints: the switching points of the curve that reaches the limit of any curve");
    if (solution.certificate.verdict != Verdict::optimal) return {};
    report_breakpoints(solution, points);
    return solution;
}

}  // namespace

std::vector<double> limit_breakpoints(const Scene& scene, const Peaks& reference) {
    const SplineSpec& spline = scene.spline;
    const bool holds_the_curve = spline.smoothness() == 2 && spline.rest == 2;
    if (!holds_the_curve || !limits_peaks_alone(scene)) return {};
    const std::vector<double> switches = limit_switches(scene, reference);
    if (switches.empty()) return {};
    const std::vector<double> ends = pieces_of(switches, scene.motion.length());
    const std::vector<int> parts = parts_of(ends, segments_of(spline), scene.motion.symmetric);
    std::vector<double> points;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (int k = 0; k < parts[i]; ++k) points.push_back(ends[i] + (ends[i + 1] - ends[i]) * k / parts[i]);
    if (points.empty()) return {};
    points.push_back(ends.back());
    if (scene.motion.symmetric) mirror(points);
    return points;
}

Solution solve_free_knots(const PlannedRun& run, const SolveScene& solve) {
    const Scene& scene = run.posed.scene;
    const SolveControl& control = run.control;
    const Stopwatch watch;
    if (std::optional<Solution> solution = solve_on_limit_curve(run, solve)) {
        solution->seconds_total = solution->seconds_solve = watch.seconds();
        return std::move(*solution);
    }
    std::vector<double> points = start_breakpoints(scene);
    Solution solution = solve(with_breakpoints(scene, points), control);
    double at_start = infinity;
    if (is_delivered(solution)) at_start = solution.certificate.objective;
    const double searching = control.deadline.seconds_left() - kept_for_last * watch.seconds();
    FreeKnotSearch search;
    if (!no_motion_keeps_all_caps(scene)) {
        const SolveControl timed = control.sooner(searching);
        search = BreakpointSearch(run, solution, timed).run();
    }
    const FreeKnotResult& best = search.best;
    if (best.found.x.size() > 0 && best.found.violation <= scene.solver.tolerance &&
        best.found.objective < at_start) {
        Solution better = solve(with_breakpoints(scene, best.breakpoints), control);
        add(better.evaluations, solution.evaluations);
        const double allowance = scene.solver.wanted_gap() * std::max(1.0, std::abs(best.found.objective));
        if (is_delivered(better) && better.certificate.objective <= best.found.objective + allowance) {
            if (better.certificate.objective < at_start) {
                solution = std::move(better);
                points = best.breakpoints;
            }
        } else if (holds_strokes(run, best)) {
            // Stopped, or a problem that is not convex, of which the search found a better minimum.
            deliver_found(solution, best);
            solution.evaluations = better.evaluations;
            points = best.breakpoints;
            search.best.termination = control.ending().value_or(best.termination);
        } else {
            // What is delivered is another motion, of which the search says nothing.
            search.best.stationarity = infinity;
            search.best.termination = control.ending().value_or(Termination::numerical_failure);
        }
    }
    add(solution.evaluations, search.evaluations);
    solution.solver.iterations += search.iterations;
    solution.solver.exchange_rounds += search.rounds;
    report_search(
        solution, search, scene, "the structured solver moves them",
        fmt::format("free breakpoints: {} starts and {} steps, by the structured solver; objective {} on the "
                    "first breakpoints",
                    search.starts, search.steps,
                    at_start < infinity ? fmt::format("{:.9g}", at_start) : std::string("unknown")));
    report_breakpoints(solution, points);
    solution.seconds_total = solution.seconds_solve = watch.seconds();
    return solution;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/search/planned_solve.hpp"

#include "scene/written_limits.hpp"
#include "solvers/registry.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/made_limits.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/measured/given_motion.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/search/free_angles.hpp"
#include "studies/search/free_knots.hpp"
#include "studies/search/free_transmission.hpp"
#include "studies/search/presolve.hpp"
#include "studies/search/solve_motion.hpp"
#include "studies/search/stroke_directions.hpp"
#include "studies/search/stroke_excursions.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// With tolerances: cams between their ends that pass a limit join those that it is held for, and the scene
/// is solved again. A round takes what is left to its square.
Solution solve_for_made_cams(const Scene& scene, const SolveControl& timed, KnownSolutions* known,
                             const PlanOptions& options) {
    constexpr int most_rounds = 6;
    Solution solution = solve_planned(scene, timed, known, options);
    if (!scene.tolerance || options.look) return solution;
    Scene held = scene;
    for (int round = 0; round < most_rounds && solution.motion && !timed.ending(); ++round) {
        const std::vector<MadeParts> more = passing_cams(solution);
        if (more.empty()) break;
        if (known != nullptr) known->optima.withdraw();
        held.tolerance->between.insert(held.tolerance->between.end(), more.begin(), more.end());
        solution = solve_planned(held, timed, nullptr, options);
    }
    return solution;
}

Solution solve_and_audit(const Scene& scene, const SolveControl& timed, KnownSolutions* known,
                         const PlanOptions& options) {
    if (scene.is_given()) return given_solution(scene);
    std::optional<MeasuredReport> measured;
    if (scene.measured) measured = measured_report(scene, reference_peaks(scene));
    Solution solution = solve_for_made_cams(scene, timed, known, options);
    if (measured) {
        measured->started = began_from_measured(solution);
        solution.measured = std::move(measured);
    }
    const Stopwatch watch;
    if (!options.look) {
        audit_delivered(solution);
        // It exists even where it violates a limit.
        if (scene.motion.prescribed() && show_nearest(solution, timed))
            solution.certificate.objective = defined_objective(solution);
    }
    solution.family.reset();
    solution.phases.report += watch.seconds();
    return solution;
}

/// The best motion whose cam can be built, with the bound of all motions.
std::optional<Solution> buildable_optimum(const Scene& scene, const Solution& unbuilt,
                                          const SolveControl& timed, const PlanOptions& options) {
    if (scene.measured || scene.tolerance) return std::nullopt;
    Scene held = scene;
    held.motion.reach = buildable_reach(unbuilt);
    if (!held.motion.reach || timed.ending()) return std::nullopt;
    // Solved again for its bound, which a failed audit has dropped; copies for every audit would cost more.
    const Solution any = solve_planned(scene, timed, nullptr, options);
    Solution found = solve_planned(held, timed, nullptr, options);
    if (!found.motion || !any.certificate.lower_bound) return std::nullopt;
    settle_by_relaxation(found.certificate, any.certificate, scene.solver.wanted_gap(found.solver.convex));
    found.scene.motion.reach.reset();
    found.solver.proof_source = any.solver.proof_source;
    audit_delivered(found);
    if (found.certificate.verdict == Verdict::failed) return std::nullopt;
    found.family.reset();
    found.notes.emplace_back(
        "the first optimum leaves the range of the cam; this is the best motion whose cam can be built");
    return found;
}

/// Whether no design vector was asked for, and another than that of the solution is left.
bool may_take_coefficients(const Scene& scene, const Solution& solution) {
    return scene.spline.design == DesignKind::automatic && solution.plan->design == DesignKind::states;
}

/// Another optimum than the one that was found may be deliverable. Where doubles do not represent that: the
/// first, where conditions nearly contradict and the smoothest is none, or that of B-spline coefficients,
/// which are smooth without conditions. Where its cam cannot be built: the smoothest, or the best within the
/// range of the cam.
std::optional<Solution> deliverable_optimum(const Scene& scene, const Solution& solution,
                                            const SolveControl& timed, bool explain) {
    const bool tied = scene.objective.tie_break != TieBreak::none;
    const bool unbuilt = solution.certificate.reason == Reason::cam_cannot_be_built;
    if (!unbuilt && !is_no_motion(solution.certificate.reason)) return std::nullopt;
    Scene other = scene;
    const auto solved = [&](const char* note) -> std::optional<Solution> {
        if (timed.ending()) return std::nullopt;
        Solution found = solve_and_audit(other, timed, nullptr, {.explain = explain});
        if (found.certificate.verdict == Verdict::failed) return std::nullopt;
        found.scene.objective.tie_break = scene.objective.tie_break;
        found.scene.spline.design = scene.spline.design;
        found.notes.emplace_back(note);
        return found;
    };
    if (unbuilt) {
        other.objective.tie_break = TieBreak::rms_jerk;
        if (!tied)
            if (auto found =
                    solved("tie-break by jerk: the first optimum leaves the range of the cam; this is "
                           "the smoothest"))
                return found;
        return buildable_optimum(scene, solution, timed, {.explain = explain});
    }
    if (tied) {
        other.objective.tie_break = TieBreak::none;
        if (auto found =
                solved("no tie-break: double precision cannot represent the smoothest of the optima; "
                       "this is another optimum"))
            return found;
    }
    if (!may_take_coefficients(scene, solution)) return std::nullopt;
    other.spline.design = DesignKind::coefficients;
    return solved(
        "double precision cannot represent what was found for the states at the breakpoints; this was found "
        "for B-spline coefficients");
}

/// What the states at the breakpoints leave undecided, or a violation that is worth something, may be settled
/// for B-spline coefficients, whose boxes and rows have other numbers. In twice the time of the first, or a
/// second. What doubles do not represent was tried with them before (deliverable_optimum).
std::optional<Solution> settled_by_coefficients(const Scene& scene, const Solution& solution, double seconds,
                                                const SolveControl& timed, const PlanOptions& options) {
    constexpr double least_seconds = 1.0, times_as_long = 2.0;
    const Certificate& certificate = solution.certificate;
    const bool settled = is_proved(certificate) || certificate.reason == Reason::given_cam ||
                         certificate.reason == Reason::unbounded || is_no_motion(certificate.reason);
    if (settled || options.look || timed.ending() || !solution.plan || !solution.plan->convex ||
        !may_take_coefficients(scene, solution))
        return std::nullopt;
    Scene other = scene;
    other.spline.design = DesignKind::coefficients;
    Solution found = solve_and_audit(other, timed.sooner(std::max(least_seconds, times_as_long * seconds)),
                                     nullptr, options);
    if (!is_proved(found.certificate)) return std::nullopt;
    found.scene.spline.design = scene.spline.design;
    found.notes.emplace_back(
        "the states at the breakpoints leave this scene undecided; it was settled for B-spline coefficients");
    return found;
}

/// What the clock ended depends on the machine: that must be told.
void note_time_limit(Solution& solution) {
    const std::string note = fmt::format(
        "the time (solver.max_seconds = {:g}) ran out: the result depends on the machine, "
        "and more time may change the result",
        solution.scene.solver.max_seconds);
    if (std::ranges::find(solution.notes, note) == solution.notes.end()) solution.notes.push_back(note);
}

}  // namespace

bool show_nearest(Solution& solution, const SolveControl& control) {
    const Scene& scene = solution.scene;
    const bool to_show = solution.certificate.verdict == Verdict::infeasible && !solution.motion;
    if (!to_show || searches_angles(scene) || scene.spline.free_knots) return false;
    CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    if (!model.design.contradictions().empty()) return false;
    CamProblem problem(std::move(model));
    Eigen::VectorXd x = problem.start();
    if (x.size() > 0)
        if (Feasibility least = find_feasible(problem, exchange_options(scene), control);
            least.point.x.size() > 0)
            x = std::move(least.point.x);
    if (control.ending() && !scene.motion.prescribed()) return false;
    report_motion(solution, problem, x);
    if (cam_can_be_built(solution)) return true;
    withdraw_motion(solution);
    return false;
}

Solution solve_planned(const Scene& scene, const SolveControl& control, KnownSolutions* known,
                       const PlanOptions& options) {
    const Stopwatch watch;
    PosedScene posed(scene);
    const auto plan = std::make_shared<const SolvePlan>(plan_of(posed, options));
    SolveControl timed = control;
    if (plan->searching < 1.0)
        timed.in_vain = control.deadline.sooner(plan->searching * control.deadline.seconds_left());
    KnownSolutions none;
    bool leaves_strokes = false;
    const bool may_end = plan->strokes_first_free && plan->breakpoints == 0;
    const PlannedRun run{posed, *plan, timed, known != nullptr ? *known : none,
                         may_end ? &leaves_strokes : nullptr};
    const double seconds_posed = watch.seconds();
    Solution solution;
    const SolveScene solve_given = [](const Scene& one, const SolveControl& of_one) {
        return solve_planned(one, of_one);  // each set of numbers by its own plan
    };
    if (plan->transmission) {
        solution = solve_free_transmission(scene, timed, solve_given);
    } else if (plan->angles > 0) {
        solution = solve_free_angles(scene, *plan, timed, solve_given);
    } else {
        solution = plan->breakpoints > 0 ? solve_free_knots(run,
                                                            [](const Scene& one, const SolveControl& of_one) {
                                                                return solve_without_explaining(one, of_one);
                                                            })
                                         : solve_motion(run);
        const bool unbounded = solution.certificate.reason == Reason::unbounded;  // a lost area may be
        // Of free breakpoints those of every solve hold their strokes.
        if (may_end && (leaves_strokes || unbounded || leaves_its_strokes(solution))) {
            run.known.optima.withdraw();
            Solution held = solve_stroke_directions(posed.scene, timed);
            take_bound_of_relaxation(held, solution);
            solution = std::move(held);
        }
        if (plan->breakpoints == 0) posed.restore(solution);
    }
    solution.plan = plan;
    solution.phases.setup += seconds_posed;
    solution.phases.search = 0.0;  // of the solve within that was delivered
    double delivered = 0.0;
    for (const PhaseRow& phase : phase_rows) delivered += solution.phases.*phase.seconds;
    solution.phases.search = std::max(0.0, watch.seconds() - delivered);
    // A search without time left is no finding that there is no point, also where another one ended last.
    std::optional<Termination> ended = timed.ending();
    if (!ended && timed.in_vain.passed()) ended = Termination::time_limit;
    if (solution.certificate.reason == Reason::no_feasible_point && ended)
        solution.certificate.reason = reason_of(*ended);
    return solution;
}

Solution solve_without_explaining(const Scene& given, const SolveControl& control, KnownSolutions* known,
                                  const PlanOptions& options) {
    const Scene scene = valid_scene(given);
    if (known != nullptr) {
        known->optima.withdraw();
        std::optional<Solution> proved = known->optima.proved(scene, [](const Solution& solution) {
            return !solution.family || !leaves_its_strokes(solution);  // none: the motion of a solution
        });
        if (proved) {
            proved->family.reset();
            return std::move(*proved);
        }
    }
    const SolveControl timed = control.sooner(scene.solver.max_seconds);
    const Stopwatch watch;
    Solution solution = solve_and_audit(scene, timed, known, options);
    std::optional<Solution> other = deliverable_optimum(scene, solution, timed, options.explain);
    if (!other) other = settled_by_coefficients(scene, solution, watch.seconds(), timed, options);
    if (other) {
        solution = std::move(*other);
        if (known != nullptr) known->optima.withdraw();
    }
    if (known != nullptr) known->optima.settle(solution, known->number);
    if (timed.deadline.was_felt()) note_time_limit(solution);
    return solution;
}

}  // namespace camopt

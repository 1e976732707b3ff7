// SPDX-License-Identifier: MIT
#include "studies/search/solve_without_explaining.hpp"

#include "core/errors.hpp"
#include "objectives/free_knots/free_knot_problem.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "scene/cost_table.hpp"
#include "scene/written_limits.hpp"
#include "solvers/certificate/certificate.hpp"
#include "solvers/exchange/exchange.hpp"
#include "solvers/registry.hpp"
#include "solvers/solver.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/search/backend_choice.hpp"
#include "studies/search/contradiction.hpp"
#include "studies/search/cost_scale.hpp"
#include "studies/search/limit_curve.hpp"
#include "studies/search/program/solve_free_angles.hpp"
#include "studies/search/rest_conflict.hpp"
#include "studies/search/solve_free_knots.hpp"
#include "studies/search/solve_from_starts.hpp"
#include "studies/search/solve_held_strokes.hpp"
#include "studies/search/tie_break.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace camopt {

namespace {

/// The model of a scene, each form of it made once: who is to solve it is asked of the same that is solved.
class SceneModels {
 public:
    SceneModels(const Scene& scene, const Peaks& reference, const HeldStrokes& strokes = {})
        : scene_(scene), reference_(reference), strokes_(strokes) {}

    [[nodiscard]] const CamModel& with_states() {
        if (!with_states_) with_states_ = scene_model(scene_, DesignKind::states, reference_, strokes_);
        return *with_states_;
    }
    /// To be kept; it is made anew if it is asked for again.
    [[nodiscard]] CamModel taken(DesignKind kind) {
        if (kind != DesignKind::states || !with_states_)
            return scene_model(scene_, kind, reference_, strokes_);
        CamModel model = std::move(*with_states_);
        with_states_.reset();
        return model;
    }

 private:
    const Scene& scene_;
    const Peaks& reference_;
    HeldStrokes strokes_;
    std::optional<CamModel> with_states_;
};

/// Who solves a problem that is not convex: Ipopt where this build has it.
std::string general_solver() {
    for (const SolverEntry& entry : solver_entries()) {
        if (entry.name == "ipopt" && entry.available) return entry.name;
    }
    return "structured";
}

bool is_general(const Scene& scene, SceneModels& models) {
    const bool own = !scene.own_terms.empty() || !scene.own_limits.empty();
    return (scene.cam.has_value() || scene.objective.torque > 0.0 || own) &&
           needs_starts(models.with_states());
}

// A proof that comes at all comes within these; where doubles end, more of either only take time.
constexpr int most_rounds_of_next = 20, most_iterations_of_next = 200;

/// A convex scene whose solver was chosen for it has a proof, unless its numbers are hard: then another
/// backend tries from the same grid. It counts where it proves more.
void try_next_backend(CamProblem& problem, const JudgeOptions& judge, Solution& solution,
                      ContinuousResult& result, const SolveControl& control) {
    const Verdict verdict = result.certificate.verdict;
    const bool proved = verdict == Verdict::optimal || verdict == Verdict::infeasible;
    const std::string next = general_solver();
    if (proved || solution.scene.solver.name != "auto" || next == solution.solver.name || control.ending())
        return;
    ExchangeOptions exchange = exchange_options(solution.scene);
    exchange.backend.native.clear();  // they belong to the first backend
    exchange.backend.max_iterations = std::min(exchange.backend.max_iterations, most_iterations_of_next);
    exchange.most_rounds = std::min(exchange.most_rounds, most_rounds_of_next);
    ContinuousResult other = solve_continuous(problem, *make_solver(next), exchange, judge, control);
    solution.notes.push_back(fmt::format("{} ended without a proof ({}); {} was tried next",
                                         solution.solver.name, name_of(result.certificate.reason), next));
    if (other.certificate.verdict >= verdict) return;
    result = std::move(other);
    solution.solver.name = next;
}

ContinuousResult solve_problem(CamProblem& problem, const Solver& solver, Solution& solution,
                               SceneModels& models, const SolveControl& control, GridMemory* memory) {
    const Scene& scene = solution.scene;
    const JudgeOptions judge{scene.solver.tolerance, scene.solver.wanted_gap(!needs_starts(problem.model()))};
    if (!needs_starts(problem.model())) {
        ContinuousResult result = solve_continuous(problem, solver, exchange_options(scene), judge, control);
        try_next_backend(problem, judge, solution, result, control);
        if (memory != nullptr) memory->keep(problem);
        GridMemory* const looking = memory != nullptr && memory->only_looks ? memory : nullptr;
        if (wants_tie_break(scene, result.certificate)) break_tie(problem, scene, result, control, looking);
        return result;
    }
    StartsResult all = solve_from_starts(
        problem.model(), solver, exchange_options(scene), judge, scene.solver.starts.value_or(default_starts),
        scene.solver.seed, control, [&] { return models.taken(DesignKind::coefficients); }, memory);
    solution.solver.convex = false;
    solution.solver.starts = all.starts;
    const int planned = scene.solver.starts.value_or(default_starts);
    if (all.starts > 0 && all.starts < planned && control.stopped())
        solution.notes.push_back(
            fmt::format("interrupted in the search: {} of {} starts were run", all.starts, planned));
    if (all.starts == 0) solution.solver.name = "structured";  // the relaxation settled it
    if (all.starts == 0 && all.result.certificate.verdict == Verdict::optimal) {
        if (wants_tie_break(scene, all.result.certificate))
            break_tie(problem, scene, all.result, control, memory);
        solution.notes.emplace_back(
            "the limits that are not convex are inactive: the optimum without them satisfies them, so it is "
            "the "
            "optimum of the whole");
    }
    return std::move(all.result);
}

BackendChoice chosen_backend(const Scene& scene, SceneModels& models) {
    BackendChoice choice{scene.solver.name, {}, scene.spline.design};
    const bool general = choice.solver == "auto" && is_general(scene, models);
    if (choice.solver == "auto") {
        choice.solver = general ? general_solver() : "structured";
        choice.reason =
            general
                ? "a limit or the torque term of this scene is not convex: a convex relaxation decides it or "
                  "gives a bound, and then several starts search for the best motion"
                : "every rule of this scene is linear or convex in the design vector and its cost is convex, "
                  "so the structured interior point finds and proves the global optimum";
    }
    if (choice.design == DesignKind::automatic) {
        // NLopt works on dense matrices and handles equalities badly: fewest variables, ends built in.
        const bool dense = choice.solver.starts_with("nlopt.");
        choice.design = dense ? DesignKind::coefficients : DesignKind::states;
    }
    return choice;
}

/// A scene whose objective is near one (CostScale), its strokes held or not.
Solution solve_directed(const Scene& scene, const Peaks& reference, const SolveControl& control,
                        GridMemory* memory, const HeldStrokes& strokes) {
    const Stopwatch watch;
    Solution solution;
    solution.scene = scene;
    SceneModels models(scene, reference, strokes);
    const BackendChoice choice = chosen_backend(scene, models);
    CountingSolver solver(make_solver(choice.solver));
    check_native_options(choice.solver, scene.solver.options);
    solution.reference_peaks = reference;
    solution.any_curve_limit = limit_curve(scene, solution.reference_peaks);
    solution.solver.name = choice.solver;
    solution.solver.choice = choice.reason;
    solution.design.kind = choice.design;

    CamModel model = models.taken(choice.design);
    if (scene.measured && scene.measured->start && model.design.contradictions().empty())
        model.start_design = nearest_design(model.design, scene.motion, *scene.measured);
    CamProblem problem = memory != nullptr ? memory->problem(std::move(model)) : CamProblem(std::move(model));
    const MotionFamily& design = problem.model().design;
    for (const ConditionConflict& conflict : design.redundant()) {
        solution.notes.push_back(conflict.condition + " follows from the other conditions" +
                                 (conflict.others.empty() ? "" : ": " + list_of(conflict)));
    }
    if (!design.contradictions().empty()) {
        report_contradictions(solution, design);
        solution.seconds_total = watch.seconds();
        return solution;
    }
    if (report_rest_conflict(solution, problem.model())) {
        solution.seconds_total = watch.seconds();
        return solution;
    }
    const Stopwatch solve_watch;
    ContinuousResult result = solve_problem(problem, solver, solution, models, control, memory);
    solution.seconds_solve = solve_watch.seconds();

    solution.certificate = std::move(result.certificate);
    solution.solver.termination = result.exchange.termination;
    solution.solver.native_status = result.exchange.last.native_status;
    solution.solver.iterations = result.exchange.iterations;
    solution.solver.exchange_rounds = result.exchange.rounds;
    solution.solver.proof_source = result.proof_source;
    solution.evaluations = solver.counts();
    if (problem.model().cam) solution.evaluations.profile_points = *problem.model().cam->profile_points;
    if (result.x.size() > 0) report_motion(solution, problem, result.x);
    if (solution.certificate.verdict == Verdict::infeasible) report_conflict(solution);
    solution.seconds_total = watch.seconds();
    return solution;
}

Solution solve_scaled(const Scene& scene, const Peaks& reference, const SolveControl& control,
                      GridMemory* memory) {
    Solution first = solve_directed(scene, reference, control, memory, {});
    if (!leaves_its_strokes(first)) return first;
    Solution held = solve_held_strokes(
        scene,
        [&](const HeldStrokes& strokes) {
            return solve_directed(scene, reference, control, nullptr, strokes);
        },
        control);
    take_bound_of_relaxation(held, first);
    return held;
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

BackendChoice choose_backend(const Scene& scene) {
    const Peaks reference = reference_peaks(scene);
    SceneModels models(scene, reference);
    return chosen_backend(scene, models);
}

namespace {

/// Where the best breakpoints make a motion that leaves its lift: the best one on them that does not.
Solution solve_free_knots_held(const Scene& scene, const Peaks& reference, const SolveControl& control) {
    Solution first = solve_free_knots(scene, control);
    if (!leaves_its_strokes(first)) return first;
    const Scene fixed = with_breakpoints(scene, first.curve->space().breakpoints());
    Solution held = solve_directed(fixed, reference, control, nullptr, {.held = true});
    held.scene = scene;
    if (held.certificate.verdict == Verdict::infeasible) held.certificate.verdict = Verdict::failed;
    if (held.certificate.verdict == Verdict::failed) held.certificate.reason = Reason::no_feasible_point;
    if (held.certificate.verdict == Verdict::optimal) {
        held.certificate.verdict = Verdict::feasible;  // of these breakpoints alone
        held.certificate.reason = Reason::converged;
    }
    forget_proof(held.certificate);
    take_bound_of_relaxation(held, first);
    return held;
}

/// A scene whose angles are given.
Solution solve_for_angles(const Scene& scene, const SolveControl& timed, GridMemory* memory) {
    const Peaks reference = reference_peaks(scene);
    const CostScale scale(scene, reference);
    Solution solution =
        scene.spline.free_knots
            ? solve_free_knots_held(scale.scaled(), reference, timed)
            : solve_scaled(scale.scaled(), scale.is_idle() ? reference : reference_peaks(scale.scaled()),
                           timed, memory);
    if (!scale.is_idle()) scale.restore(solution, scene, reference);
    return solution;
}

/// Solved and audited.
Solution solve_and_audit(const Scene& scene, const SolveControl& timed, GridMemory* memory) {
    std::optional<MeasuredReport> measured;
    if (scene.measured) measured = measured_report(scene, reference_peaks(scene));
    const auto for_angles = [&](const Scene& one) { return solve_for_angles(one, timed, nullptr); };
    Solution solution = searches_angles(scene) ? solve_free_angles(scene, for_angles, timed)
                                               : solve_for_angles(scene, timed, memory);
    if (measured) {
        measured->started = began_from_measured(solution);
        solution.measured = std::move(measured);
    }
    const bool looks = memory != nullptr && memory->only_looks;
    if (!looks) audit_delivered(solution);
    return solution;
}

/// Where conditions nearly contradict, the smoothest of the optima may be one that doubles do not hold though
/// they hold the first that was found: that one is delivered then.
std::optional<Solution> without_tie_break(const Scene& scene, const Solution& solution,
                                          const SolveControl& timed) {
    const bool held = !is_no_motion(solution.certificate.reason);
    if (held || scene.objective.tie_break == TieBreak::none || timed.ending()) return std::nullopt;
    Scene plain = scene;
    plain.objective.tie_break = TieBreak::none;
    Solution first = solve_and_audit(plain, timed, nullptr);
    if (!first.motion || first.certificate.verdict == Verdict::failed) return std::nullopt;
    first.scene.objective.tie_break = scene.objective.tie_break;
    first.notes.emplace_back(
        "no tie-break: double precision cannot represent the smoothest of the optima; this is another "
        "optimum");
    return first;
}

}  // namespace

Solution solve_without_explaining(const Scene& given, const SolveControl& control, GridMemory* memory) {
    const Scene scene = with_written_limits(given);
    validate(scene);
    const SolveControl timed = control.sooner(scene.solver.max_seconds);
    Solution solution = solve_and_audit(scene, timed, memory);
    if (std::optional<Solution> first = without_tie_break(scene, solution, timed))
        solution = std::move(*first);
    if (timed.deadline.was_felt()) note_time_limit(solution);
    return solution;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/solve.hpp"

#include "core/errors.hpp"
#include "motions/any_curve_limit.hpp"
#include "objectives/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/continuous_solve.hpp"
#include "solvers/counting_solver.hpp"
#include "solvers/registry.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "splines/extrema.hpp"
#include "studies/relaxation.hpp"
#include "studies/solution_report.hpp"
#include "studies/solve_from_starts.hpp"
#include "studies/solve_without_explaining.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace camopt {

namespace {

using Clock = std::chrono::steady_clock;

// Searches where the problem is not convex and the scene does not say how many.
constexpr int default_starts = 8;
// Weights of the tie-break, tried until the objective stays within the tolerance of its optimum.
constexpr std::array<double, 4> tie_break_weights = {1e-4, 1e-5, 1e-6, 1e-7};
// In lifts: a control point of a motion lies within a few.
constexpr double farthest_control_point = 1e3;
// The tie-break must be solved more exactly than the tolerance it may spend.
constexpr double tie_break_accuracy = 0.1;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double relative_to(double objective) {
    return std::max(1.0, std::abs(objective));
}

double mean_square_jerk(const CamProblem& problem, const Candidate& candidate) {
    const CamModel& model = problem.model();
    const QuadraticForm form = model.design.mean_square(3, model.mean_square_weights(3));
    return form.value(problem.design_values(candidate.x));
}

ExchangeOptions exchange_options(const Scene& scene) {
    ExchangeOptions options;
    options.tolerance = scene.solver.tolerance;
    options.backend.tolerance = scene.solver.tolerance;
    options.backend.max_seconds = scene.solver.max_seconds;
    options.backend.native = scene.solver.options;
    return options;
}

/// Among the optima within the tolerance, the one of least mean square jerk. On a linear program a small
/// enough weight on the energy picks exactly that one; how small is found by trying. (To demand "objective <=
/// optimum" as a row instead leaves a feasible set without an inside, on which an interior point loses its
/// digits.)
void break_tie(const CamProblem& problem, const Scene& scene, ContinuousResult& result,
               const SolveControl& control) {
    const double objective = result.certificate.objective;
    const double allowance = scene.solver.tolerance * relative_to(objective);
    const double violation = std::max(scene.solver.tolerance, result.certificate.worst_violation);
    ExchangeOptions options = exchange_options(scene);
    options.backend.native.clear();
    options.backend.tolerance = options.tolerance = tie_break_accuracy * scene.solver.tolerance;
    for (const double weight : tie_break_weights) {
        CamProblem tied(tie_break_model(problem.model(), weight), problem.samples());
        const ExchangeResult smoother =
            minimize_by_exchange(tied, *make_structured_solver(), result.x, options, control);
        if (smoother.best.x.size() == 0 || control.stopped()) return;
        const Candidate delivered = pulled_inside(problem, judged(problem, smoother.best.x), result.inside);
        if (delivered.objective > objective + allowance || delivered.violation > violation) continue;
        if (mean_square_jerk(problem, delivered) > mean_square_jerk(problem, {result.x})) return;
        result.x = delivered.x;
        Certificate& certificate = result.certificate;
        certificate.objective = delivered.objective;
        certificate.worst_violation = delivered.violation;
        certificate.gap = relative_gap(delivered.objective, *certificate.lower_bound);
        return;
    }
}

bool wants_tie_break(const Scene& scene, const Certificate& certificate) {
    // A root-mean-square term makes the optimum unique by itself.
    return certificate.verdict == Verdict::optimal && scene.objective.tie_break == TieBreak::rms_jerk &&
           scene.objective.rms_acceleration == 0.0 && scene.objective.rms_jerk == 0.0;
}

std::optional<LimitCurve> limit_of(const Scene& scene, const Peaks& reference) {
    const ObjectiveSpec& objective = scene.objective;
    // The limit knows the peaks of one rise (and return) only; a term beside them would make it a bound that
    // nothing approaches.
    if (scene.motion.type == MotionType::program) return {};
    if (objective.rms_acceleration > 0.0 || objective.rms_jerk > 0.0) return {};
    if (std::ranges::any_of(objective.dimensions, [](double weight) { return weight > 0.0; })) return {};
    const auto over = [](double weight, double peak) { return weight > 0.0 ? weight / peak : 0.0; };
    const auto cap = [](const std::optional<PeakLimit>& limit) {
        return limit ? std::optional(limit->normalised) : std::nullopt;
    };
    const AnyCurveLimit limit = any_curve_limit(
        {scene.motion.type, scene.motion.length(), over(objective.velocity, reference.velocity.value),
         over(objective.acceleration, reference.acceleration.value),
         over(objective.jerk, reference.jerk.value), cap(scene.limits.velocity),
         cap(scene.limits.acceleration), cap(scene.limits.jerk)});
    if (limit.status == AnyCurveStatus::infeasible || limit.status == AnyCurveStatus::not_converged)
        return {};
    return LimitCurve{limit.objective, limit.velocity, limit.acceleration, limit.jerk};
}

std::string list_of(const ConditionConflict& conflict) {
    return fmt::format("{}", fmt::join(conflict.others, "; "));
}

/// Weak duality for a cost of zero: the rows of a contradiction add up to 0 >= bound > 0. The box only
/// absorbs the rounding of that sum; it leaves out no curve a cam could follow.
DualityProof contradiction_proof(const ConditionConflict& conflict, int control_points) {
    DualityProof proof;
    proof.statement = "conditions";
    proof.cost = Eigen::VectorXd::Zero(control_points);
    proof.box = {Eigen::VectorXd::Constant(control_points, -farthest_control_point),
                 Eigen::VectorXd::Constant(control_points, farthest_control_point)};
    for (int j = 0; j < control_points; ++j)
        proof.variables.push_back(fmt::format("free control point {}", j));
    const auto rows = static_cast<Eigen::Index>(conflict.rows.size());
    proof.matrix.resize(rows, control_points);
    proof.lower.resize(rows);
    proof.multipliers.resize(rows);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < rows; ++i) {
        const ConflictRow& row = conflict.rows[static_cast<std::size_t>(i)];
        proof.rows.push_back(row.name);
        proof.lower[i] = -row.row.offset;
        proof.multipliers[i] = row.multiplier;
        for (std::size_t k = 0; k < row.row.columns.size(); ++k) {
            entries.emplace_back(i, row.row.columns[k], row.row.weights[k]);
        }
    }
    proof.upper = proof.lower;
    proof.matrix.setFromTriplets(entries.begin(), entries.end());
    proof.bound = recomputed_bound(proof);
    return proof;
}

/// Conditions that no curve of this spline space can meet together: infeasible before anything is solved.
void report_contradictions(Solution& solution, const MotionFamily& family) {
    int run = 0;
    while (family.run(run).contradictions().empty()) ++run;
    const DesignVector& design = family.run(run);
    solution.certificate.verdict = Verdict::infeasible;
    solution.certificate.reason = "conditions_contradict";
    solution.certificate.proof =
        contradiction_proof(design.contradictions().front(), design.space().dimension());
    solution.certificate.proof_kind = ProofKind::duality;
    for (const ConditionConflict& conflict : design.contradictions()) {
        solution.notes.push_back(
            conflict.others.empty()
                ? fmt::format(
                      "degree {} with {} segments leaves too little freedom to meet the conditions at both "
                      "ends: give the spline more segments",
                      design.space().degree(), design.space().segments())
                : fmt::format(
                      "{} contradicts {}; the spline has too little freedom to meet all of them: change "
                      "one, or give it more segments",
                      conflict.condition, list_of(conflict)));
    }
}

/// Who solves a problem that is not convex: Ipopt where this build has it.
std::string general_solver() {
    for (const SolverEntry& entry : solver_entries()) {
        if (entry.name == "ipopt" && entry.available) return entry.name;
    }
    return "structured";
}

bool is_general(const Scene& scene) {
    return scene.cam && needs_starts(scene_model(scene, DesignKind::states, reference_peaks(scene)));
}

struct Solved {
    ContinuousResult result;
    Eigen::VectorXd least_violating;
};

Solved solve_problem(CamProblem& problem, const Solver& solver, Solution& solution,
                     const SolveControl& control) {
    const Scene& scene = solution.scene;
    const JudgeOptions judge{scene.solver.tolerance, scene.solver.gap};
    if (!needs_starts(problem.model())) {
        Solved solved{solve_continuous(problem, solver, exchange_options(scene), judge, control), {}};
        if (wants_tie_break(scene, solved.result.certificate))
            break_tie(problem, scene, solved.result, control);
        return solved;
    }
    StartsResult all =
        solve_from_starts(problem.model(), solver, exchange_options(scene), judge,
                          scene.solver.starts.value_or(default_starts), scene.solver.seed, control);
    solution.solver.convex = false;
    solution.solver.starts = all.starts;
    if (all.starts == 0) solution.solver.name = "structured";  // the relaxation settled it
    if (all.starts == 0 && all.result.certificate.verdict == Verdict::optimal) {
        if (wants_tie_break(scene, all.result.certificate)) break_tie(problem, scene, all.result, control);
        solution.notes.emplace_back(
            "the limits that are not convex do not bite: the optimum without them keeps them, so it is the "
            "optimum of the whole");
    }
    return {std::move(all.result), std::move(all.least_violating)};
}

}  // namespace

BackendChoice choose_backend(const Scene& scene) {
    BackendChoice choice{scene.solver.name, {}, scene.spline.design};
    const bool general = choice.solver == "auto" && is_general(scene);
    if (choice.solver == "auto") {
        choice.solver = general ? general_solver() : "structured";
        choice.reason =
            general
                ? "a limit of this scene is not convex: a convex relaxation settles it or gives a bound, and "
                  "then several starts search for the best motion"
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

Solution solve_without_explaining(const Scene& scene, const SolveControl& control) {
    const Clock::time_point begin = Clock::now();
    validate(scene);
    Solution solution;
    solution.scene = scene;
    const BackendChoice choice = choose_backend(scene);
    CountingSolver solver(make_solver(choice.solver));
    check_native_options(choice.solver, scene.solver.options);
    solution.reference_peaks = reference_peaks(scene);
    solution.any_curve_limit = limit_of(scene, solution.reference_peaks);
    solution.solver.name = choice.solver;
    solution.solver.choice = choice.reason;
    solution.design.kind = choice.design;

    CamProblem problem(scene_model(scene, choice.design, solution.reference_peaks));
    const MotionFamily& design = problem.model().design;
    for (const ConditionConflict& conflict : design.redundant()) {
        solution.notes.push_back(conflict.condition + " follows from the other conditions" +
                                 (conflict.others.empty() ? "" : ": " + list_of(conflict)));
    }
    if (!design.contradictions().empty()) {
        report_contradictions(solution, design);
        solution.seconds_total = seconds_since(begin);
        return solution;
    }
    const Clock::time_point solve_begin = Clock::now();
    Solved solved = solve_problem(problem, solver, solution, control);
    solution.seconds_solve = seconds_since(solve_begin);

    ContinuousResult& result = solved.result;
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
    solution.seconds_total = seconds_since(begin);
    return solution;
}

Solution solve(const Scene& scene, const SolveControl& control) {
    const Clock::time_point begin = Clock::now();
    Solution solution = solve_without_explaining(scene, control);
    const Verdict verdict = solution.certificate.verdict;
    const bool to_explain =
        verdict == Verdict::infeasible || solution.certificate.reason == "no_feasible_point";
    if (to_explain && !control.stopped()) {  // a stopped search must not pass for "nothing helps"
        solution.relaxation = relaxations(scene, control);
    }
    solution.seconds_total = seconds_since(begin);
    return solution;
}

}  // namespace camopt

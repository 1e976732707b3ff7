// SPDX-License-Identifier: MIT
#include "studies/least/violation.hpp"

#include "solvers/structured/structured_solver.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/search/free_knots.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/search/presolve.hpp"

namespace camopt {

namespace {

constexpr int most_rounds = 40;

/// Whether t* of the model is above zero: at most so many exchange rounds as that needs, since a grid's t is
/// a bound from below and a judged motion's one from above. The value is whichever of the two decided.
double least_violation(const CamModel& model, double tolerance, const Budget& budget) {
    CamProblem problem(model);
    const Candidate start = judged(problem, problem.start());
    if (start.violation <= 0.0) return start.violation;
    ElasticProblem elastic(problem);
    const std::unique_ptr<Solver> solver = make_structured_solver();
    Eigen::VectorXd x = elastic.start();
    double violation = start.violation;
    for (int round = 0; round < most_rounds && !budget.spent(); ++round) {
        BackendOptions options;
        options.tolerance = tolerance;
        const BackendResult result = solver->minimize(elastic.grid(), x, options, budget.control());
        if (result.termination != Termination::converged || !result.x.allFinite()) {
            // The value of such a point is no bound: the whole search decides.
            const Feasibility whole = find_feasible(problem, {}, budget.control());
            return whole.point.violation <= tolerance ? std::min(0.0, whole.point.violation)
                                                      : whole.point.violation;
        }
        const double on_grid = result.x[result.x.size() - 1];
        if (on_grid > tolerance) return on_grid;
        const Candidate found = judged(problem, result.x.head(result.x.size() - 1));
        violation = std::min(violation, found.violation);
        if (violation <= 0.0) return violation;
        std::vector<Violation> worst = elastic.violations(result.x, 0.0);
        if (worst.empty() || elastic.refine(worst) == 0) break;
        x = elastic.completed(result.x);
    }
    return violation <= tolerance ? 0.0 : violation;
}

/// The scene as it is solved to answer: what decides which of its motions is best plays no part.
Solution answer(Scene scene, const Budget& budget, const PlanOptions& options = {}) {
    scene.solver.name = "auto";
    scene.solver.options.clear();
    scene.objective.tie_break = TieBreak::none;
    return solve_without_explaining(scene, budget.control(), nullptr, options);
}

/// The motion of a search that leaves its proof out, audited. The solve that the user would start begins with
/// the same search.
Solution search(const Scene& scene, const Budget& budget) {
    Solution solution = answer(scene, budget, {.look = true});
    audit_delivered(solution);
    const Verdict verdict = solution.certificate.verdict;
    if (verdict == Verdict::infeasible || verdict == Verdict::failed) withdraw_motion(solution);
    return solution;
}

}  // namespace

double least_violation(const Scene& scene, const Budget& budget) {
    if (find_fault(scene)) return infinity;
    // The breakpoints that the search would start from do not decide for free ones.
    if (scene.spline.free_knots) {
        if (no_motion_keeps_all_caps(scene)) return infinity;
        if (!limit_breakpoints(scene, reference_peaks(scene)).empty()) return 0.0;
    }
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    if (!model.design.contradictions().empty()) return infinity;
    if (const auto rest = rest_conflict(model, scene.solver.tolerance)) return rest->violation;
    const CamModel convex = convex_part(model, ConvexOver::every_motion);
    const double tolerance = scene.solver.tolerance;
    const double necessary = least_violation(convex, tolerance, budget);
    if (necessary > 0.0) return necessary;
    if (convex.rules.size() < model.rules.size())
        if (const double all = least_violation(model, tolerance, budget); all > 0.0) return all;
    // The strokes last: with them the edge of what is feasible is near everywhere.
    const CamModel held =
        scene_model(scene, DesignKind::states, reference_peaks(scene), HeldStrokes{.held = true});
    return held.rules.size() == model.rules.size() ? necessary : least_violation(held, tolerance, budget);
}

double violation_of_any(const Scene& scene, const Budget& budget) {
    if (!searches_angles(scene)) return least_violation(scene, budget);
    return is_solved(scene, budget) ? 0.0 : infinity;
}

std::shared_ptr<const MotionChain> solved_motion(const Scene& scene, const Budget& budget) {
    if (budget.spent() || find_fault(scene)) return nullptr;
    // The first of several starts is one of those of the scene itself: what it finds is found with all.
    Scene first = scene;
    first.solver.starts = 1;
    const Solution one = search(first, budget);
    const bool settled = one.motion || one.certificate.verdict == Verdict::infeasible;
    if (settled || budget.spent() || scene.solver.starts == 1) return one.motion;
    return search(scene, budget).motion;
}

std::optional<std::vector<ConflictReport>> proved_conflict(const Scene& scene, const Budget& budget) {
    if (budget.spent() || find_fault(scene)) return {};
    if (scene.spline.free_knots)
        return no_motion_keeps_all_caps(scene) ? std::optional(std::vector<ConflictReport>{}) : std::nullopt;
    Scene first = scene;
    first.solver.starts = 1;
    Solution solution = answer(first, budget);
    if (solution.certificate.verdict != Verdict::infeasible) return {};
    return std::move(solution.conflict);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/search/plan.hpp"

#include "objectives/free_knots/free_knot_problem.hpp"
#include "scene/written_limits.hpp"
#include "solvers/registry.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/search/solve_steps.hpp"

namespace camopt {

namespace {

// Searches that found nothing within the limits end after this part of the time: the rest is for explaining
// it.
constexpr double searched_in_vain = 0.6;
// Of a problem whose residual vibration is limited (a cone), relative to the scene's tolerance, and the
// tightest that double precision carries.
constexpr double cone_tolerance = 1e-2, least_tolerance = 1e-12;

/// Who goes on where the structured solver fails: Ipopt where this build has it, else no one.
std::string solver_after_structured() {
    const bool available = std::ranges::any_of(
        solver_entries(), [](const SolverEntry& entry) { return entry.name == "ipopt" && entry.available; });
    return available ? "ipopt" : "";
}

DesignKind design_of(const Scene& scene) {
    if (scene.spline.design != DesignKind::automatic) return scene.spline.design;
    // NLopt works on dense matrices and handles equalities badly: fewest variables, ends built in.
    return scene.solver.name.starts_with("nlopt.") ? DesignKind::coefficients : DesignKind::states;
}

bool is_general(const PlacedRule& rule, double least, double most) {
    return rule->curvature(least, most) == Curvature::general;
}

void plan_solver(SolvePlan& plan, const Scene& scene, bool general) {
    plan.solver = scene.solver.name;
    if (scene.solver.name != "auto") return;
    plan.solver = "structured";
    if (plan.prescribed && plan.dimensions == 0) {
        plan.reason = "prescribed motion, nothing to optimize: laws and dwells fix every displacement";
        return;
    }
    plan.reason = general ? "a limit or the torque term of this scene is not convex: a convex relaxation "
                            "decides it or gives a bound, and then several starts search for the best motion"
                          : "every rule of this scene is linear or convex in the design vector and its cost "
                            "is convex, so the structured interior point finds and proves the global optimum";
    plan.next_solver = solver_after_structured();
}

void plan_searched_numbers(SolvePlan& plan, const PosedScene& posed) {
    const Scene& scene = posed.given;
    plan.angles =
        static_cast<int>(std::ranges::count_if(scene.motion.segments, [](const ProgramSegment& segment) {
            return segment.angle_range.has_value();
        }));
    if (scene.spline.free_knots) plan.breakpoints = static_cast<int>(start_breakpoints(scene).size()) - 2;
    plan.displacements =
        static_cast<int>(free_displacements(posed.scene(), posed.model.design).joints.size());
    plan.dimensions = static_cast<int>(
        std::ranges::count(posed.model.parameters, Parameter::Kind::dimension, &Parameter::kind));
}

ProofKind planned_proof(const SolvePlan& plan, const PosedScene& posed, bool general) {
    if (plan.angles > 0) return bounds_by_angles(posed.given) ? ProofKind::boxes : ProofKind::none;
    if (plan.breakpoints > 0)
        return limit_curve(posed.scene(), posed.reference) ? ProofKind::any_curve_limit : ProofKind::none;
    if (!general) return ProofKind::duality;
    return plan.look ? ProofKind::none : ProofKind::boxes;
}

}  // namespace

const char* name_of(StartKind value) {
    static constexpr std::array names = {"measured", "relaxation", "smoothest", "random"};
    return names[static_cast<std::size_t>(value)];
}

StartKind start_kind(bool from_measured, int index) {
    if (from_measured && index-- == 0) return StartKind::measured;
    return index == 0 ? StartKind::relaxation : index == 1 ? StartKind::smoothest : StartKind::random;
}

bool needs_starts(const CamModel& model) {
    return std::ranges::any_of(model.rules,
                               [](const PlacedRule& rule) { return is_general(rule, -infinity, infinity); });
}

PosedScene::PosedScene(const Scene& scene, HeldStrokes held)
    : given(scene),
      given_reference(reference_peaks(scene)),
      scale(scene, given_reference),
      reference(scale.is_idle() ? given_reference : reference_peaks(scale.scaled())),
      strokes(std::move(held)),
      model(scene_model(scale.scaled(), design_of(scene), reference, strokes)) {
    const bool measured = scene.measured && scene.measured->start && !searches_angles(scene);
    if (measured && model.design.contradictions().empty())
        model.start_design = nearest_design(model.design, scene);
}

SolvePlan plan_of(const PosedScene& posed, const PlanOptions& options) {
    const Scene& scene = posed.given;
    const CamModel& model = posed.model;
    const bool general = needs_starts(model);
    SolvePlan plan;
    plan.prescribed = scene.motion.prescribed();
    plan_searched_numbers(plan, posed);
    plan_solver(plan, scene, general);
    plan.design = design_of(scene);
    plan.contradiction = !model.design.contradictions().empty();
    plan.cost_scale = posed.scale.factor();
    plan.strokes_first_free =
        (scene.motion.within_lift || scene.motion.monotone) && !scene.motion.prescribed();
    if (general) plan.relaxations.push_back(ConvexOver::every_motion);
    if (general && std::ranges::any_of(model.rules, [&](const PlacedRule& rule) {
            return is_general(rule, -infinity, infinity) &&
                   !is_general(rule, model.least_displacement, model.most_displacement);
        }))
        plan.relaxations.push_back(ConvexOver::sensible_motion);
    plan.convex = !general && plan.angles == 0 && plan.breakpoints == 0;
    if (general || plan.breakpoints > 0) plan.starts = scene.solver.starts.value_or(default_starts);
    plan.from_measured = model.start_design.size() > 0;
    plan.seed = scene.solver.seed;
    plan.look = options.look;
    // A root-mean-square term alone makes the optimum unique.
    plan.tie_break = scene.objective.tie_break != TieBreak::none &&
                     !weighs_any(scene.objective, CostTerm::Kind::rms) &&
                     !(scene.objective.motor_torque_rms > 0.0) && !scene.motion.prescribed() &&
                     !(scene.objective.deviation_rms > 0.0);
    plan.proof = planned_proof(plan, posed, general);
    plan.seconds = scene.solver.max_seconds;
    if (options.explain) {
        plan.searching = searched_in_vain;
        plan.explain_seconds = scene.solver.explain_seconds;
    }
    return plan;
}

SolvePlan plan(const Scene& scene, const PlanOptions& options) {
    const Scene complete = with_written_limits(scene);
    validate(complete);
    return plan_of(PosedScene(complete), options);
}

ExchangeOptions exchange_options(const Scene& scene) {
    ExchangeOptions options;
    options.tolerance = scene.solver.tolerance;
    options.backend.tolerance = scene.solver.tolerance;
    options.backend.max_seconds = scene.solver.max_seconds;
    options.backend.native = scene.solver.options;
    // A point just outside is drawn to one well inside, which costs its violation times their distance;
    // tangents of a cone always leave it just outside, and a few more of them cost little.
    if (scene.limits.residual) {
        options.tolerance = std::max(cone_tolerance * options.tolerance, least_tolerance);
        options.backend.tolerance = options.tolerance;
    }
    return options;
}

}  // namespace camopt

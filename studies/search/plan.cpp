// SPDX-License-Identifier: MIT
#include "studies/search/plan.hpp"

#include "motions/laws/law.hpp"
#include "objectives/laws/segment_law.hpp"
#include "objectives/scene_family.hpp"
#include "scene/cost_table.hpp"
#include "scene/written_limits.hpp"
#include "solvers/registry.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/search/posed_scene.hpp"

namespace camopt {

namespace {

// Searches that found nothing within the limits end after this part of the time: the rest is for explaining
// it.
constexpr double searched_in_vain = 0.6;

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
    const Scene& scene = posed.scene;
    plan.angles =
        static_cast<int>(std::ranges::count_if(scene.motion.segments, [](const ProgramSegment& segment) {
            return segment.angle_range.has_value();
        }));
    if (scene.spline.free_knots && !scene.motion.prescribed())
        plan.breakpoints =
            static_cast<int>(start_breakpoints(scene).size() - held_breakpoints(scene).size()) - 2;
    plan.transmission = scene.drive && scene.drive->transmission_range;
    plan.displacements = static_cast<int>(free_displacements(posed.scene, posed.model.design).joints.size());
    plan.dimensions = static_cast<int>(
        std::ranges::count(posed.model.parameters, Parameter::Kind::dimension, &Parameter::kind));
}

bool rests_at_joint(const MotionSpec& motion, std::size_t index, bool at_its_end) {
    const ProgramSegment& neighbour = motion.segments[index];
    if (neighbour.kind == SegmentKind::dwell) return true;
    if (neighbour.kind == SegmentKind::spline) return false;
    const auto law = segment_law(motion, index);
    const MotionPoint point = at_its_end ? law->at(1.0, Side::left) : law->at(0.0, Side::right);
    constexpr double at_rest = 1e-9;  // of the mean velocity 1: less is rounding
    return std::abs(point.derivative[1]) < at_rest && std::abs(point.derivative[2]) < at_rest;
}

bool is_normalised(const SetPoint& point) {
    return point.units.place.empty() && point.units.velocity.empty() && point.units.acceleration.empty();
}

/// Whether the least objective can only fall where an angle grows: boxes of angles can be bounded
/// (free_angles.hpp).
bool bounds_by_angles(const Scene& scene) {
    if (scene.cam || scene.drive || scene.dynamics || !scene.own_terms.empty() || !scene.own_limits.empty())
        return false;
    // Corridors and tables stand where they are while segments move past them; an area or a mean over the
    // turn weighs segments by their angles.
    const bool weighs_turn = std::ranges::any_of(
        response_terms(), [&](const ResponseTerm& term) { return term.weight_in(scene.objective) > 0.0; });
    if (!scene.motion.corridors.empty() || weighs_turn || weighs_any(scene.objective, CostTerm::Kind::rms))
        return false;
    const std::vector<ProgramSegment>& segments = scene.motion.segments;
    // A polynomial changes its shape with its angle.
    if (std::ranges::any_of(segments, &ProgramSegment::takes_states)) return false;
    const std::size_t count = segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (segments[i].kind != SegmentKind::spline) continue;
        if (!std::ranges::all_of(segments[i].via, is_normalised)) return false;
        if (!rests_at_joint(scene.motion, (i + count - 1) % count, true) ||
            !rests_at_joint(scene.motion, (i + 1) % count, false))
            return false;
    }
    return true;
}

ProofKind planned_proof(const SolvePlan& plan, const PosedScene& posed, bool general) {
    if (plan.transmission) return ProofKind::none;
    if (plan.angles > 0)
        return plan.breakpoints == 0 && bounds_by_angles(posed.scene) ? ProofKind::boxes : ProofKind::none;
    if (plan.breakpoints > 0)
        return limit_curve(posed.scene, posed.reference) ? ProofKind::any_curve_limit : ProofKind::none;
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

SolvePlan plan_of(const PosedScene& posed, const PlanOptions& options) {
    const Scene& scene = posed.scene;
    const CamModel& model = posed.model;
    const bool general = needs_starts(model);
    SolvePlan plan;
    plan.prescribed = scene.motion.prescribed();
    plan_searched_numbers(plan, posed);
    plan_solver(plan, scene, general);
    plan.design = design_of(scene);
    plan.contradiction = plan.breakpoints == 0 && !model.design.contradictions().empty();
    plan.cost_scale = posed.units.cost;
    plan.strokes_first_free =
        (scene.motion.within_lift || scene.motion.monotone) && !scene.motion.prescribed();
    if (general) plan.relaxations.push_back(ConvexOver::every_motion);
    if (general && std::ranges::any_of(model.rules, [&](const PlacedRule& rule) {
            return is_general(rule, -infinity, infinity) &&
                   !is_general(rule, model.least_displacement, model.most_displacement);
        }))
        plan.relaxations.push_back(ConvexOver::sensible_motion);
    plan.convex = !general && plan.angles == 0 && plan.breakpoints == 0 && !plan.transmission;
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
    const Scene complete = valid_scene(scene);
    return plan_of(PosedScene(complete), options);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/machine/machine_build.hpp"

#include "scene/part_names.hpp"
#include "solvers/registry.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/search/convex_solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double finer_part = 1e-2;  // of the tolerance, where a first solve left the gap open

[[noreturn]] void refuse(std::size_t axis, const std::string& key, const std::string& found,
                         const std::string& allowed) {
    throw SceneError({entry_key("axis", axis, joined_key("scene", key)), found, allowed});
}

/// Rules that make a model's problem not convex. At a given speed limits are left out, which is a relaxation:
/// the motions found without them are the best ones with them if they satisfy them (delivered_axis). Returns
/// their names.
std::vector<std::string> leave_out_general(CamModel& model, std::size_t axis, bool at_given_speed) {
    std::vector<std::string> left_out;
    std::erase_if(model.rules, [&](const PlacedRule& rule) {
        if (rule->curvature(-infinity, infinity) != Curvature::general) return false;
        if (!rule->limit() || !at_given_speed)
            refuse(
                axis, rule->limit() ? rule->name() : "objective.torque", "a limit or term that is not convex",
                "in a machine linear and convex ones (velocity, acceleration, jerk, pressure angle, drive): "
                "only for these a largest speed can be proved");
        left_out.push_back(rule->name());
        return true;
    });
    return left_out;
}

/// Σ |factor| · range of the displacement: a clearance violated by all of it is violated by 100 %.
double scale_of(const MachineSpec& machine, const Clearance& clearance) {
    double scale = 0.0;
    for (std::size_t k = 0; k < clearance.axes.size(); ++k) {
        const auto& motion = machine.axes[static_cast<std::size_t>(clearance.axes[k])].scene.motion;
        const auto [least, most] = motion.displacements();
        scale += std::abs(clearance.factors[k]) * std::max(most - least, 1e-3 * motion.lift);
    }
    return scale;
}

std::vector<ClearanceRule> clearance_rules(const MachineSpec& machine, const MachineMemory& memory) {
    std::vector<ClearanceRule> rules;
    rules.reserve(machine.clearances.size());
    for (std::size_t k = 0; k < machine.clearances.size(); ++k) {
        const Clearance& given = machine.clearances[k];
        ClearanceRule rule = ClearanceRule(name_of_clearance(static_cast<int>(k)), {}, {}, given.at_least,
                                           scale_of(machine, given))
                                 .between(given.from, given.to);
        if (k < memory.clearances.size()) rule.samples = memory.clearances[k];
        for (std::size_t i = 0; i < given.axes.size(); ++i) {
            if (given.factors[i] == 0.0) continue;
            rule.axes.push_back(given.axes[i]);
            rule.factors.push_back(given.factors[i]);
        }
        rules.push_back(std::move(rule));
    }
    return rules;
}

}  // namespace

void MachineMemory::keep(const MachineProblem& problem) {
    axes.clear();
    for (int b = 0; b < problem.axes(); ++b) {
        axes.push_back(problem.axis(b).samples());
        // Rows of the whole motion hold at speeds that the next machine may not have.
        std::erase_if(axes.back(), [](const RuleSample& sample) { return !sample.setting.empty(); });
    }
    for (std::size_t k = 0; k < clearances.size(); ++k) clearances[k] = problem.samples(static_cast<int>(k));
}

PosedMachine posed_machine(const MachineSpec& machine, const std::vector<Scene>& scenes,
                           const MachineMemory& memory) {
    PosedMachine made;
    std::vector<MachineBlock> blocks;
    blocks.reserve(scenes.size());
    for (std::size_t b = 0; b < scenes.size(); ++b) {
        Scene given = scenes[b];
        if (given.spline.design == DesignKind::automatic) given.spline.design = memory.design;
        made.scenes.push_back(std::make_unique<const Scene>(std::move(given)));
        const Scene& scene = *made.scenes.back();
        made.posed.push_back(std::make_unique<PosedScene>(scene, HeldStrokes{memory.held[b], {}}));
        PosedScene& posed = *made.posed.back();
        made.left_out.push_back(leave_out_general(posed.model, b, !machine.searches_speed()));
        made.plans.push_back(std::make_shared<const SolvePlan>(plan_of(posed)));
        const MotionSpec& motion = scene.motion;
        double advance = 0.0;
        for (const ProgramSegment& segment : motion.segments)
            if (motion.relative) advance = segment.to.value_or(advance);
        blocks.push_back({{machine.axes[b].name, machine.axes[b].phase, motion.unit_angle(), motion.lift,
                           posed.units.cost, advance},
                          std::move(posed.model),
                          b < memory.axes.size() ? memory.axes[b] : std::vector<RuleSample>{}});
    }
    made.problem = std::make_unique<MachineProblem>(std::move(blocks), clearance_rules(machine, memory));
    if (memory.x.size() > 0) made.problem->set_start(memory.x);
    return made;
}

ExchangeOptions machine_exchange(const MachineSpec& machine, double seconds) {
    ExchangeOptions exchange = exchange_options(machine.axes.front().scene);
    for (const AxisSpec& axis : machine.axes) {
        const ExchangeOptions own = exchange_options(axis.scene);
        exchange.tolerance = std::min(exchange.tolerance, own.tolerance);
        exchange.backend.tolerance = std::min(exchange.backend.tolerance, own.backend.tolerance);
    }
    exchange.backend.native.clear();  // they belong to one axis
    exchange.backend.max_seconds = seconds;
    return exchange;
}

Solution delivered_axis(PosedMachine& machine, int index, const Eigen::VectorXd& x) {
    const auto b = static_cast<std::size_t>(index);
    const PosedScene& posed = *machine.posed[b];
    const CamProblem& problem = machine.problem->axis(index);
    const Eigen::VectorXd own = machine.problem->axis_x(index, x);
    Solution solution;
    solution.scene = posed.scene;
    solution.reference_peaks = posed.reference;
    solution.any_curve_limit = limit_curve(solution.scene, posed.reference);
    solution.plan = machine.plans[b];
    solution.solver.name = "structured";
    solution.solver.choice = "an axis of a machine: all axes are solved together";
    solution.solver.termination = Termination::converged;
    solution.design.kind = machine.plans[b]->design;
    solution.family = problem.family();
    if (problem.model().cam) solution.evaluations.profile_points = *problem.model().cam->profile_points;
    Certificate& certificate = solution.certificate;
    certificate.verdict = Verdict::feasible;
    certificate.reason = Reason::none;
    certificate.objective = problem.objective(own);
    certificate.worst_violation = problem.worst_of_limits(own);
    report_motion(solution, problem, own);
    posed.restore(solution);
    audit_delivered(solution);
    if (!machine.left_out[b].empty() && certificate.reason == Reason::limit_not_kept)
        refuse(b, machine.left_out[b].front(),
               "a limit that is not convex, and that the best motions without it do not satisfy",
               "in a machine at a given speed limits that are convex, or satisfied by these motions");
    if (certificate.verdict == Verdict::failed) return solution;
    if (!machine.left_out[b].empty())
        solution.notes.emplace_back(
            "the limits that are not convex are inactive: the motions that are best without them satisfy "
            "them");
    solution.family.reset();
    solution.notes.emplace_back(
        "an axis of a machine: the least total objective of all axes is proved in machine.json, not the "
        "least of this axis alone");
    note_phase(solution);
    return solution;
}

ContinuousResult least_total(MachineProblem& problem, const ExchangeOptions& exchange,
                             const JudgeOptions& judge, const SolveControl& control, bool persistent) {
    const std::unique_ptr<Solver> structured = make_structured_solver();
    NextSolver next;
    if (persistent)
        return solve_convex({problem, *structured, solver_after_structured(), judge, control}, exchange,
                            next);
    ContinuousResult found = solve_continuous(problem, *structured, exchange, judge, control);
    if (found.x.size() == 0 || found.certificate.verdict == Verdict::optimal || control.ending())
        return found;
    // Near the largest speed a violation within the tolerance costs more than the gap.
    ExchangeOptions finer = exchange;
    finer.tolerance = finer.backend.tolerance = finer_part * exchange.tolerance;
    ContinuousResult again = solve_continuous(problem, *structured, finer, judge, control);
    return again.certificate.verdict < found.certificate.verdict ? again : found;
}

bool hold_strokes(const PosedMachine& posed, const Eigen::VectorXd& x, MachineMemory& memory) {
    bool fresh = false;
    for (int b = 0; b < posed.problem->axes(); ++b) {
        const auto at = static_cast<std::size_t>(b);
        const Scene& scene = posed.posed[at]->scene;
        const bool has_range = scene.motion.within_lift || scene.motion.monotone;
        if (memory.held[at] || !has_range || scene.motion.prescribed()) continue;
        const CamProblem& problem = posed.problem->axis(b);
        const auto out =
            excursions_of(scene, problem.model().design, problem.motion(posed.problem->axis_x(b, x)));
        if (std::ranges::none_of(out, [&](double amount) { return amount > scene.solver.tolerance; }))
            continue;
        memory.held[at] = fresh = true;
        if (at < memory.axes.size()) memory.axes[at].clear();  // its rules are others now
    }
    return fresh;
}

}  // namespace camopt

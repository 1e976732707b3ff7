// SPDX-License-Identifier: MIT
#include "studies/delivered/response_report.hpp"

#include "core/units.hpp"
#include "objectives/response/response_rule.hpp"
#include "scene/cost_table.hpp"
#include "scene/limit_table.hpp"

namespace camopt {

namespace {

ResponseReport response_report_of(const Scene& scene, ResponseKind kind, const Motion& motion) {
    const WorstResponse worst = worst_response(scene, kind, motion);
    return {worst.value, worst.speed, worst.at};
}

}  // namespace

TrainReport train_report(const Scene& scene, const Motion& motion) {
    const DynamicsSpec& spec = scene.dynamics.value();
    TrainReport report;
    report.natural_frequencies = spec.formulas->natural_frequencies();
    report.frequency_ratio = scene.motion.unit_angle() / scene.motion.speed.value() *
                             report.natural_frequencies.front() / units::turn;
    report.speeds = response_speeds(scene);
    if (motion_events(scene.motion).empty()) return report;
    if (spec.formulas->vibrates())
        report.residual = response_report_of(scene, ResponseKind::residual, motion);
    report.acceleration = response_report_of(scene, ResponseKind::acceleration, motion);
    if (spec.pressed()) report.least_force = response_report_of(scene, ResponseKind::contact_force, motion);
    for (const ResponseTerm& term : response_terms())
        if (const double weight = term.weight_in(scene.objective); weight > 0.0)
            report.terms.push_back(
                {term.name, weight, response_reference(scene, term),
                 (kind_of(term.figure) == ResponseKind::residual ? report.residual : report.acceleration)
                     .value()});
    return report;
}

std::vector<ConstraintReport> response_constraints(const Scene& scene, const TrainReport& train) {
    std::vector<ConstraintReport> reports;
    for (const LimitRow& row : limit_rows()) {
        const auto& limit = row.in(scene.limits);
        if (!row.needs_dynamics || !limit) continue;
        const bool residual = row.figure == LimitedFigure::residual;
        const std::optional<ResponseReport>& worst = residual ? train.residual : train.least_force;
        if (!worst) continue;
        const double value = residual ? worst->value * scene.motion.lift : worst->value;
        reports.push_back(
            {row.name, limit->key, limit->given(), value / limit->unit_value, limit->unit, worst->at});
    }
    return reports;
}

void report_responses(Solution& solution) {
    const Scene& scene = solution.scene;
    if (!scene.dynamics) return;
    solution.train = train_report(scene, *solution.motion);
    const std::vector<ConstraintReport> limits = response_constraints(scene, *solution.train);
    solution.constraints.insert(solution.constraints.end(), limits.begin(), limits.end());
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/delivered/mechanism_report.hpp"

#include "core/errors.hpp"
#include "scene/limit_table.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/check/mechanism_check.hpp"
#include "studies/delivered/solution_report.hpp"

namespace camopt {

bool has_inverse_cam(const Solution& solution) {
    return solution.mechanism && solution.mechanism->mechanism.formulas->has_guide();
}

MechanismReport mechanism_report(const Scene& scene, std::vector<double> dimensions, const Motion& motion) {
    if (!scene.mechanism || !scene.mechanism->formulas)
        throw InputError("a mechanism cannot be reported without its formulas");
    MechanismReport report;
    report.mechanism = {scene.mechanism->formulas, std::move(dimensions)};
    report.summary = mechanism_summary(report.mechanism, motion, motion_scale(scene));
    return report;
}

namespace {

/// What a mechanism beside the disk cam can be limited by: nothing that needs forces, no stroke of its own.
bool has_figure(LimitedFigure figure) {
    const LimitRow& row = limit_row(figure);
    return !row.needs_forces && row.cams != LimitRow::Cams::disk;
}

/// None where there is no such value.
std::optional<CamExtreme> figure_of(const MechanismSummary& summary, LimitedFigure figure) {
    switch (figure) {
        case LimitedFigure::pressure_angle:
            return summary.pressure_angle;
        case LimitedFigure::convex_radius:
            return summary.convex_radius;
        case LimitedFigure::concave_radius:
            return summary.concave_radius;
        case LimitedFigure::regularity:
            return summary.regularity;
        default:
            return std::nullopt;
    }
}

}  // namespace

std::vector<ConstraintReport> mechanism_constraints(const Scene& scene, const MechanismReport& report) {
    std::vector<ConstraintReport> all;
    for (const LimitRow& row : limit_rows()) {
        const auto& limit = row.in(scene.limits);
        if (!limit || !has_figure(row.figure)) continue;
        const std::optional<CamExtreme> worst = figure_of(report.summary, row.figure);
        all.push_back(
            limit_report(*limit, worst.value_or(CamExtreme{infinity, 0.0}), row.is_least() ? -1 : 1));
    }
    return all;
}

ForwardCheckReport check_mechanism(const Solution& solution, int points) {
    if (!solution.mechanism)
        throw InputError("the forward check needs a mechanism, and this solution has none");
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const ForwardCheckResult result =
        forward_check(mechanism_check_input(solution.mechanism->mechanism, motion, scale, points));
    return {result.deviation, result.relative, result.theta / scale.unit_angle, result.points,
            result.seconds};
}

}  // namespace camopt

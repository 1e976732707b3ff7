// SPDX-License-Identifier: MIT
#include "studies/delivered/mechanism_report.hpp"

#include "core/errors.hpp"
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

std::vector<ConstraintReport> mechanism_constraints(const Scene& scene, const MechanismReport& report) {
    const LimitSpec& limits = scene.limits;
    const MechanismSummary& summary = report.summary;
    std::vector<ConstraintReport> all;
    const auto add = [&](const std::optional<WrittenLimit>& limit, const std::optional<CamExtreme>& worst,
                         int sign) {
        if (limit) all.push_back(limit_report(*limit, worst.value_or(CamExtreme{infinity, 0.0}), sign));
    };
    add(limits.pressure_angle, summary.pressure_angle, 1);
    add(limits.cam_radius_min, summary.convex_radius, -1);
    add(limits.concave_radius_min, summary.concave_radius, -1);
    add(limits.undercut_margin, summary.regularity, -1);
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

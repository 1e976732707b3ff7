// SPDX-License-Identifier: MIT
#include "studies/delivered_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

JointJump worst_joint_jump(const SplineCurve& curve) {
    const std::vector<double>& breakpoints = curve.space().breakpoints();
    JointJump worst;
    for (int order = 0; order <= std::min(curve.continuity(), 3); ++order) {
        double largest = 0.0;
        JointJump jump{0.0, 0.0, order};
        for (int joint = 0; joint < static_cast<int>(breakpoints.size()); ++joint) {
            const double left = curve.derivative(breakpoints[joint], order, Side::left);
            const double right = curve.derivative(breakpoints[joint], order, Side::right);
            largest = std::max({largest, std::abs(left), std::abs(right)});
            // NaN counts as the worst.
            if (!(std::abs(left - right) <= jump.relative))
                jump = {std::abs(left - right), breakpoints[joint], order};
        }
        jump.relative /= largest > 0.0 ? largest : 1.0;
        if (!(jump.relative <= worst.relative)) worst = jump;
    }
    return worst;
}

void judge_delivered_joints(Solution& solution) {
    if (!solution.motion) return;
    JointJump worst;
    const auto look_at = [&](const SplineCurve& curve) {
        const JointJump jump = worst_joint_jump(curve);
        if (!(jump.relative <= worst.relative)) worst = jump;
    };
    if (solution.curve) look_at(*solution.curve);
    for (const SegmentReport& segment : solution.segments)
        if (segment.curve) look_at(*segment.curve);
    if (worst.relative <= largest_joint_jump) return;
    solution.certificate.verdict = Verdict::failed;
    solution.certificate.reason = "breakpoints_too_close";
    solution.notes.push_back(
        fmt::format("the breakpoints lie too close for double precision: derivative {} of the motion jumps "
                    "by {:.2g} of its "
                    "largest value at x = {:.10g}",
                    worst.order, worst.relative, worst.at));
}

}  // namespace camopt

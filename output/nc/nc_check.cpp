// SPDX-License-Identifier: MIT
#include "output/nc/nc_check.hpp"

#include "core/errors.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double pose_rounding = 1e-12;  // of the lever arms: some dozen operations either way
constexpr double partial_step = 1e-5;    // m, rad: central differences, exact to 1e-10

/// What half a last digit in every axis can do to tip (m) and axis (rad).
struct Rounding {
    double tip = 0.0, axis = 0.0, kinematics = 0.0;
};

Rounding rounding_at(const Machine& machine, const PostProcessor& post, const Eigen::VectorXd& values) {
    Rounding result;
    for (std::size_t i = 0; i < machine.axes().size(); ++i) {
        const AxisKind kind = machine.axes()[i].kind;
        Eigen::VectorXd up = values, down = values;
        up(static_cast<Eigen::Index>(i)) += partial_step;
        down(static_cast<Eigen::Index>(i)) -= partial_step;
        const double half = half_last_digit(post, kind);
        result.tip += (machine.pose(up).tip - machine.pose(down).tip).norm() / (2.0 * partial_step) * half;
        if (kind == AxisKind::rotary) result.axis += half;
    }
    result.kinematics = pose_rounding * (values.head<3>().norm() + machine.pose(values).tip.norm());
    // The differences above are themselves rounded.
    result.tip *= 1.0 + 1e-6;
    result.axis = result.axis * (1.0 + 1e-6) + pose_rounding;
    return result;
}

constexpr Eigen::Index height_axis = 2;

/// All axes rest but Z, which rises.
bool leads_out(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    Eigen::VectorXd way = to - from;
    const double up = way(height_axis);
    way(height_axis) = 0.0;
    return up >= 0.0 && way.isZero(0.0);
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

NcPoseCheck check_poses(std::span<const NcMove> moves, const Machine& machine, const PostProcessor& post,
                        std::span<const ToolPose> wanted) {
    NcPoseCheck check;
    check.within_rounding = true;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const NcMove& move = moves[i];
        if (move.rapid) continue;
        if (i + 1 == moves.size() || moves[i + 1].rapid) {
            if (i > 0 && leads_out(moves[i - 1].values, move.values)) continue;
            check.within_rounding = false;
            check.line = move.line;
            continue;
        }
        const auto block = static_cast<std::size_t>(check.blocks++);
        if (block >= wanted.size()) continue;  // counted, and refused below
        const ToolPose found = machine.pose(move.values);
        const double tip = (found.tip - wanted[block].tip).norm();
        const double axis = angle_between(found.axis, wanted[block].axis);
        const Rounding rounding = rounding_at(machine, post, move.values);
        if (!(tip <= rounding.tip + rounding.kinematics && axis <= rounding.axis))
            check.within_rounding = false;
        if (tip > check.tip_deviation || check.line == 0) {
            check.tip_deviation = tip;
            check.line = move.line;
        }
        check.axis_deviation = std::max(check.axis_deviation, axis);
        check.tip_rounding = std::max(check.tip_rounding, rounding.tip);
        check.axis_rounding = std::max(check.axis_rounding, rounding.axis);
        check.cutting_seconds += move.seconds;
    }
    if (static_cast<std::size_t>(check.blocks) != wanted.size())
        throw InputError(fmt::format("NC check: the program has {} cutting blocks, the path has {} poses",
                                     check.blocks, wanted.size()));
    return check;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "shop/nc/nc_check.hpp"

#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"
#include "shop/nc/cutter_compensation.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

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

// The sweep of the cutter against the points of the wanted surface.
constexpr int steps_per_block = 4;       // the coarse search; the distance is smooth within a block
constexpr int golden_sections = 44;      // to 1e-9 of a step
constexpr double candidate_part = 0.02;  // of the cutter's radius: how much worse a coarse minimum may look
constexpr std::size_t group_size = 40;   // poses that one sphere encloses

/// The cutter's way: one parameter, a whole number at each cutting block's end.
class Sweep {
 public:
    Sweep(std::span<const NcMove> moves, const Machine& machine, const CutterShape& cutter)
        : machine_(machine) {
        for (std::size_t i = 1; i < moves.size(); ++i)
            if (!moves[i].rapid) segments_.push_back({&moves[i - 1].values, &moves[i]});
        if (segments_.empty()) throw InputError("NC check: the program does not cut");
        coarse_.reserve(segments_.size() * steps_per_block + 1);
        for (std::size_t k = 0; k < segments_.size(); ++k)
            for (int step = 0; step <= steps_per_block; ++step)
                coarse_.push_back(pose(k, static_cast<double>(step) / steps_per_block));
        for (std::size_t begin = 0; begin < coarse_.size(); begin += group_size)
            groups_.push_back(around(begin, cutter));
    }

    [[nodiscard]] ToolPose pose(std::size_t segment, double share) const {
        const Segment& s = segments_[segment];
        return machine_.pose(values_along(*s.from, *s.move, share));
    }
    /// steps_per_block + 1 poses a segment.
    [[nodiscard]] const std::vector<ToolPose>& coarse() const { return coarse_; }

    /// Coarse poses begin … end - 1, and a sphere around the cutter in all of them.
    struct Group {
        std::size_t begin = 0, end = 0;
        Eigen::Vector3d center = Eigen::Vector3d::Zero();
        double radius = 0.0;

        /// No pose of the group is nearer to the point.
        [[nodiscard]] double least_clearance(const Eigen::Vector3d& point) const {
            return (point - center).norm() - radius;
        }
    };
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }

 private:
    [[nodiscard]] Group around(std::size_t begin, const CutterShape& cutter) const {
        Group group{begin, std::min(begin + group_size, coarse_.size())};
        const auto middle = [&](std::size_t i) -> Eigen::Vector3d {
            return coarse_[i].tip - 0.5 * cutter.length * coarse_[i].axis;
        };
        for (std::size_t i = begin; i < group.end; ++i)
            group.center += middle(i) / static_cast<double>(group.end - begin);
        for (std::size_t i = begin; i < group.end; ++i)
            group.radius = std::max(group.radius, (middle(i) - group.center).norm());
        group.radius += 0.5 * (cutter.length + cutter.diameter);
        return group;
    }

    struct Segment {
        const Eigen::VectorXd* from;
        const NcMove* move;
    };
    const Machine& machine_;
    std::vector<Segment> segments_;
    std::vector<ToolPose> coarse_;
    std::vector<Group> groups_;
};

/// Of one point after the other from the cutter's sweep.
class PointClearance {
 public:
    PointClearance(const Sweep& sweep, const CutterShape& cutter)
        : sweep_(sweep), cutter_(cutter), bounds_(sweep.groups().size()) {}

    [[nodiscard]] double least(const Eigen::Vector3d& point) {
        double best = best_of_near_groups(point);
        const double worth_a_look = best + candidate_part * cutter_.diameter;
        for (std::size_t i = 0; i < near_.size(); ++i) {
            // Of its own block only: the pose before its first may be another, by rounding or by a rapid.
            const std::size_t step = near_[i].pose % per_segment;
            const bool falls = step == 0 || near_[i].clearance <= near_[i - 1].clearance;
            const bool rises = step == steps_per_block || near_[i].clearance <= near_[i + 1].clearance;
            if (falls && rises && near_[i].clearance <= worth_a_look)
                best = std::min(best, refined(near_[i].pose, point));
        }
        return best;
    }

 private:
    static constexpr std::size_t per_segment = steps_per_block + 1;
    static_assert(group_size % per_segment == 0, "a block lies in one group");

    struct NearPose {
        std::size_t pose;
        double clearance;
    };

    /// Over all coarse poses; near_ holds those of the groups that may be worth a look, whole blocks of them.
    [[nodiscard]] double best_of_near_groups(const Eigen::Vector3d& point) {
        const std::vector<Sweep::Group>& groups = sweep_.groups();
        std::ranges::transform(groups, bounds_.begin(),
                               [&](const Sweep::Group& group) { return group.least_clearance(point); });
        const auto nearest = static_cast<std::size_t>(std::ranges::min_element(bounds_) - bounds_.begin());
        near_.clear();
        double best = best_of(groups[nearest], point);
        for (std::size_t k = 0; k < groups.size(); ++k)
            if (k != nearest && bounds_[k] <= best + candidate_part * cutter_.diameter)
                best = std::min(best, best_of(groups[k], point));
        return best;
    }
    [[nodiscard]] double best_of(const Sweep::Group& group, const Eigen::Vector3d& point) {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = group.begin; i < group.end; ++i) {
            near_.push_back({i, cutter_clearance(sweep_.coarse()[i], cutter_, point)});
            best = std::min(best, near_.back().clearance);
        }
        return best;
    }
    /// Around coarse pose i.
    [[nodiscard]] double refined(std::size_t i, const Eigen::Vector3d& point) const {
        const std::size_t segment = i / per_segment, step = i % per_segment;
        const double low = step == 0 ? 0.0 : static_cast<double>(step - 1) / steps_per_block;
        const double high = std::min(1.0, static_cast<double>(step + 1) / steps_per_block);
        const auto depth = [&](double share) {
            return -cutter_clearance(sweep_.pose(segment, share), cutter_, point);
        };
        return -golden_maximum(depth, low, high, golden_sections).value();
    }

    const Sweep& sweep_;
    const CutterShape& cutter_;
    std::vector<double> bounds_;  // of the groups
    std::vector<NearPose> near_;
};

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

double cutter_clearance(const ToolPose& pose, const CutterShape& cutter, const Eigen::Vector3d& point) {
    const Eigen::Vector3d from_tip = point - pose.tip;
    const double along = -from_tip.dot(pose.axis);  // up the cutter
    const double side = (from_tip + along * pose.axis).norm() - 0.5 * cutter.diameter;
    const double beyond = std::max(-along, along - cutter.length);
    if (beyond <= 0.0) return std::max(side, -along);  // what holds the cutter is as thick
    const double outside = std::max(side, 0.0);
    return std::sqrt(outside * outside + beyond * beyond);  // hypot would take most of the check's time
}

void CutterShape::validate() const {
    if (!(std::isfinite(diameter) && diameter > 0.0))
        throw InputError(fmt::format("cutter: the diameter must be > 0 m, found {:g}", diameter));
    if (!(std::isfinite(length) && length > 0.0))
        throw InputError(fmt::format("cutter: the length must be > 0 m, found {:g}", length));
}

NcSurfaceCheck check_surface(std::span<const NcMove> moves, const Machine& machine, const CutterShape& cutter,
                             std::span<const Eigen::Vector3d> points) {
    cutter.validate();
    if (points.empty()) throw InputError("NC check: there are no points to check");
    const Sweep sweep(moves, machine, cutter);
    NcSurfaceCheck check;
    PointClearance clearance(sweep, cutter);
    check.points = points.size();
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite())
            throw InputError(fmt::format("NC check: point {} of the surface is not finite", i));
        const double least = clearance.least(points[i]);
        if (least < lowest) {
            lowest = least;
            check.gouge_point = i;
        }
        if (least > highest) {
            highest = least;
            check.stock_point = i;
        }
    }
    check.least_stock = lowest;
    check.gouge = std::max(-lowest, 0.0);
    check.stock = std::max(highest, 0.0);
    return check;
}

}  // namespace camopt

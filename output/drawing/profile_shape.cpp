// SPDX-License-Identifier: MIT
#include "output/drawing/profile_shape.hpp"

#include "core/numbers/scalar_search.hpp"
#include "core/whole_turn.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "studies/check/check_cam.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double from_inside = 1e-9;  // of a piece's length: its ends are looked at from this far inside
constexpr double same_place = 1e-9;   // of the base radius: two points of the cam are one
constexpr int rim_samples = 1440;
constexpr int cusp_samples = 720;    // angles searched for sign changes of the regularity
constexpr int cusp_bisections = 60;  // down to neighbouring numbers

double crossing(const ProfileShape& shape, double left, double right) {
    const bool left_regular = shape.at(left).regularity > 0.0;
    const auto like_left = [&](double theta) { return (shape.at(theta).regularity > 0.0) == left_regular; };
    const Border border = bisected(like_left, {left, right}, cusp_bisections);
    return 0.5 * (border.with + border.without);
}

Vector2d in_cam_frame(const DiskCam& cam, const Vector2d& fixed, double theta) {
    const double turn = sense_of(cam.rotation) * theta;
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * fixed.x() + s * fixed.y(), c * fixed.y() - s * fixed.x()};
}

}  // namespace

ProfileShape other_side(const ProfileShape& shape) {
    ProfileShape side = shape;
    side.at = shape.other;
    side.other = {};
    return side;
}

std::optional<double> rim_radius(const ProfileShape& shape) {
    if (!shape.cam.form.is_grooved()) return std::nullopt;
    double greatest = 0.0;
    for (int i = 0; i <= rim_samples; ++i) {
        const double theta = shape.begin() + (shape.end() - shape.begin()) * i / rim_samples;
        greatest = std::max(greatest, shape.other(theta).contact.norm());
    }
    return greatest + shape.cam.form.groove_wall.value_or(shape.cam[DimensionIndex::roller_radius]);
}

std::vector<ProfileShape> made_pieces(const ProfileShape& shape) {
    if (!shape.cam.form.is_conjugate()) return {shape};
    ProfileShape first = shape, second = other_side(shape);
    first.other = {};
    first.cam.form = second.cam.form = {};
    const FormSpec& form = shape.cam.form;
    const auto set = [&](DimensionIndex which, const std::optional<double>& value) {
        if (value) second.cam.dimensions[static_cast<std::size_t>(which)] = *value;
    };
    set(DimensionIndex::roller_radius, form.second_roller_radius);
    set(DimensionIndex::offset, form.second_offset);
    set(DimensionIndex::arm_length, form.second_arm_length);
    double least = HUGE_VAL;
    for (const std::vector<ProfilePoint>& piece : profile_pieces(second, rim_samples))
        for (const ProfilePoint& point : piece) least = std::min(least, point.contact.norm());
    set(DimensionIndex::base_radius, least);
    return {std::move(first), std::move(second)};
}

ProfileShape profile_shape(const DiskCam& cam, const Motion& motion, const MotionScale& scale) {
    ProfileShape shape;
    shape.cam = cam;
    for (const double x : motion.breakpoints()) shape.knots.push_back(scale.unit_angle * x);
    shape.start = std::clamp(0.0, shape.begin(), shape.end());
    const double last = motion.end();
    shape.at = [cam, &motion, scale, last](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), last);
        const MotionPoint point = motion.at(x, x < last ? Side::right : Side::left);
        return profile_point(cam, theta, state_of(point, scale));
    };
    if (side_count(cam) > 1)
        shape.other = [cam, &motion, scale, last](double theta) {
            const double x = std::clamp(theta / scale.unit_angle, motion.begin(), last);
            const MotionPoint point = motion.at(x, x < last ? Side::right : Side::left);
            return profile_point(cam, theta, state_of(point, scale), 1);
        };
    const Vector2d gap = shape.at(shape.end()).contact - shape.at(shape.begin()).contact;
    shape.closed = is_whole_turn(shape.end() - shape.begin()) &&
                   gap.norm() < same_place * cam[DimensionIndex::base_radius];
    return shape;
}

std::optional<ProfileShape> disk_shape(const Solution& solution, const Motion& motion) {
    const std::optional<DiskCam> cam = solution.cam ? disk_cam(solution.cam->cam) : std::nullopt;
    if (!cam) return std::nullopt;
    ProfileShape shape = profile_shape(*cam, motion, motion_scale(solution.scene));
    shape.face_half_width = solution.scene.cam->face_half_width;
    if (!shape.closed) shape.open_because = open_because(solution);
    shape.length = shown_units(solution.scene).length;
    return shape;
}

std::vector<std::vector<ProfilePoint>> profile_pieces(const ProfileShape& shape, int steps) {
    std::vector<std::vector<ProfilePoint>> pieces;
    for (std::size_t i = 0; i + 1 < shape.knots.size(); ++i) {
        const double length = shape.knots[i + 1] - shape.knots[i], inside = from_inside * length;
        const int count =
            std::max(2, static_cast<int>(std::ceil(steps * length / (shape.end() - shape.begin()))));
        std::vector<ProfilePoint>& piece = pieces.emplace_back();
        for (int k = 0; k <= count; ++k)
            piece.push_back(shape.at(std::clamp(shape.knots[i] + length * k / count, shape.knots[i] + inside,
                                                shape.knots[i + 1] - inside)));
    }
    return pieces;
}

std::vector<double> cusp_angles(const ProfileShape& shape) {
    std::vector<double> angles;
    for (const std::vector<ProfilePoint>& piece : profile_pieces(shape, cusp_samples))
        for (std::size_t k = 1; k < piece.size(); ++k)
            if ((piece[k - 1].regularity > 0.0) != (piece[k].regularity > 0.0))
                angles.push_back(crossing(shape, piece[k - 1].theta, piece[k].theta));
    return angles;
}

FollowerPose follower_pose(const DiskCam& cam, const ProfilePoint& point) {
    FollowerPose pose;
    pose.lift = in_cam_frame(cam, {0.0, 1.0}, point.theta);
    if (!is_oscillating(cam.follower)) return pose;
    pose.pivot = in_cam_frame(cam, {cam[DimensionIndex::center_distance], 0.0}, point.theta);
    pose.foot = pose.pivot - point.normal * point.normal.dot(pose.pivot - point.contact);
    return pose;
}

}  // namespace camopt

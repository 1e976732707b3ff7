// SPDX-License-Identifier: MIT
#include "report/drawing/profile_shape.hpp"

#include <Eigen/Geometry>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double from_inside = 1e-9;  // of a piece's length: its ends are looked at from this far inside
constexpr double same_end = 1e-9;     // of the cam's radius there: two points of the cam are one
constexpr int rim_samples = 1440;
constexpr int cusp_samples = 720;    // angles searched for sign changes of the regularity
constexpr int cusp_bisections = 60;  // down to neighbouring numbers

double crossing(const ProfileShape& shape, double left, double right) {
    const bool left_regular = shape.at(left).regularity > 0.0;
    const auto like_left = [&](double theta) { return (shape.at(theta).regularity > 0.0) == left_regular; };
    const Border border = bisected(like_left, {left, right}, cusp_bisections);
    return 0.5 * (border.with + border.without);
}

void set_cam(ProfileShape& shape, const DrivenMechanism& cam) {
    shape.cam = cam;
    const DirectCam* const direct = cam.formulas->direct();
    if (direct != nullptr) shape.direct = direct->drawing(cam.dimensions);
}

}  // namespace

Vector2d ProfileShape::turned_back(const Vector2d& fixed, double theta) const {
    const Vector2d center = parts(theta).front().points.front();
    const CamPose pose = formulas().plane()->pose(state(theta));
    return center + Eigen::Rotation2Dd(-pose.turn) * (fixed - center - pose.shift);
}

ProfileShape other_side(const ProfileShape& shape) {
    ProfileShape side = shape;
    side.at = shape.other;
    side.other = {};
    return side;
}

std::optional<double> rim_radius(const ProfileShape& shape) {
    if (!shape.is_grooved()) return std::nullopt;
    double greatest = 0.0;
    for (int i = 0; i <= rim_samples; ++i) {
        const double theta = shape.begin() + (shape.end() - shape.begin()) * i / rim_samples;
        greatest = std::max(greatest, shape.other(theta).contact.norm());
    }
    return greatest + *shape.direct->groove_wall;
}

std::vector<ProfileShape> made_pieces(const ProfileShape& shape) {
    if (!shape.has_two_disks()) return {shape};
    const std::vector<DrivenMechanism>& pieces = shape.direct->pieces;
    ProfileShape first = shape, second = other_side(shape);
    first.other = {};
    set_cam(first, pieces.front());
    double least = HUGE_VAL;
    for (const std::vector<MechanismPoint>& piece : profile_pieces(second, rim_samples))
        for (const MechanismPoint& point : piece) least = std::min(least, point.contact.norm());
    DrivenMechanism disk = pieces.back();
    disk.dimensions[static_cast<std::size_t>(disk.formulas->base_radius_index())] = least;
    set_cam(second, disk);
    return {std::move(first), std::move(second)};
}

ProfileShape profile_shape(const std::shared_ptr<const CamPoints>& points) {
    ProfileShape shape;
    set_cam(shape, points->cam());
    shape.picture = presentation_of(shape.cam).picture;
    const double unit_angle = points->scale().unit_angle;
    for (const double x : points->motion().breakpoints()) shape.knots.push_back(unit_angle * x);
    shape.start = std::clamp(0.0, shape.begin(), shape.end());
    const auto points_of = [&](int station) {
        return
            [points, unit_angle, station](double theta) { return points->at(theta / unit_angle, station); };
    };
    shape.at = points_of(0);
    if (shape.formulas().stations() > 1) shape.other = points_of(1);
    shape.output = [points, unit_angle](double theta) {
        return state_of(points->motion_at(theta / unit_angle), points->scale());
    };
    const MechanismPoint end = shape.at(shape.end());
    const Vector2d gap = in_plane(end.contact - shape.at(shape.begin()).contact);
    shape.closed = is_whole_turn(shape.end() - shape.begin()) && gap.norm() < same_end * end.contact.norm();
    return shape;
}

std::optional<ProfileShape> plane_shape(const View& view) {
    if (!view.delivered.cam || view.delivered.cam->cam().formulas->plane() == nullptr) return std::nullopt;
    ProfileShape shape = profile_shape(view.delivered.cam);
    if (view.solution.scene.cam) shape.face_half_width = view.solution.scene.cam->face_half_width;
    if (!shape.formulas().base_radius(shape.cam.dimensions))
        shape.least_radius = view.solution.cam->summary.base_radius;
    if (!shape.closed && shape.picture.outline == CamOutline::round)
        shape.open_because = open_because(view.solution);
    shape.length = view.units.length;
    return shape;
}

std::optional<ProfileShape> delivered_shape(const View& view) {
    std::optional<ProfileShape> shape = plane_shape(view);
    if (shape && !shape->direct) shape.reset();
    return shape;
}

std::vector<std::vector<MechanismPoint>> profile_pieces(const ProfileShape& shape, int steps) {
    std::vector<std::vector<MechanismPoint>> pieces;
    for (std::size_t i = 0; i + 1 < shape.knots.size(); ++i) {
        const double length = shape.knots[i + 1] - shape.knots[i], inside = from_inside * length;
        const int count =
            std::max(2, static_cast<int>(std::ceil(steps * length / (shape.end() - shape.begin()))));
        std::vector<MechanismPoint>& piece = pieces.emplace_back();
        for (int k = 0; k <= count; ++k)
            piece.push_back(shape.at(std::clamp(shape.knots[i] + length * k / count, shape.knots[i] + inside,
                                                shape.knots[i + 1] - inside)));
    }
    return pieces;
}

std::vector<double> cusp_angles(const ProfileShape& shape) {
    std::vector<double> angles;
    for (const std::vector<MechanismPoint>& piece : profile_pieces(shape, cusp_samples))
        for (std::size_t k = 1; k < piece.size(); ++k)
            if ((piece[k - 1].regularity > 0.0) != (piece[k].regularity > 0.0))
                angles.push_back(crossing(shape, piece[k - 1].theta, piece[k].theta));
    return angles;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/check/forward_check_input.hpp"

#include "core/errors.hpp"
#include "core/infinity.hpp"
#include "core/whole_turn.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/disk/disk_sides.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace camopt {

namespace {

constexpr double same_point = 1e-9;  // of the base radius: two points are one

/// The lever seen as the arm of a disk cam: its pivot on the +x axis, its roller above it.
struct AsDisk {
    double turn = 0.0;    ///< angle of the pivot from the cam's centre: the frame is turned back by it
    double mirror = 1.0;  ///< −1: and mirrored
    DiskCam cam;

    [[nodiscard]] Eigen::Vector2d point(const Eigen::Vector3d& own) const {
        const Eigen::Vector2d turned = Eigen::Rotation2Dd(-turn) * own.head<2>();
        return {turned.x(), mirror * turned.y()};
    }
    /// The lever's angle for ψ of the disk cam.
    [[nodiscard]] double lever_angle(double psi) const { return turn + mirror * (std::numbers::pi - psi); }
};

AsDisk disk_of(const RollerLever& lever, Rotation rotation) {
    const Eigen::Vector2d pivot = lever.pivot - lever.center;
    AsDisk disk;
    disk.turn = std::atan2(pivot.y(), pivot.x());
    const double beta = std::remainder(lever.start - disk.turn, 2.0 * std::numbers::pi);
    disk.mirror = beta < 0.0 ? -1.0 : 1.0;
    const bool clockwise = (rotation == Rotation::clockwise) == (disk.mirror > 0.0);
    disk.cam.follower = FollowerType::oscillating_roller;
    disk.cam.rotation = clockwise ? Rotation::clockwise : Rotation::counterclockwise;
    const double a = pivot.norm(), l = lever.arm, psi = std::numbers::pi - std::abs(beta);
    const double prime = std::sqrt(a * a + l * l - 2.0 * a * l * std::cos(psi));
    const auto set = [&](DimensionIndex which, double value) {
        disk.cam.dimensions[static_cast<std::size_t>(which)] = value;
    };
    set(DimensionIndex::center_distance, a);
    set(DimensionIndex::arm_length, l);
    set(DimensionIndex::roller_radius, lever.roller_radius);
    set(DimensionIndex::base_radius, prime - lever.roller_radius);
    return disk;
}

/// Points of a disk with the follower `cam`.
ForwardCheckInput input_of(const DiskCam& cam, const Motion& motion, const MotionScale& scale) {
    ForwardCheckInput input;
    input.cam = cam;
    input.begin = scale.unit_angle * motion.begin();
    input.end = scale.unit_angle * motion.end();
    input.designed = [&motion, scale](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), motion.end());
        return scale.lift * motion.at(x).derivative[0];
    };
    return input;
}

ForwardCheckInput input_of(const RollerLever& lever, const AsDisk& disk, const Motion& motion,
                           const MotionScale& scale) {
    ForwardCheckInput input = input_of(disk.cam, motion, scale);
    const double start = rest_position(disk.cam);
    input.output = [disk, start, run = lever.output](double lift) {
        return run(disk.lever_angle(start + lift));
    };
    input.output_size = scale.lift;
    return input;
}

void set_points(ForwardCheckInput& input, std::vector<Eigen::Vector2d> points, std::vector<int> breaks) {
    input.points = std::move(points);
    input.breaks = std::move(breaks);
    const double gap = (input.points.back() - input.points.front()).norm();
    input.closed =
        is_whole_turn(input.end - input.begin) && gap < same_point * input.cam[DimensionIndex::base_radius];
}

using Eigen::Vector2d;

constexpr double rounding = 1e-10;        // of a length: a cut this deep is none
constexpr double gaps_in_roller = 0.125;  // of its radius: between points this close a roller sinks by 0.2 %

/// The height or the angle at which it rests on the circle of the base radius.
double start_of(const DiskCam& cam) {
    using enum DimensionIndex;
    const double base = cam[base_radius], distance = cam[center_distance];
    const double prime = base + (has_roller(cam.follower) ? cam[roller_radius] : 0.0);
    if (has_pushed_face(cam.follower)) return base;
    if (!is_oscillating(cam.follower)) return std::sqrt(prime * prime - cam[offset] * cam[offset]);
    if (has_turning_face(cam.follower)) return std::asin((base + cam[face_offset]) / distance);
    const double arm = cam[arm_length];
    return std::acos((distance * distance + arm * arm - prime * prime) / (2.0 * distance * arm));
}

}  // namespace

ForwardCheckInput forward_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                      const MotionScale& scale, int points) {
    const std::optional<RollerLever> lever = mechanism.formulas->roller_lever(mechanism.dimensions);
    const std::optional<DiskCam> cam = disk_cam(mechanism);
    if (!lever && !cam)
        throw InputError("the forward check needs a lever that carries the roller, and there is none");
    const std::optional<AsDisk> disk =
        lever ? std::optional(disk_of(*lever, mechanism.formulas->rotation())) : std::nullopt;
    ForwardCheckInput input = disk ? input_of(*lever, *disk, motion, scale) : input_of(*cam, motion, scale);
    MechanismProfile profile = mechanism_profile(mechanism, motion, scale, points);
    std::vector<Eigen::Vector2d> contacts;
    contacts.reserve(profile.points.size());
    for (const MechanismPoint& point : profile.points)
        contacts.push_back(disk ? disk->point(point.contact) : Eigen::Vector2d(point.contact.head<2>()));
    set_points(input, std::move(contacts), std::move(profile.breaks));
    return input;
}

ForwardCheckInput side_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale, const CheckedSide& side) {
    const DiskCam whole = disk_cam(mechanism).value();
    const bool mirrored = whole.form.is_conjugate() && side.side == 1;
    DiskCam own = mirrored ? second_disk(whole) : whole;
    own.form = {};
    const auto at = [&own](DimensionIndex which) -> double& {
        return own.dimensions[static_cast<std::size_t>(which)];
    };
    at(DimensionIndex::base_radius) += at(DimensionIndex::roller_radius) - side.roller_radius;
    at(DimensionIndex::roller_radius) = side.roller_radius;
    ForwardCheckInput input = input_of(own, motion, scale);
    if (mirrored)
        input.designed = [first = std::move(input.designed)](double theta) { return -first(theta); };
    input.from_inside = whole.form.is_grooved() && side.side == 1;
    input.keep_found = true;
    MechanismProfile profile = mechanism_profile(mechanism, motion, scale, side.points, side.side);
    std::vector<Eigen::Vector2d> contacts;
    contacts.reserve(profile.points.size());
    for (const MechanismPoint& point : profile.points)
        contacts.emplace_back(point.contact.x(), mirrored ? -point.contact.y() : point.contact.y());
    set_points(input, std::move(contacts), std::move(profile.breaks));
    return input;
}

TouchingFollower::TouchingFollower(const DiskCam& cam)
    : oscillates_(is_oscillating(cam.follower)),
      flat_(has_flat_face(cam.follower)),
      roller_(has_roller(cam.follower) ? cam[DimensionIndex::roller_radius] : 0.0),
      offset_(cam[DimensionIndex::offset]),
      distance_(cam[DimensionIndex::center_distance]),
      arm_(cam[DimensionIndex::arm_length]),
      face_(cam[DimensionIndex::face_offset]),
      start_(start_of(cam)) {}

double TouchingFollower::lift_on(const Vector2d& point) const {
    if (!oscillates_ && flat_) return point.y();
    if (!oscillates_) {
        const double across = point.x() - offset_, square = roller_ * roller_ - across * across;
        return square >= 0.0 ? point.y() + std::sqrt(square) : -infinity;
    }
    // In the triangle pivot, point, roller centre; seen from the pivot, from the line to the cam centre
    // upwards.
    const double away = std::hypot(distance_ - point.x(), point.y());
    const double point_angle = std::atan2(point.y(), distance_ - point.x());
    if (flat_) return away > std::abs(face_) ? point_angle + std::asin(face_ / away) : -infinity;
    const double cosine = (arm_ * arm_ + away * away - roller_ * roller_) / (2.0 * arm_ * away);
    return std::abs(cosine) <= 1.0 ? point_angle + std::acos(cosine) : -infinity;
}

double TouchingFollower::lift_under(const Vector2d& point) const {
    if (!(point.y() > 0.0)) return infinity;
    if (!oscillates_) {
        const double across = point.x() - offset_, square = roller_ * roller_ - across * across;
        return square >= 0.0 ? point.y() - std::sqrt(square) : infinity;
    }
    const double away = std::hypot(distance_ - point.x(), point.y());
    const double point_angle = std::atan2(point.y(), distance_ - point.x());
    const double cosine = (arm_ * arm_ + away * away - roller_ * roller_) / (2.0 * arm_ * away);
    return std::abs(cosine) <= 1.0 ? point_angle - std::acos(cosine) : infinity;
}

StandingFollower TouchingFollower::standing_at(double lift) const {
    if (!oscillates_ && flat_) return {false, {0.0, lift}, {0.0, 1.0}, {0.0, 0.0}, rounding * lift};
    const double square = roller_ * roller_ * (1.0 - rounding);
    if (!oscillates_) return {true, {offset_, lift}, {0.0, 0.0}, {0.0, 0.0}, square};
    const Vector2d pivot(distance_, 0.0), arm(-std::cos(lift), std::sin(lift)), swing(arm.y(), -arm.x());
    if (flat_) return {false, pivot - face_ * swing, swing, arm, rounding * distance_};
    return {true, pivot + arm_ * arm, {0.0, 0.0}, {0.0, 0.0}, square};
}

double TouchingFollower::lever() const {
    if (!oscillates_) return 1.0;
    return flat_ ? distance_ : arm_;
}

double TouchingFollower::widest_gap() const {
    return roller_ > 0.0 ? gaps_in_roller * roller_ : infinity;
}

}  // namespace camopt

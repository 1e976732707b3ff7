// SPDX-License-Identifier: MIT
#include "studies/check/forward_check_input.hpp"

#include "core/errors.hpp"
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

}  // namespace camopt

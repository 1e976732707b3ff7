// SPDX-License-Identifier: MIT
#include "profiles/spatial/spatial_cam.hpp"

#include "core/text/quantity_text.hpp"
#include "profiles/spatial/spatial_formulas.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace camopt {
namespace {

using Eigen::Vector3d;
using enum SpatialDimension;

/// The vector in the frame of a cam rotated by `angle`.
Vector3d turned_back(const Vector3d& fixed, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * fixed.x() + s * fixed.y(), c * fixed.y() - s * fixed.x(), fixed.z()};
}

/// In the fixed frame.
RollerAxis standing_axis(const SpatialCam& cam, double q) {
    const double c = std::cos(q), s = std::sin(q);
    switch (cam.follower) {
        case SpatialFollower::barrel:
            return {{cam[arm_length] * c - cam[lateral_offset], cam[center_distance],
                     -cam[arm_length] * s - cam.axial_offset},
                    -Vector3d::UnitY(),
                    {-s, 0.0, -c}};
        case SpatialFollower::cylindrical_rotating:
            return {{cam[lateral_offset], cam[center_distance] - cam[arm_length] * c,
                     cam.axial_offset + cam[arm_length] * s},
                    {0.0, -c, s},
                    {0.0, s, c}};
        case SpatialFollower::cylindrical_translating:
            return {{cam[lateral_offset], cam[center_distance], cam.axial_offset + q},
                    -Vector3d::UnitY(),
                    Vector3d::UnitZ()};
    }
    throw ModelError("a follower of no known type");
}

/// In the cam frame, with the follower at q.
RollerAxis axis_at(const SpatialCam& cam, double theta, double q) {
    RollerAxis axis = standing_axis(cam, q);
    const double turn = sense_of(cam.rotation) * theta;
    for (Vector3d* vector : {&axis.foot, &axis.direction, &axis.travel}) *vector = turned_back(*vector, turn);
    return axis;
}

/// Of the index or the arm, in the frame that stands still.
std::optional<Vector3d> pivot_of(const SpatialCam& cam) {
    const double across = cam[lateral_offset], away = cam[center_distance];
    if (!swings(cam.follower)) return {};
    if (cam.follower == SpatialFollower::barrel) return Vector3d(-across, away, -cam.axial_offset);
    return Vector3d(across, away, cam.axial_offset);
}

std::string dimension_fault(const SpatialCam& cam) {
    for (int i = 0; i < spatial_dimension_count; ++i) {
        const auto index = static_cast<SpatialDimension>(i);
        const bool unused = index == arm_length && cam.follower == SpatialFollower::cylindrical_translating;
        std::string fault = length_fault(name_of(index), cam[index], index == lateral_offset || unused);
        if (!fault.empty()) return fault;
    }
    if (!std::isfinite(cam.axial_offset) || !std::isfinite(cam.start))
        return "the axial_offset or the start is not a number";
    if (!(cam.form.groove_clearance >= 0.0)) return "the groove_clearance is negative";
    return length_fault("roller_length", cam.roller_length, false);
}

std::string swing_fault(double low, double high) {
    const double right_angle = 0.5 * std::numbers::pi;
    if (low > -right_angle && high < right_angle) return {};
    return fmt::format("the follower swings from {:.6g} to {}, beyond a right angle", low / units::degree,
                       angle_text(high));
}

/// The far end of the roller's axis keeps its distance from the cam's axis: `radial` > 0.
std::string far_end_fault(double radial) {
    if (radial > 0.0) return {};
    return fmt::format("the far end of the roller is {} from the cam's axis", length_text(radial));
}

}  // namespace

SpatialCam::operator CamFlanks() const {
    CamFlanks flanks;
    flanks.rotation = rotation;
    flanks.roller_radius = groove_radius();
    flanks.roller_length = roller_length;
    flanks.clearance = form.groove_clearance;
    flanks.body = form.body;
    flanks.start = start;
    flanks.swings = camopt::swings(follower);
    flanks.pivot = pivot_of(*this);
    if (follower == SpatialFollower::cylindrical_rotating)
        flanks.arc = RollerArc{(*this)[arm_length], (*this)[center_distance], axial_offset};
    flanks.axis_at = [cam = *this](double theta, double q) { return camopt::axis_at(cam, theta, q); };
    flanks.point = [cam = *this](double theta, const FollowerState& state, const RollerStation& station) {
        const SpatialPoint point = spatial_point(cam, theta, state, station);
        return FlankPoint{point.center, point.contact, point.normal};
    };
    return flanks;
}

RollerAxis roller_axis(const SpatialCam& cam, double theta, double s) {
    return axis_at(cam, theta, cam.start + s);
}

SpatialPoint spatial_point(const SpatialCam& cam, double theta, const FollowerState& state,
                           const RollerStation& station) {
    const RollerAxis axis = roller_axis(cam, theta, state.s);
    const auto motion =
        spatial_formulas::axis_motion(cam, spatial_formulas::variables_of(cam, state), station.height);
    const double speed = std::hypot(motion.across_travel, motion.along_b);
    const double side = station.flank > 0 ? 1.0 : -1.0;
    const Vector3d across = axis.travel.cross(axis.direction);
    SpatialPoint point;
    point.center = axis.foot + station.height * axis.direction;
    point.normal = side / speed * (motion.across_travel * across - motion.along_b * axis.travel);
    point.contact = point.center + cam.groove_radius() * point.normal;
    point.pressure_angle =
        std::atan2(motion.across_travel, spatial_formulas::sign_of_b(cam) * motion.along_b);
    point.undercut = spatial_formulas::undercut(motion, cam.groove_radius(), station.flank);
    point.contact_radius = spatial_formulas::contact_radius(cam, motion, cam[roller_radius], station.flank);
    return point;
}

DrumExtent drum_extent(const SpatialCam& cam, double least, double most) {
    DrumExtent extent{HUGE_VAL, -HUGE_VAL, 0.0, 0.0};
    const double low = cam.start + least, high = cam.start + most;
    for (const double q : {low, high, std::clamp(0.0, low, high)}) {
        const RollerAxis axis = standing_axis(cam, q);
        const Vector3d ends[] = {axis.foot, axis.foot + cam.roller_length * axis.direction};
        const double half_width = cam.groove_radius() * axis.direction.head<2>().norm();
        for (const Vector3d& end : ends)
            for (const double side : {1.0, -1.0}) {
                const double z = end.z() + side * half_width;
                extent.lower = std::min(extent.lower, z);
                extent.upper = std::max(extent.upper, z);
            }
        extent.outer_radius = std::max(extent.outer_radius, ends[0].head<2>().norm());
        extent.floor_radius = std::max(extent.floor_radius, ends[1].head<2>().norm());
    }
    return extent;
}

// Whether a spatial cam can be built: at rest, and over the whole range of its motion.

std::string geometry_fault(const SpatialCam& cam, double least, double most) {
    if (std::string fault = dimension_fault(cam); !fault.empty()) return fault;
    if (cam.follower == SpatialFollower::cylindrical_translating || cam.follower == SpatialFollower::barrel) {
        if (cam.follower == SpatialFollower::barrel)
            if (std::string fault = swing_fault(cam.start + least, cam.start + most); !fault.empty())
                return fault;
        return far_end_fault(cam[center_distance] - cam.roller_length);
    }
    const double low = cam.start + least, high = cam.start + most;
    if (std::string fault = swing_fault(low, high); !fault.empty()) return fault;
    const double straightest = low <= 0.0 && high >= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high));
    return far_end_fault(cam[center_distance] -
                         (cam[arm_length] + cam.roller_length) * std::cos(straightest));
}

}  // namespace camopt

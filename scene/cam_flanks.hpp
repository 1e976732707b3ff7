// SPDX-License-Identifier: MIT
// A three-dimensional cam as exports and forward checks see it: the axis of its roller and the two flanks
// that the roller touches, as functions of the cam angle. Made by CamMechanism::flanks (cam_mechanism.hpp).
//
// Frames. The cam's axis is z. In the frame that stands still the cam turns by σθ about +z (sense_of its
// rotation); cam frame = Rot_z(−σθ) · fixed, so both are the same at cam angle 0. The roller's axis is the
// line C(θ, h) = c + h e, h >= 0 along the roller from its near end; the roller touches the flank σ_f = ±1.
// The follower's position is q = start + s; a swinging follower points at the cam's axis at q = 0.
// m, rad.
#pragma once

#include "core/motion.hpp"
#include "scene/cam_spec.hpp"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace camopt {

/// The motion of a follower over the cam angle: s, s', s'' by the cam angle θ (rad) in SI.
struct FollowerMotion {
    /// Where s'' jumps the limit from above (at the end from below).
    std::function<FollowerState(double theta)> state;
    /// Ascending cam angles where the motion changes its formula; begin and end are the first and the last.
    std::vector<double> breakpoints;

    [[nodiscard]] double begin() const { return breakpoints.front(); }
    [[nodiscard]] double end() const { return breakpoints.back(); }
};

/// A place on the roller: distance h from its near end, and which of the two flanks it touches there.
struct RollerStation {
    double height = 0.0;  ///< h, m
    int flank = 1;        ///< σ_f: +1 or −1
};

/// The roller's axis at one cam angle; vectors of the cam frame.
struct RollerAxis {
    Eigen::Vector3d foot;       ///< c: the near end, h = 0
    Eigen::Vector3d direction;  ///< e, unit: from the near to the far end
    Eigen::Vector3d travel;     ///< u, unit: where the axis goes with growing s
};

/// What the roller touches at one cam angle and one station; vectors of the cam frame.
struct FlankPoint {
    Eigen::Vector3d center;   ///< C: of the roller's axis
    Eigen::Vector3d contact;  ///< C + r n: a point of the flank
    Eigen::Vector3d normal;   ///< n, unit, from the roller's axis into the cam's material
};

/// The arc that the near end of a roller describes in a plane through the cam's axis.
struct RollerArc {
    double radius = 0.0;     ///< > 0
    double from_axis = 0.0;  ///< of its centre
    double z = 0.0;          ///< of its centre
};

struct CamFlanks {
    Rotation rotation = Rotation::counterclockwise;
    double roller_radius = 0.0, roller_length = 0.0;
    double start = 0.0;   ///< the follower's position at displacement 0
    bool swings = false;  ///< the follower turns, and its position is an angle
    /// About which the rollers swing, in the frame that stands still; none: they slide.
    std::optional<Eigen::Vector3d> pivot = {};
    /// Of a roller that tilts with its follower; none: it stays square to the cam's axis.
    std::optional<RollerArc> arc = {};
    std::function<RollerAxis(double theta, double position)> axis_at;
    std::function<FlankPoint(double theta, const FollowerState& state, const RollerStation& station)> point;

    [[nodiscard]] RollerAxis axis(double theta, double s) const { return axis_at(theta, start + s); }
};

}  // namespace camopt

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

#include "scene/cam_spec.hpp"

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

/// How the body of a drum is turned, as far as the scene says so; m.
struct DrumBody {
    std::optional<double> diameter = {}, length = {};
    std::optional<double> wall = {};  ///< least one between the groove and either end of the body
    std::optional<double> bore = {};  ///< diameter
    friend bool operator==(const DrumBody&, const DrumBody&) = default;
};

/// Of a body of revolution, or of what a groove takes of one: largest radius, ends along the axis; m.
struct DrumSize {
    double radius = 0.0, lower = 0.0, upper = 0.0;
};
/// The body around a groove of this size. `wall`: at its ends where the scene gives neither wall nor length.
[[nodiscard]] DrumSize body_around(const DrumSize& groove, const DrumBody& body, double wall);

struct CamFlanks {
    Rotation rotation = Rotation::counterclockwise;
    /// Half the width of the groove: that of the roller where it has no clearance.
    double roller_radius = 0.0;
    double roller_length = 0.0;
    double clearance = 0.0;  ///< width of the groove less the diameter of its roller, m
    DrumBody body = {};
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

// Both flanks of a three-dimensional cam as grids of points: sections along the roller times cam angles.
//
// All vectors are of the cam frame (z is the cam's axis), lengths m, angles rad. The point
// of section i and angle j of a flank stands at index i · angles + j (`FlankGrid::index`). At one angle and
// one section the points of the two flanks lie opposite each other on the roller: their mean is the centre.
// The D and U of paper 001 (cutter location) are flanks[0] (σ_f = +1) and flanks[1] (σ_f = −1).
// A grid is open: its last angle does not join its first.

struct FlankSurface {
    int flank = 1;                        ///< σ_f
    std::vector<Eigen::Vector3d> points;  ///< of the cam's surface
    /// Unit normals out of the cam's material, towards the roller's axis: point = center − r · normal.
    std::vector<Eigen::Vector3d> normals;
};

struct FlankGrid {
    std::vector<double> heights;  ///< sections: distance h along the roller from its near end, ascending
    std::vector<double> angles;   ///< cam angles θ, ascending
    std::array<FlankSurface, 2> flanks;       ///< σ_f = +1, then −1
    std::vector<Eigen::Vector3d> feet;        ///< by angle: c, the near end (h = 0) of the roller's axis
    std::vector<Eigen::Vector3d> directions;  ///< by angle: e, unit, from the near to the far end
    std::vector<int> breaks;     ///< indices of angles where the motion changes its formula, inner ones only
    double roller_radius = 0.0;  ///< r

    [[nodiscard]] std::size_t index(std::size_t section, std::size_t angle) const {
        return section * angles.size() + angle;
    }
    [[nodiscard]] Eigen::Vector3d center(std::size_t section, std::size_t angle) const {
        return feet[angle] + heights[section] * directions[angle];
    }
};

/// The locations of the points.
struct FlankSampling {
    int sections = 8;  ///< evenly from h = from_height to to_height, both included; >= 2
    int angles = 201;  ///< evenly over the motion, its breakpoints besides; >= 2
    double from_height = 0.0, to_height = 0.0;  ///< both 0: the whole roller

    void validate() const;  ///< throws InputError
};

/// Evenly spaced cam angles of the motion with its breakpoints among them, ascending.
[[nodiscard]] std::vector<double> even_angles(const FollowerMotion& motion, int count);

[[nodiscard]] FlankGrid flank_grid(const CamFlanks& cam, const FollowerMotion& motion,
                                   const FlankSampling& sampling);
/// At given sections and angles; `breaks` are those breakpoints of the motion that are among the angles.
[[nodiscard]] FlankGrid flank_grid(const CamFlanks& cam, const FollowerMotion& motion,
                                   std::vector<double> heights, std::vector<double> angles);

// A cam that is the guide of a roller in a body that swings, as its forward check sees it: where the roller
// is, where the body must be, and what an error of the body moves the output by. Made by CamMechanism::guide
// (cam_mechanism.hpp). m, rad.

struct RollerGuide {
    double roller_radius = 0.0;
    /// From the body's pivot to the roller's centre at a cam angle; ascending.
    std::function<double(double theta)> distance;
    std::function<double(double distance)> cam_angle;  ///< its inverse
    /// ψ: polar angle of the roller's centre in the body where the output is in this state.
    std::function<double(const FollowerState& output)> angle;
    std::function<double(double angle)> ratio;  ///< |d output / dψ| where the body is at ψ
    /// How much faster than forwards the roller returns, slowing down to rest as it left it: the output then
    /// runs its curve backwards, the r-th derivatives times the r-th power of this. None: nothing is said of
    /// a return.
    std::optional<double> return_rate = {};
};

}  // namespace camopt

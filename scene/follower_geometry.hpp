// SPDX-License-Identifier: MIT
//
// A follower as a forward check places it on finished points of a cam: its shape and its guide, independent
// of the formulas that generate a cam. m, rad.
//
// Frame: fixed; its origin is the cam's centre. It is the mechanism's own frame rotated by −turn and
// then, where `mirrored`, reflected in the x axis, so that a swinging follower has its pivot on the +x axis
// and moves away from the cam where its position grows.
//   pushed:   along +y at x = offset; its position is y of the roller's centre, of the edge or of the face
//   swinging: about the pivot (pivot_distance, 0); its position is ψ, the angle at the pivot from the line to
//             the cam's centre up to the arm. The roller's centre is at pivot + arm · (−cos ψ, sin ψ); a flat
//             face is the line of the arm, displaced by face_offset towards the cam's centre
// The lift is the position less that at output 0, where the follower is rest_distance away from the cam's
// centre: with p = rest_distance, a = pivot_distance, l = arm, e = offset and f = face_offset
//   pushed:   y0 = p (flat), √(p² − e²)        swinging: sin ψ0 = (p + f)/a (flat),
//                                              cos ψ0 = (a² + l² − p²)/(2 a l)
#pragma once

#include "scene/follower.hpp"

#include <Eigen/Core>

#include <functional>

namespace camopt {

struct FollowerGeometry {
    ContactKind contact = ContactKind::roller;
    bool swings = false;
    double roller_radius = 0.0;                                 ///< 0: no roller
    double offset = 0.0;                                        ///< pushed; may be negative
    double pivot_distance = 0.0, arm = 0.0, face_offset = 0.0;  ///< swinging
    /// From the cam's centre at output 0: the roller's centre, the edge, the line of the face.
    double rest_distance = 0.0;
    double turn = 0.0;      ///< of the frame
    bool mirrored = false;  ///< the frame
    /// The points are the outer flank of a groove: the roller is at the least position at which it touches
    /// one of them from inside, instead of the largest from outside.
    bool from_inside = false;
    bool falls = false;  ///< without a linkage: the output is −lift, not the lift
    /// The output s for the angle of the arm from +x in the mechanism's own frame; NaN out of reach. None:
    /// the follower itself is the output.
    std::function<double(double arm_angle)> linkage = {};

    /// A point of the mechanism's own frame, with the cam's centre as the origin, in this frame.
    [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector2d& own) const;
    /// The angle of the arm from +x in the mechanism's own frame where it is at ψ in this one.
    [[nodiscard]] double arm_angle(double psi) const;
};

/// A lever that carries a roller, both at output 0.
struct RollerLever {
    Eigen::Vector2d pivot;  ///< seen from the cam's centre
    double arm = 0.0, roller_radius = 0.0;
    double angle = 0.0;  ///< of the arm, from +x
};

/// The follower formed by a roller on a lever, without its linkage.
[[nodiscard]] FollowerGeometry follower_on_lever(const RollerLever& lever);

}  // namespace camopt

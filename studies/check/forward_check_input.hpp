// SPDX-License-Identifier: MIT
// What a forward check is given about a cam that camopt has designed: the points it exports and its follower
// (CamMechanism::follower), and nothing of how it made them.
//
// profile points only -> follower -> output: where a linkage carries the follower's swing on, it is run
// forwards by positions alone.
#pragma once

#include "studies/check/forward_check.hpp"
#include "studies/delivered/driven_mechanism.hpp"

namespace camopt {

/// About `points` points evenly by cam angle, the motion's breakpoints among them. Closed where the motion
/// takes a whole turn and the cam ends where it began. The deviation is relative to the prime radius (a swing
/// times its arm, with a flat face times the centre distance), of a linkage to the lift. Keeps a reference to
/// the motion. Throws InputError for a mechanism without such a follower.
[[nodiscard]] ForwardCheckInput forward_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                    const MotionScale& scale, int points = 2000);

struct CheckedSide {
    int side = 0, points = 2000;
    double roller_radius = 0.0;  ///< m
};

/// The same for one side of a cam that drives both ways, with a roller of this radius whose centre is
/// designed to move as the cam's own does: in a groove one that fills it makes the deviation that of the
/// flank alone. What is found at each angle is kept.
[[nodiscard]] ForwardCheckInput side_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, const CheckedSide& side);

// A follower that lies on points of a cam: geometry of the follower only, nothing of how the cam was made.
//
// Frame and position as in scene/follower.hpp. The lift here is that position: y of the roller
// centre, edge or face (m), or ψ of the arm (rad). A point of the cam holds the follower at the lift at which
// it touches the point from outside; the cam holds it at the largest lift of all its points.

/// The follower at one lift: where its surface is.
struct StandingFollower {
    bool round = false;
    Eigen::Vector2d origin;   ///< round: centre; flat: a point of the face
    Eigen::Vector2d outward;  ///< flat: unit normal away from the cam
    Eigen::Vector2d along;    ///< swinging flat: the face lies ahead of the pivot, this way; else 0
    double limit = 0.0;       ///< round: least squared distance, flat: depth: what is less is rounding

    /// Whether the follower cuts into the point, by more than rounding.
    [[nodiscard]] bool cuts(const Eigen::Vector2d& point) const {
        const Eigen::Vector2d away = point - origin;
        if (round) return away.squaredNorm() < limit;
        return away.dot(outward) > limit && away.dot(along) >= 0.0;
    }
};

class TouchingFollower {
 public:
    explicit TouchingFollower(const FollowerGeometry& follower);

    /// The lift at output 0, from the distance at which the follower then is from the cam's centre.
    [[nodiscard]] double start() const { return start_; }
    /// The lift at which the follower touches the point; −infinity where it passes by. Not for a knife edge,
    /// which every point but those on its path passes by.
    [[nodiscard]] double lift_on(const Eigen::Vector2d& point) const;
    /// The lift at which a roller in a groove touches a point of the wall beyond it, which it cannot pass;
    /// infinite where it passes by. Only points above the cam's centre (the line of centres) are beyond it.
    [[nodiscard]] double lift_under(const Eigen::Vector2d& point) const;
    /// x of the knife edge's path, y its lift.
    [[nodiscard]] double path() const { return offset_; }
    /// Not for a knife edge, which has no extent.
    [[nodiscard]] StandingFollower standing_at(double lift) const;
    /// What a change of the lift of 1 moves at the contact, m: 1, or the arm (flat: the centre distance).
    [[nodiscard]] double lever() const;
    /// Points of the cam farther apart than this may let the follower slip between them. Infinite: no matter.
    [[nodiscard]] double widest_gap() const;

 private:
    bool swings_, flat_;
    double roller_, offset_, distance_, arm_, face_, start_;
};

}  // namespace camopt

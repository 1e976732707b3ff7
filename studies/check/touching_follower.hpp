// SPDX-License-Identifier: MIT
// A follower that lies on points of a cam: geometry of the follower only, nothing of how the cam was made.
//
// Frame and position as in scene/follower.hpp. The lift here is that position: y of the roller
// centre, edge or face (m), or ψ of the arm (rad). A point of the cam holds the follower at the lift at which
// it touches the point from outside; the cam holds it at the largest lift of all its points.
#pragma once

#include "core/numbers/extremum.hpp"
#include "scene/follower.hpp"

namespace camopt {

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
    double roller_, offset_, distance_, arm_, face_, start_, most_;
};

}  // namespace camopt

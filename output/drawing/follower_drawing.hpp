// SPDX-License-Identifier: MIT
// The follower of a cam in the cam frame: where the motion begins, whole; at other cam angles, as a ghost.
#pragma once

#include "output/drawing/picture_page.hpp"
#include "output/drawing/profile_shape.hpp"

namespace camopt {

/// The parts of the follower as the drawing shows them, m.
class FollowerDrawing {
 public:
    /// Least and largest contact offset over the cam: a flat face reaches a little beyond, unless the shape
    /// says how wide it is.
    FollowerDrawing(const ProfileShape& shape, double least_offset, double largest_offset);

    /// Points that the whole follower reaches, for the extent of the drawing.
    [[nodiscard]] std::vector<Eigen::Vector2d> reach() const;
    [[nodiscard]] std::vector<Eigen::Vector2d> ghost_reach(double theta) const;
    void draw_whole(const ProfileCanvas& canvas) const;
    void draw_ghost(const ProfileCanvas& canvas, double theta) const;

 private:
    struct Ghost {
        Eigen::Vector2d center, from, to;
    };

    [[nodiscard]] std::optional<double> pushed_face() const;
    [[nodiscard]] Ghost ghost_at(double theta) const;
    [[nodiscard]] Eigen::Vector2d along_face(const FollowerPose& pose) const;
    void draw_stem(const ProfileCanvas& canvas, const Eigen::Vector2d& foot, double gap) const;
    void draw_swinging(const ProfileCanvas& canvas) const;
    void draw_pivot(const ProfileCanvas& canvas, const Eigen::Vector2d& pivot) const;

    const ProfileShape& shape_;
    MechanismPoint start_;
    Eigen::Vector2d pitch_, contact_, normal_;  ///< of start_
    FollowerPose pose_;
    double size_;  ///< what the parts without a dimension are measured by
    double least_, largest_;
};

/// CSS rules of both drawings: follower, guide, pivot, ghost.
[[nodiscard]] std::string_view follower_style();

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Both flanks of a three-dimensional cam as grids of points: sections along the roller times cam angles.
//
// All vectors are of the cam frame (cam_flanks.hpp: z is the cam's axis), lengths m, angles rad. The point
// of section i and angle j of a flank stands at index i · angles + j (`FlankGrid::index`). At one angle and
// one section the points of the two flanks lie opposite each other on the roller: their mean is the centre.
// The D and U of paper 001 (cutter location) are flanks[0] (σ_f = +1) and flanks[1] (σ_f = −1).
// A grid is open: its last angle does not join its first.
#pragma once

#include "scene/cam_flanks.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace camopt {

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

}  // namespace camopt

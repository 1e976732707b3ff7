// SPDX-License-Identifier: MIT
// The finished cam as what no move of a cutter may enter.
//
//   depth(pose) >= max over points p of cutter ∩ cam of the distance from p to where a cutter may be
// so 0 or less means that the cutter, a cylinder without an upper end (blank.hpp), does not enter. It may be
// followed between samples: a cutter each of whose points has moved by δ or less, δ <= its radius, stands at
// most depth + δ deep. m, rad, frame of ToolPose.
//
//   plane     the contour between two heights: a polygon through `points` of it, its own error added.
//             depth = min(how far the tip is under the upper face, radius − distance of the axis from the
//             cam)
//   grooved   a blank less the places of one roller: a cutter that stands within the roller at some cam
//   angle,
//             or outside the blank, cuts nothing away. The roller has no near end, its far end is the floor.
#pragma once

#include "shop/nc/blank.hpp"

namespace camopt {

class FinishedCam {
 public:
    virtual ~FinishedCam() = default;
    /// Not const: it remembers where it found the last one, moves being followed in small steps.
    [[nodiscard]] virtual double depth(const ToolPose& pose, double cutter_radius) = 0;
    /// From the cutter's axis towards the nearest flank, unit; zero where both flanks are equally near.
    [[nodiscard]] virtual Eigen::Vector3d towards_flank(const ToolPose& pose) = 0;

 protected:
    FinishedCam() = default;
    FinishedCam(const FinishedCam&) = default;
    FinishedCam& operator=(const FinishedCam&) = default;
    FinishedCam(FinishedCam&&) = default;
    FinishedCam& operator=(FinishedCam&&) = default;
};

struct PlaneBody {
    PlaneContour contour;       ///< closed
    std::vector<double> knots;  ///< as in block_angles: the contour is smooth between them
    double upper = 0.0;         ///< z of its upper face, m; below it the cutter may be nowhere in the contour
    int points = 2880;          ///< >= 16
};
/// Throws InputError for numbers that are not valid.
[[nodiscard]] std::unique_ptr<FinishedCam> plane_finished_cam(const PlaneBody& body);

struct GroovedBody {
    RollerPath roller;
    double begin = 0.0, end = 0.0;  ///< cam angles, begin < end
    double radius = 0.0;            ///< of the roller, m, > 0
    double floor = 0.0;             ///< station of the groove's floor, m
    Blank blank;
    int poses = 2880;      ///< >= 16: where the search for the cam angle starts
    double enough = 3e-6;  ///< m: a depth found near the last place that is no larger ends the search
};
/// Throws InputError for numbers that are not valid.
[[nodiscard]] std::unique_ptr<FinishedCam> grooved_finished_cam(const GroovedBody& body);

}  // namespace camopt

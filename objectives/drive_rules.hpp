// SPDX-License-Identifier: MIT
// The torque and the speed of a motor that follows the motion (scene/drive_spec.hpp), as rules:
//
//   torque, each side     ± τ <= limit                                   linear, at every x
//   speed                 ± n <= limit
//   torque-speed curve    (± τ ± k n) / c <= 1, for each edge |τ| = c − k |n| of the polygon
//   rms                   (1/C) (∫ τ² dx + (C − L) τ_0²) <= limit²       convex quadratic, one row
//
// Where dynamics prescribes the output's motion the load hangs on a spring: the motor follows s, and the
// torque is that of s'' and of the output's y'' (SeenMotion::torque).
//
// C: the cycle, L: the motion, outside of which the axis rests with τ_0 = r F. Friction is a constant of each
// stroke.
#pragma once

#include "objectives/rules/linear_bound.hpp"
#include "scene/cost_table.hpp"

namespace camopt {

/// Along a motion of the scene from begin to end; where the output is prescribed (a MotionChain) of that.
[[nodiscard]] DriveFigures drive_figures(const Scene& scene, const Motion& motion);

/// τ and n at a point of the motion; of the stroke that `x`, seen from `side`, belongs to.
struct DrivePoint {
    double torque = 0.0, speed = 0.0;  ///< N m, rad/s
};
/// A part of the motion with one constant torque: r F and friction of its stroke.
struct DriveSpan {
    double begin = -infinity, end = infinity;
    double constant = 0.0;
};
class DriveAlong {
 public:
    explicit DriveAlong(const Scene& scene);
    /// `output`: where its motion is prescribed, and `point` is the motor's; null: they are one.
    [[nodiscard]] DrivePoint at(const MotionPoint& point, Side side,
                                const MotionPoint* output = nullptr) const;

 private:
    DriveTorque torque_;
    std::vector<DriveSpan> spans_;
    double of_output_ = 0.0;  ///< N m for y'' = 1 of a prescribed output
};

/// The limits that are linear; none without a drive.
[[nodiscard]] std::vector<WrittenBound> drive_bounds(const Scene& scene, const MotionFamily& family);

/// What a term of the motor is divided by, N m: the scene's number, or the reference law's own in the place
/// of the splines. Throws SceneError where that is not above 0, or infinite.
[[nodiscard]] double drive_reference(const Scene& scene, const MotionFamily& family,
                                     const ResponseTerm& term);

/// The terms, and the limit on rms.
void add_drive_rules(CamModel& model, const Scene& scene);

}  // namespace camopt

// SPDX-License-Identifier: MIT
//
// A servo axis: a motor that follows the motion through a transmission, in place of a cam.
//
//   τ = r (m a + c v + F + R sgn v) + J α,   α = a / r,   n = v / r,
//
// with r the output's travel a radian of the motor, m the load, c viscous friction, F a constant force and R
// dry friction, both against positive motion, and J the inertia of motor and gear at the motor. SI: kg,
// m/rad, N s/m, N, kg m²; of a swinging output kg m², 1, N m s/rad, N m. A scene without a DriveSpec
// evaluates none of it.
#pragma once

#include "core/numbers/extremum.hpp"

namespace camopt {

struct MotionSpec;

struct DriveSpec {
    double load = 0.0;                                             ///< m, >= 0
    double motor_inertia = 0.0;                                    ///< J, >= 0; one of the two is > 0
    double transmission = 0.0;                                     ///< r, > 0
    std::optional<std::array<double, 2>> transmission_range = {};  ///< searched: `transmission` was found
    double viscous = 0.0;                                          ///< c, >= 0
    double force = 0.0;                                            ///< F
    /// R, >= 0. Needs monotone strokes between given displacements; at rest it is 0.
    double friction = 0.0;
    /// Cam angle of the cycle that rms is taken over, rad; default a turn. Programs of one turn: a turn.
    std::optional<double> cycle = {};

    /// m r² / J: of the load at the motor by the motor's own; none without an inertia of the motor.
    [[nodiscard]] std::optional<double> inertia_ratio() const {
        if (!(motor_inertia > 0.0)) return {};
        return load * transmission * transmission / motor_inertia;
    }
    friend bool operator==(const DriveSpec&, const DriveSpec&) = default;
};

/// |τ| at a speed of the motor, as a point of a concave polygon: rad/s, N m.
using MotorCurve = std::vector<std::array<double, 2>>;

/// The torque and the speed of the motor of a motion y(x), in lifts over units of x:
/// τ = acceleration · y'' + velocity · y' + constant + friction · sgn y', n = speed · y'. N m, rad/s.
struct DriveTorque {
    double acceleration = 0.0, velocity = 0.0, constant = 0.0, friction = 0.0;
    double speed = 0.0;
};
/// What a motion asks of the motor. N m, rad/s, W; at: x.
struct DriveFigures {
    Extremum torque;          ///< the largest |τ|
    double rms_torque = 0.0;  ///< over the cycle
    Extremum speed;           ///< the largest |n|
    Extremum power;           ///< the largest |τ n|
    Extremum
        share_of_curve;  ///< the largest (|τ| + k |n|) / c over the edges |τ| = c − k |n|; 0 without a curve
};

/// The motion must have a speed.
[[nodiscard]] DriveTorque drive_torque(const DriveSpec& drive, const MotionSpec& motion);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Of the paper on inverse cams alone: its guide of lines and arcs, and its approximate method.
#pragma once

#include "benchmarks/papers/guide.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"

namespace camopt {

// The guide of the paper: a line from the pivot, two arcs, a line towards which the pivot lies; tangents
// agree.
//
//   S = R1 + R2,  alpha = beta + acos((R2 - x0 sin beta + R1 cos beta) / S),
//   C1 = (x0, R1),  C2 = (x0 + S sin alpha, R1 - S cos alpha)
// The first line runs along the body's +x axis up to x0; arc 1 bends to the left through alpha; arc 2 bends
// back to the direction beta of the last line, which points away from the pivot. Lengths m, angles rad.
// Errors: InputError where such a guide does not exist.

struct G1GuideDimensions {
    double line_end = 0.0;                           ///< x0 > 0
    double first_radius = 0.0, second_radius = 0.0;  ///< R1, R2 > 0
    double end_angle = 0.0;                          ///< beta, 0 < beta < pi / 2
    double begin = 0.0, end = 0.0;                   ///< L from which and up to which the guide exists
};

/// alpha and the second centre, as above. NaN where there is none.
struct G1GuideShape {
    double middle_angle = 0.0;  ///< alpha
    Eigen::Vector2d second_center;
};
[[nodiscard]] G1GuideShape g1_guide_shape(const G1GuideDimensions& dimensions);

/// Four pieces; its joints are begin, x0, L3, L4, end.
[[nodiscard]] Guide make_g1_guide(const G1GuideDimensions& dimensions);

// The paper's approximate method: the body's angle at nodes evenly spaced in time, its derivatives by central
// differences.
//
//   theta_i = -atan2(y_i, x_i) of the guide's point at L(t_i),  theta_i' = (theta_{i+1} - theta_{i-1}) / 2
//   dt, theta_i'' = (theta_{i+1} - 2 theta_i + theta_{i-1}) / dt²,  theta_0 = theta_1, theta_{n+1} = theta_n
// (the paper's eqs. 24 to 27; i = 1 … n). The angle is exact at the nodes. The velocity's error falls with
// dt; where the guide's curvature jumps, theta'' does, and the difference across the jump mixes both sides:
// an error of up to half the jump, however many nodes. Errors: InputError for fewer than 3 nodes or a stroke
// that leaves the guide.

struct NodeRow {
    double time = 0.0;
    BodyMotion body;
};

/// From the stroke's begin to its end, both included.
[[nodiscard]] std::vector<NodeRow> node_method(const Guide& guide, const RollerStroke& stroke, int nodes);

struct NodeMethodError {
    double velocity = 0.0, velocity_time = 0.0;          ///< largest error of theta', rad/s, and where
    double acceleration = 0.0, acceleration_time = 0.0;  ///< of theta'', rad/s²
    /// Of theta'' at nodes further from every joint of the guide than one time step.
    double acceleration_away = 0.0;
};

/// Against the exact motion, at the inner nodes; a node on a joint is compared with the nearer of both sides.
[[nodiscard]] NodeMethodError node_method_error(const Guide& guide, const RollerStroke& stroke, int nodes);

}  // namespace camopt

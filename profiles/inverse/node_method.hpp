// SPDX-License-Identifier: MIT
// The paper's approximate method: the body's angle at nodes evenly spaced in time, its derivatives by central
// differences.
//
//   theta_i = -atan2(y_i, x_i) of the guide's point at L(t_i),  theta_i' = (theta_{i+1} - theta_{i-1}) / 2
//   dt, theta_i'' = (theta_{i+1} - 2 theta_i + theta_{i-1}) / dt²,  theta_0 = theta_1, theta_{n+1} = theta_n
// (the paper's eqs. 24 to 27; i = 1 … n). The angle is exact at the nodes. The velocity's error falls with
// dt; where the guide's curvature jumps, theta'' does, and the difference across the jump mixes both sides:
// an error of up to half the jump, however many nodes. Errors: InputError for fewer than 3 nodes or a stroke
// that leaves the guide.
#pragma once

#include "profiles/inverse/inverse_feeder.hpp"

#include <vector>

namespace camopt {

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

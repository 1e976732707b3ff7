// SPDX-License-Identifier: MIT
// The machine of the paper on inverse cams by its two scene files: the roller goes out along the guide of
// scenes/given_guide_forward.toml, and comes back along that of given_guide_return.toml, which is run
// backwards in time. Times are those of the machine, 0 where the roller leaves its rest. Where a scene has
// not begun, or is over, the feeder rests. m, rad, s.
#pragma once

#include "profiles/inverse/inverse_mechanism.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt::feeding_paper {

inline constexpr double period = 0.258, turning_time = 0.158;

struct FeederState {
    RollerState roller;
    BodyMotion body;
    FollowerState feeder;
};

class FeederStroke {
 public:
    /// Solves the scene: a given guide, so nothing is optimized. back: its time runs from `period` backwards.
    FeederStroke(const std::string& scene, bool back);

    /// side: at a joint of the guide, in the sense of growing distance of the roller.
    [[nodiscard]] FeederState at(double time, Side side = Side::right) const;
    [[nodiscard]] double begin() const { return back_ ? turning_time : 0.0; }
    [[nodiscard]] double end() const { return back_ ? period : turning_time; }
    /// Where the roller passes from one line or arc of the guide to the next, ascending.
    [[nodiscard]] const std::vector<double>& joints() const { return joints_; }
    [[nodiscard]] const Solution& solution() const { return solution_; }

 private:
    Solution solution_;
    std::vector<double> numbers_;
    bool back_ = false;
    double speed_ = 0.0;   ///< rad/s of the cam
    double before_ = 0.0;  ///< rad: from the roller's rest to the scene's begin
    std::vector<double> joints_;
};

/// A scene of the example folder. Throws as the reader of scenes.
[[nodiscard]] Scene example_scene(const std::string& name);

/// Each solved once.
[[nodiscard]] const FeederStroke& forward_stroke();
[[nodiscard]] const FeederStroke& return_stroke();
[[nodiscard]] inline const FeederStroke& stroke_at(double time) {
    return time < turning_time ? forward_stroke() : return_stroke();
}

// The paper's approximate method: the body's angle at nodes evenly spaced in time, its derivatives by central
// differences.
//
//   theta_i = angle at t_i,  theta_i' = (theta_{i+1} - theta_{i-1}) / 2 dt,  theta_i'' = (theta_{i+1} - 2
//   theta_i + theta_{i-1}) / dt²                                   (the paper's eqs. 24 to 27; i = 2 … n - 1)
// The angle is exact at the nodes. The velocity's error falls with dt; where the guide's curvature jumps,
// theta'' does, and the difference across the jump mixes both sides: an error of up to half the jump,
// however many nodes.

struct NodeRow {
    double time = 0.0;
    BodyMotion body;
};

/// The inner nodes. Throws InputError for fewer than 3 nodes.
[[nodiscard]] std::vector<NodeRow> node_method(const FeederStroke& stroke, int nodes);

struct NodeMethodError {
    double velocity = 0.0, acceleration = 0.0;  ///< largest error of theta', rad/s, and of theta'', rad/s²
    /// Of theta'' at nodes further from every joint of the guide than one time step.
    double acceleration_away = 0.0;
};

/// Against the exact motion; a node on a joint is compared with the nearer of both sides.
[[nodiscard]] NodeMethodError node_method_error(const FeederStroke& stroke, int nodes);

}  // namespace camopt::feeding_paper

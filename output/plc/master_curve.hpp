// SPDX-License-Identifier: MIT
// A delivered motion as an electronic cam sees it: the slave over the master, the whole turn, dwells too.
//
// Master θ in degrees from 0; slave s in mm, of a swinging output in degrees; derivatives by the degree:
// dʳs/dθʳ in mm/degʳ (deg/degʳ). At a joint each side has its own value.
#pragma once

#include "core/extremum.hpp"
#include "scene/scene.hpp"
#include "splines/motion_chain.hpp"

#include <array>
#include <string>
#include <vector>

namespace camopt {

class MasterCurve {
 public:
    /// turn: Solution::whole_turn.
    MasterCurve(MotionChain turn, const MotionSpec& motion);

    [[nodiscard]] double end() const { return breakpoints_.back(); }  ///< deg; a whole turn is 360 exactly
    /// Ascending, deg, from 0 to the end.
    [[nodiscard]] const std::vector<double>& breakpoints() const { return breakpoints_; }

    /// s, s', s'', s''' at the angle; finite.
    [[nodiscard]] std::array<double, 4> at(double theta, Side side) const;

    /// c_k of s(θ + t) = Σ c_k t^k on the stretch at that side of the angle; empty where the motion is no
    /// polynomial there (a law).
    [[nodiscard]] std::vector<double> polynomial(double theta, Side side) const;

    [[nodiscard]] double lift() const { return lift_; }  ///< mm or deg
    [[nodiscard]] bool swings() const { return swings_; }
    [[nodiscard]] const char* slave_unit() const { return swings_ ? "deg" : "mm"; }
    [[nodiscard]] double degrees_per_x() const { return degrees_per_x_; }
    /// The slave at the end less the slave at 0: 0 where the cam closes.
    [[nodiscard]] double travel() const;
    [[nodiscard]] bool closes() const;

 private:
    /// x, and the breakpoint itself where the angle is one but for rounding.
    [[nodiscard]] double place(double theta) const;

    MotionChain turn_;
    double lift_ = 1.0, degrees_per_x_ = 1.0;
    bool swings_ = false;
    std::vector<double> breakpoints_, places_;  ///< deg, and x of each
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The tappet shedding mechanism of docs/papers/003.md and its motions. All its dimensions are chosen: the
// paper gives none.
#pragma once

#include "core/motion.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/remote/remote_cam.hpp"

#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace camopt::test {

using enum RemoteDimension;

inline Dimension& dimension(CamSpec& spec, RemoteDimension which) {
    return spec.dimensions[static_cast<std::size_t>(which)].value;
}

/// mm, deg.
inline void set(CamSpec& spec, RemoteDimension which, double value) {
    Dimension& own = dimension(spec, which);
    own.low = own.high = value * (is_angle(which) ? units::degree : units::millimetre);
}

/// farther: the cam's axis 10 mm lower.
inline CamSpec tappet(bool farther = false) {
    CamSpec spec = remote_spec(RemoteLinkage::lever_coupler_lever_coupler_slider);
    spec.choices["lever_branch"] = "right";
    set(spec, roller_radius, 30);
    set(spec, roller_arm, 160);
    set(spec, lever_pivot_x, -160);
    set(spec, lever_pivot_y, 85);
    set(spec, center_y, farther ? -10 : 0);
    set(spec, lever_arm, 240);
    set(spec, lever_angle, -10);
    set(spec, coupler, 351.3);
    set(spec, rocker_pivot_x, 260);
    set(spec, rocker_pivot_y, 400);
    set(spec, rocker_input_arm, 220);
    set(spec, rocker_output_arm, 250);
    set(spec, second_coupler, 200);
    set(spec, slider_x, 10);
    set(spec, slider_y, 560);
    set(spec, slider_angle, 90);
    return spec;
}

/// Dwell at 0, rise of 80 mm to 180 deg, dwell, fall; all angles in deg.
class TappetMotion {
 public:
    TappetMotion(const std::string& law, double dwell_deg) : law_(make_law(law)), dwell_(dwell_deg) {}

    [[nodiscard]] FollowerState at(double theta_deg) const {
        theta_deg -= 360.0 * std::floor(theta_deg / 360.0);
        constexpr double lift = 0.08;
        const bool second = theta_deg >= 180.0;
        const double within = second ? theta_deg - 180.0 : theta_deg, width = 180.0 - dwell_;
        FollowerState state;
        if (within > dwell_) {
            const MotionPoint point = law_->at((within - dwell_) / width);
            const double angle = width * units::degree;
            state = {lift * point.derivative[0], lift * point.derivative[1] / angle,
                     lift * point.derivative[2] / (angle * angle)};
        }
        if (second) state = {lift - state.s, -state.velocity, -state.acceleration};
        return state;
    }

 private:
    std::unique_ptr<Law> law_;
    double dwell_;
};

struct Extreme {
    double value = 0.0, theta_deg = 0.0;
};

/// The largest value of a function of the cam angle in deg: samples, then golden section around the best.
template <class Function>
Extreme largest(const Function& function, int samples = 7200) {
    Extreme best{-1e300, 0.0};
    for (int i = 0; i <= samples; ++i) {
        const double theta = 360.0 * i / samples, value = function(theta);
        if (value > best.value) best = {value, theta};
    }
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double low = best.theta_deg - 360.0 / samples, high = best.theta_deg + 360.0 / samples;
    for (int i = 0; i < 60; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (function(a) > function(b) ? high : low) = function(a) > function(b) ? b : a;
    }
    const double theta = 0.5 * (low + high);
    return {function(theta), theta};
}

}  // namespace camopt::test

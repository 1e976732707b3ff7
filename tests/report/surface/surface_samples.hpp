// SPDX-License-Identifier: MIT
// Flank grids for the tests of surfaces: the reference cams, and a groove that closes.
#pragma once

#include "profiles/spatial/reference_cams.hpp"
#include "report/spatial/flank_surfaces.hpp"

#include <cmath>

namespace camopt::test {

/// A harmonic motion over one turn: its groove closes, and nothing in it jumps.
inline FollowerMotion harmonic_motion(double lift) {
    FollowerMotion motion;
    motion.state = [lift](double theta) {
        return FollowerState{0.5 * lift * (1.0 - std::cos(theta)), 0.5 * lift * std::sin(theta),
                             0.5 * lift * std::cos(theta)};
    };
    motion.breakpoints = {0.0, full_turn};
    return motion;
}

inline FlankGrid closed_grid(int angles = 181) {
    FlankSampling sampling;
    sampling.sections = 6;
    sampling.angles = angles;
    return flank_grid(translating_cam(), harmonic_motion(40.0 * millimetre), sampling);
}

inline GroovedBlank closed_blank() {
    return {15.0 * millimetre, 62.0 * millimetre, -25.0 * millimetre, 65.0 * millimetre};
}

/// The paper's 3200 points: 8 sections, 2 flanks, 200 angles.
inline FlankGrid barrel_grid(int sections = 8, int angles = 200) {
    FlankSampling sampling;
    sampling.sections = sections;
    sampling.angles = angles;
    return flank_grid(barrel_cam(), barrel_motion(), sampling);
}

inline FlankGrid rotating_grid() {
    FlankSampling sampling;
    sampling.angles = 361;
    return flank_grid(rotating_cam(), rotating_motion(), sampling);
}

}  // namespace camopt::test

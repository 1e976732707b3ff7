// SPDX-License-Identifier: MIT
// Random scenes. The same draw makes the same scene.
#pragma once

#include "tests/soak/draw.hpp"
#include "tests/soak/scenes/scene_numbers.hpp"
#include "tests/soak/scenes/scene_text.hpp"

namespace camopt::soak {

struct SceneBudget {
    double motion_seconds = 4.0, cam_seconds = 2.0;  ///< solver.max_seconds
};

/// A motion alone: type, breakpoints, conditions, weights, caps.
[[nodiscard]] SceneText drawn_motion_scene(Draw& draw, const SceneBudget& budget);

/// A motion with a disk cam whose limits lie about the figures of the cam that a classical law would need.
[[nodiscard]] SceneText drawn_cam_scene(Draw& draw, const SceneBudget& budget);

/// Parts of both. `swings`: the lift is an angle.
void draw_motion(Draw& draw, SceneText& scene, bool swings);
void draw_program(Draw& draw, SceneText& scene);
void draw_spline(Draw& draw, SceneText& scene, int most_segments);
void draw_objective(Draw& draw, SceneText& scene, bool with_cam);
/// Ascending from 0 to length, neighbouring widths apart by at most 1/evenness.
[[nodiscard]] std::vector<double> drawn_breakpoints(Draw& draw, int segments, double length, double evenness);

}  // namespace camopt::soak

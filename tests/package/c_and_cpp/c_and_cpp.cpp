// SPDX-License-Identifier: MIT
// The same scene by both faces in one program.
#include <camopt.h>
#include <camopt/solve.hpp>
#include <camopt/units.hpp>
#include <iostream>

int main() {
    camopt::Scene scene;
    scene.motion.lift = 10 * camopt::units::millimetre;
    scene.motion.rise = 120 * camopt::units::degree;
    scene.spline.segments = 12;
    scene.objective.velocity = 0.4;
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    const camopt::Solution cpp = camopt::solve(scene);

    camopt_scene* c_scene = nullptr;
    camopt_solution* c = nullptr;
    camopt_summary summary{};
    summary.size = sizeof summary;
    double y[4] = {};
    const bool solved =
        camopt_scene_from_toml(
            "motion = { type = \"DRD\", lift_mm = 10, rise_deg = 120 }\nspline.segments = 12\n"
            "objective = { velocity = 0.4, acceleration = 0.4, jerk = 0.2 }\n",
            nullptr, &c_scene) == CAMOPT_OK &&
        camopt_solve(c_scene, nullptr, &c) == CAMOPT_OK &&
        camopt_solution_summary(c, &summary) == CAMOPT_OK && camopt_motion_at(c, 0.3, y) == CAMOPT_OK;
    const bool same = solved && cpp.motion && summary.objective == cpp.certificate.objective &&
                      y[1] == cpp.motion->at(0.3).derivative[1];
    std::cout << (same ? "the same to the last bit\n" : "they differ\n") << camopt_error_text();
    camopt_solution_free(c);
    camopt_scene_free(c_scene);
    return same ? 0 : 1;
}

// SPDX-License-Identifier: MIT
// Every key of a scene file in every unit, with the value that must arrive in the Scene.
#pragma once

#include "scene/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace camopt::input {

struct KeyCase {
    std::string key;    ///< "motion.lift_mm"
    std::string value;  ///< TOML
    double expected;    ///< in the unit of the Scene
    std::function<double(const Scene&)> got;
    std::string rest = {};  ///< what the key needs beside it
};

/// A dimension in every unit it may be written in; `key` without its unit.
std::vector<KeyCase> dimension_cases(const std::string& key, bool is_angle,
                                     const std::function<double(const Scene&)>& got, const std::string& rest);

std::vector<KeyCase> motion_cases();
std::vector<KeyCase> valve_cases();
std::vector<KeyCase> segment_cases();
std::vector<KeyCase> set_point_cases();
std::vector<KeyCase> measured_cases();
std::vector<KeyCase> spline_cases();
std::vector<KeyCase> objective_cases();
std::vector<KeyCase> cam_cases();
std::vector<KeyCase> remote_cases();
std::vector<KeyCase> spatial_cases();
std::vector<KeyCase> inverse_cases();
std::vector<KeyCase> force_cases();
std::vector<KeyCase> dimension_weight_cases();
std::vector<KeyCase> limit_cases();
std::vector<KeyCase> cam_limit_cases();
std::vector<KeyCase> drawing_cases();
std::vector<KeyCase> dynamics_cases();
std::vector<KeyCase> drive_cases();
std::vector<KeyCase> solver_cases();

}  // namespace camopt::input

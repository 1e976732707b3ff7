// SPDX-License-Identifier: MIT
// Four classical laws from their published formulas: what law segments do, what references divide by.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace camopt::soak {

/// "modified_sine", "cycloidal", "polynomial_345", "polynomial_4567".
[[nodiscard]] const std::vector<std::string>& known_laws();

/// S and its first three derivatives at t in [0, 1], from 0 to 1. `from_left`: at a jump of S''' its left
/// side.
[[nodiscard]] std::array<double, 4> law_at(const std::string& law, double t, bool from_left = false);

/// velocity, acceleration, jerk, torque, rms_acceleration, rms_jerk.
[[nodiscard]] const std::map<std::string, double>& law_figures(const std::string& law);

}  // namespace camopt::soak

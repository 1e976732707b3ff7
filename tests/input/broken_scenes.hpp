// SPDX-License-Identifier: MIT
// Scenes that must be refused, each with its whole message. The file is called s.toml; the laws known are
// cycloidal and modified_sine, the solvers ipopt, nlopt.slsqp and structured.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace camopt::input {

struct BrokenScene {
    std::string name;
    std::string toml;
    std::string message;
    std::vector<std::string> overrides = {};
};

/// How GoogleTest shows a case.
inline void PrintTo(const BrokenScene& broken, std::ostream* out) {
    *out << broken.name;
}

std::vector<BrokenScene> broken_files();
std::vector<BrokenScene> broken_values();
std::vector<BrokenScene> broken_combinations();
std::vector<BrokenScene> broken_programs();
std::vector<BrokenScene> broken_set_points();
std::vector<BrokenScene> broken_cams();
std::vector<BrokenScene> broken_mechanisms();
std::vector<BrokenScene> broken_spatial();
std::vector<BrokenScene> broken_inverse();
std::vector<BrokenScene> broken_forces();
std::vector<BrokenScene> broken_drawings();
std::vector<BrokenScene> broken_overrides();

}  // namespace camopt::input

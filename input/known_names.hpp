// SPDX-License-Identifier: MIT
// What a scene file may refer to: laws, solvers, tables, cams.
#pragma once

#include "scene/cam_mechanism.hpp"

#include <filesystem>

namespace camopt::input {

/// The names a scene may refer to. "auto" is always a solver; a law or solver that is not listed is refused.
struct KnownNames {
    std::vector<std::string> laws, solvers;
    /// Laws with moving ends: not a reference, and in programs only between splines.
    std::vector<std::string> moving_laws = {};
    /// The folder with the tables (measured.table) that a scene may read; none: a scene given as text reads
    /// no files.
    std::optional<std::filesystem::path> folder = {};
    /// Makes the formulas of a cam (CamSpec::make) of a kind without its own; none: such a cam is refused.
    /// profiles/factory knows every kind.
    std::function<std::shared_ptr<const CamMechanism>(const CamSpec& spec)> cam_formulas = {};
    /// Of a law: share of the displacement and its slope at t in [0, 1]. For measured.register.
    std::function<std::function<std::array<double, 2>(double t)>(const std::string& law)> law_shape = {};
    std::vector<std::string> turning_laws = {};  ///< of `laws`: they turn back at the top
};

}  // namespace camopt::input

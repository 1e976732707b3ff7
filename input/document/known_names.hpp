// SPDX-License-Identifier: MIT
// The names that a scene file may refer to.
#pragma once

#include "scene/cam_mechanism.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
};

}  // namespace camopt::input

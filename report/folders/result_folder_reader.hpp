// SPDX-License-Identifier: MIT
// A result folder read back: the very motion, cam and verdict that were delivered, without solving.
//
// scene.toml gives the scene, result.json the motion and the dimensions bit for bit, certificate.json the
// verdict and its proof. All else is made from these, and what result.json says of it must be that: a file
// that was changed by hand, or belongs to another scene, is refused with the first number that is not its
// own.
#pragma once

#include "report/folders/result_folder.hpp"

namespace camopt {

struct ResultFolder {
    Solution solution;
    RunOrigin origin;
};

/// What makes a scene of its text (the name is for messages), with the formulas of its mechanism.
using SceneLoader = std::function<Scene(const std::string& text, const std::string& name)>;

/// Throws InputError for a folder that is no result folder, is not complete, holds no motion (infeasible,
/// failed), is of another version of camopt, or whose files say different things.
[[nodiscard]] ResultFolder read_result_folder(const std::filesystem::path& folder, const SceneLoader& load);

}  // namespace camopt

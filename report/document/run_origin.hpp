// SPDX-License-Identifier: MIT
// Where a result comes from, so that the run can be repeated from its folder, and a file of that folder.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

struct RunOrigin {
    std::string scene_file;  ///< as given; empty for a scene built in C++
    std::string command;     ///< the command line; empty where there was none
    /// The scene as solved, in TOML (input::scene_with_overrides). Empty for a scene built in C++: then the
    /// folder cannot be read back.
    std::string scene_text = {};
};

struct FolderFile {
    std::string name, text;
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Where a result comes from, so that the run can be repeated from its folder.
#pragma once

#include <string>

namespace camopt {

struct RunOrigin {
    std::string scene_file;  ///< as given; empty for a scene built in C++
    std::string command;     ///< the command line; empty where there was none
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// What a request may take of this machine.
#pragma once

#include <cstddef>

namespace camopt::apps {

struct StudioLimits {
    double solve_seconds = 10.0;     ///< wall time of a solve, whatever solver.max_seconds of the scene says
    double download_seconds = 60.0;  ///< of a solve whose file is asked for
    std::size_t pages = 8;           ///< open at the same time; the one not heard of for longest is forgotten
    std::size_t settings = 200;      ///< of a request
    std::size_t laws = 40;           ///< drawn beside the optimum
};

}  // namespace camopt::apps

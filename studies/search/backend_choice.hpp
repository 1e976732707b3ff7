// SPDX-License-Identifier: MIT
// Which backend and which design vector a solve uses.
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace camopt {

/// Searches where the problem is not convex, or its breakpoints are free, and the scene does not say how
/// many.
inline constexpr int default_starts = 8;

/// What a solve runs and why.
struct BackendChoice {
    std::string solver;
    std::string reason;  ///< empty where the scene names the solver itself
    DesignKind design = DesignKind::states;
};
[[nodiscard]] BackendChoice choose_backend(const Scene& scene);

}  // namespace camopt

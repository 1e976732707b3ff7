// SPDX-License-Identifier: MIT
// The scenes with a cam that are measured, and the backends that measure themselves on them.
#pragma once

#include "scene/scene.hpp"

#include <map>
#include <string>
#include <vector>

namespace camopt::benchmarks {

struct CamCase {
    std::string name;  ///< the kind of scene: "pressure angle 40 mm", …
    int segments = 0;
    Scene scene;
};

/// A backend with its options. `hessian`: "exact", "limited-memory", "BFGS", "none".
struct CamBackend {
    std::string solver, hessian;
    std::map<std::string, OptionValue> options;

    [[nodiscard]] std::string name() const;  ///< "ipopt, limited-memory"
};

/// Every scene: cubic but for one, weights 0.4, 0.4, 0.2 over 1.76, 5.53, 69, no tie-break. Each limit
/// bites; a pressure angle of 30° at 30 mm is beyond 12 segments.
[[nodiscard]] std::vector<CamCase> cam_cases();
[[nodiscard]] std::vector<CamBackend> cam_backends();

/// COBYLA uses no derivatives: it gets the scenes of at most 12 segments in all.
[[nodiscard]] bool is_too_large(const CamBackend& backend, const CamCase& one);

}  // namespace camopt::benchmarks

// SPDX-License-Identifier: MIT
// A solution with the scene it belongs to, as Python holds it.
#pragma once

#include "bindings/python/source/read_scene.hpp"

#include <camopt/solution.hpp>
#include <memory>

namespace camopt::python {

struct SolvedScene {
    std::shared_ptr<const Solution> solution;
    RunOrigin origin;
};

}  // namespace camopt::python

// SPDX-License-Identifier: MIT
#include "benchmarks/trains/integrators.hpp"

namespace trains {

std::vector<Integrator> sundials_integrators() {
    return {};
}

}  // namespace trains

// SPDX-License-Identifier: MIT
#include "solvers/structured/run_limits.hpp"

#include <algorithm>

namespace camopt::structured {

InteriorPointLimits interior_point_limits(const BackendOptions& options, const StructuredOptions& own,
                                          const SolveControl& control) {
    constexpr double aim = 0.1;
    InteriorPointLimits limits;
    limits.tolerance = aim * options.tolerance;
    limits.max_iterations = std::min(own.max_iterations, options.max_iterations);
    limits.patience = own.patience;
    limits.shift = own.regularisation;
    limits.factor = own.factor;
    limits.correctors = own.correctors;
    limits.keep_path = options.keep_path;
    limits.deadline = control.deadline.sooner(options.max_seconds);
    return limits;
}

}  // namespace camopt::structured

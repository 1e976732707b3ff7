// SPDX-License-Identifier: MIT
#include "solvers/structured/run_limits.hpp"

#include <algorithm>

namespace camopt::structured {

InteriorPointLimits interior_point_limits(const BackendOptions& options, const StructuredOptions& own) {
    constexpr double aim = 0.1, longest_seconds = 1e8;
    InteriorPointLimits limits;
    limits.tolerance = aim * options.tolerance;
    limits.max_iterations = std::min(own.max_iterations, options.max_iterations);
    limits.patience = own.patience;
    limits.shift = own.regularisation;
    limits.factor = own.factor;
    limits.correctors = own.correctors;
    const auto budget = std::chrono::duration<double>(std::min(options.max_seconds, longest_seconds));
    limits.deadline = std::chrono::steady_clock::now() +
                      std::chrono::duration_cast<std::chrono::steady_clock::duration>(budget);
    return limits;
}

}  // namespace camopt::structured

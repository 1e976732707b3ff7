// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: what the options of a caller mean for the interior point.
#pragma once

#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/structured_solver.hpp"

namespace camopt::structured {

/// The seconds count from now. Aims at a tenth of the tolerance: what is asked for is then met with room.
[[nodiscard]] InteriorPointLimits interior_point_limits(const BackendOptions& options,
                                                        const StructuredOptions& own,
                                                        const SolveControl& control);

}  // namespace camopt::structured

// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: convex problems whose rows are all linear, by one interior point in the
// standard form, with the proof that a problem without a point is infeasible and that one without an optimum
// is unbounded.
#pragma once

#include "solvers/backend_support.hpp"
#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/structured_options.hpp"

namespace camopt::structured {

/// shape().convex and every row linear; the input has been checked. The results of structured_solver.hpp.
[[nodiscard]] BackendResult linear_rows_minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                                 const BackendOptions& options, const SolveControl& control);

// Converts the options of a caller for the interior point.

/// The seconds count from now. Aims at a tenth of the tolerance, as a margin.
[[nodiscard]] InteriorPointLimits interior_point_limits(const BackendOptions& options,
                                                        const StructuredOptions& own,
                                                        const SolveControl& control);

}  // namespace camopt::structured

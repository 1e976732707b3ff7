// SPDX-License-Identifier: MIT
// Options of camopt to options of Ipopt. Private to this folder (an Ipopt type appears).
#pragma once

#include "solvers/solver.hpp"

#include <IpIpoptApplication.hpp>
#include <vector>

namespace camopt {

/// Predictor-corrector steps without a line search: up to a quarter fewer iterations on convex problems with
/// linear rows, but no end where that is infeasible. Asked for by the shape, unless the native options say.
[[nodiscard]] bool wants_predictor_corrector(const NlpShape& shape, const BackendOptions& options);

/// Columns that many rows see and that Ipopt is to get as chained copies (solvers/chained_columns.hpp); none:
/// the problem as it is. Asked for by the size of the problem, unless the native options say.
[[nodiscard]] std::vector<int> columns_to_chain(const NlpShape& shape, const BackendOptions& options);

/// Sets the defaults that the shape of the problem asks for, then the native options of `options`, which were
/// checked before. Throws InputError where this version of Ipopt refuses one of the latter.
void set_ipopt_options(Ipopt::IpoptApplication& application, const NlpShape& shape,
                       const BackendOptions& options, bool predictor_corrector);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Options of camopt to options of Ipopt. Private to this folder (an Ipopt type appears).
#pragma once

#include "solvers/solver.hpp"

#include <IpIpoptApplication.hpp>

namespace camopt {

/// Sets the defaults that the shape of the problem asks for, then the native options of `options`, which were
/// checked before. Throws InputError where this version of Ipopt refuses one of the latter.
void set_ipopt_options(Ipopt::IpoptApplication& application, const NlpShape& shape,
                       const BackendOptions& options);

}  // namespace camopt

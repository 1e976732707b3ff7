// SPDX-License-Identifier: MIT
// The certificate of a problem as that of the same problem with a multiple of its cost: objective, bounds,
// multipliers and proofs.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt {

/// factor: a power of two, so that nothing is rounded. The gap is the larger one of both, so that it says no
/// less than either.
void scale_cost(Certificate& certificate, double factor);

}  // namespace camopt

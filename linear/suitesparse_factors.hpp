// SPDX-License-Identifier: MIT
// Internal to linear/: the factorizations of SuiteSparse behind SymmetricFactor. Both throw UnavailableError
// where the build has none.
#pragma once

#include "linear/sparse_symmetric.hpp"

namespace camopt {

/// CHOLMOD's simplicial LDLᵀ in its own minimum-degree order. It does not report the signs of its pivots.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_cholmod_factor();

/// KLU: LU with partial pivoting of the whole matrix, both triangles.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_klu_factor();

}  // namespace camopt

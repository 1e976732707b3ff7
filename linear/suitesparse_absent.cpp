// SPDX-License-Identifier: MIT
// A build without SuiteSparse.
#include "linear/suitesparse_factors.hpp"

namespace camopt {

std::unique_ptr<SymmetricFactor> make_cholmod_factor() {
    return nullptr;
}

std::unique_ptr<SymmetricFactor> make_klu_factor() {
    return nullptr;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A build without SuiteSparse.
#include "linear/sparse_symmetric.hpp"

namespace camopt {
namespace {

[[noreturn]] void throw_absent(const char* factor) {
    throw UnavailableError(std::string("factorization '") + factor +
                           "' is not built into this camopt; available: auto, chain and simplicial; " +
                           suitesparse_remedy);
}

}  // namespace

bool has_suitesparse_factors() {
    return false;
}

std::unique_ptr<SymmetricFactor> make_cholmod_factor() {
    throw_absent("cholmod");
}

std::unique_ptr<SymmetricFactor> make_klu_factor() {
    throw_absent("klu");
}

}  // namespace camopt

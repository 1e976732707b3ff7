// SPDX-License-Identifier: MIT
// Compiled together with suitesparse_absent.cpp, so that what a build without SuiteSparse says is tested in
// every build.
#include "core/errors.hpp"
#include "linear/sparse_symmetric.hpp"

#include <gtest/gtest.h>

#include <string>

namespace camopt {
namespace absent_factor_test {

std::string refusal(FactorKind kind) {
    Eigen::SparseMatrix<double> lower(1, 1);
    lower.insert(0, 0) = 1.0;
    try {
        return std::string("made ") + std::string(make_symmetric_factor(kind, lower, {1})->name());
    } catch (const UnavailableError& error) {
        return error.what();
    }
}

TEST(AbsentFactor, IsRefusedWithoutSubstitution) {
    const std::string rest =
        " is not built into this camopt; available: auto, chain and simplicial; install libsuitesparse-dev "
        "and "
        "configure camopt again with CAMOPT_WITH_SUITESPARSE=ON";
    EXPECT_EQ(refusal(FactorKind::cholmod), "factorization 'cholmod'" + rest);
    EXPECT_EQ(refusal(FactorKind::klu), "factorization 'klu'" + rest);
    EXPECT_FALSE(has_suitesparse_factors());
}

TEST(AbsentFactor, TakesNothingFromTheOthers) {
    EXPECT_EQ(refusal(FactorKind::simplicial), "made simplicial");
    EXPECT_TRUE(refusal(FactorKind::automatic).starts_with("made "));
}

}  // namespace absent_factor_test
}  // namespace camopt

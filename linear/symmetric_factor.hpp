// SPDX-License-Identifier: MIT
// The interface of every factorization of a sparse symmetric quasi-definite matrix of fixed pattern.
//
//     K + diag(sign_i · shift_i) = L Λ Lᵀ,  shift >= 0.
//
// Matrices are passed as their lower triangle, column by column, every diagonal entry stored (zero or not).
#pragma once

#include "core/errors.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace camopt {

enum class FactorOutcome {
    ok,
    zero_pivot,  ///< breakdown: a pivot vanished
    wrong_sign,  ///< breakdown: a pivot has the wrong sign; retry with a larger shift
    not_finite   ///< the matrix or the factor overflowed
};
[[nodiscard]] const char* name_of(FactorOutcome value);

class SymmetricFactor {
 public:
    using Matrix = Eigen::SparseMatrix<double>;
    virtual ~SymmetricFactor() = default;
    /// Once for a pattern. `signs`: +1 or −1 for every row. Throws ModelError where sizes differ.
    virtual void analyse(const Matrix& lower, std::vector<int> signs) = 0;
    /// `lower` has the analysed pattern. The factor is valid after `ok`; after `wrong_sign` it may be
    /// inaccurate.
    [[nodiscard]] virtual FactorOutcome factorize(const Matrix& lower, const Eigen::VectorXd& shift) = 0;
    /// Solves with the factor, shifts included, in place.
    virtual void solve_in_place(Eigen::VectorXd& right_side) const = 0;
    /// "chain", "simplicial", …
    [[nodiscard]] virtual std::string_view name() const = 0;
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Factorization of a sparse symmetric quasi-definite matrix of fixed pattern, and accurate solves.
//
//     K = [ P  Cᵀ ]      P positive, D negative (semi)definite; the signs of the pivots are known beforehand,
//         [ C  D  ]      so L Λ Lᵀ exists for every symmetric order once K is regularised:
//     K + diag(sign_i · shift_i) = L Λ Lᵀ,  shift >= 0.
//
// Matrices are passed as their lower triangle, column by column, every diagonal entry stored (zero or not).
// The solution of K x = b itself, without the shifts, comes from refined_solve.
// Source: Vanderbei, Symmetric quasidefinite matrices, SIAM J. Optim. 5 (1995).
#pragma once

#include "linear/symmetric_factor.hpp"

namespace camopt {

/// Eigen's simplicial LDLᵀ with minimum-degree order.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_simplicial_factor();

enum class FactorKind {
    automatic,  ///< chain where the matrix is one, else simplicial: the fastest in benchmarks/
    chain,      ///< chain_factor.hpp; simplicial if the matrix is not a chain
    simplicial,
    cholmod,  ///< SuiteSparse's simplicial LDLᵀ
    klu       ///< SuiteSparse's LU for circuit matrices
};
/// Whether this build has cholmod and klu.
[[nodiscard]] bool has_suitesparse_factors();
/// How to get them.
inline constexpr const char* suitesparse_remedy =
    "install libsuitesparse-dev and configure camopt again with CAMOPT_WITH_SUITESPARSE=ON";
/// Of an analysed `lower`, whose values in the rows of sign −1 are final. Throws UnavailableError for a kind
/// that this build does not have; no other kind is substituted.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_symmetric_factor(FactorKind kind,
                                                                     const SymmetricFactor::Matrix& lower,
                                                                     const std::vector<int>& signs);

struct RefinedSolve {
    Eigen::VectorXd solution;
    double residual = 0.0;  ///< ‖b − K x‖ / ‖b‖, 0 for b = 0
    int solves = 0;         ///< with the factor
    bool finite = true;     ///< false: `solution` is zero and useless
};

struct RefinementLimits {
    double target = 1e-14;  ///< relative residual that is good enough
    int solves = 10;        ///< with the factor, at most
};

/// K x = b for the unshifted K = `lower`, by flexible GMRES with the shifted factor as preconditioner. Never
/// worse than iterative refinement for the same work, and converges where that does not.
[[nodiscard]] RefinedSolve refined_solve(const SymmetricFactor& factor, const SymmetricFactor::Matrix& lower,
                                         const Eigen::VectorXd& right_side,
                                         const RefinementLimits& limits = {});

// Internal to linear/: the factorizations of SuiteSparse behind SymmetricFactor. Both throw UnavailableError
// in a build without it.

/// CHOLMOD's simplicial LDLᵀ in its own minimum-degree order. It does not report the signs of its pivots.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_cholmod_factor();

/// KLU: LU with partial pivoting of the whole matrix, both triangles.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_klu_factor();

// Common to factorizations by a library: the shifted lower triangle, of a fixed pattern. Of this module only.
class ShiftedFactor : public SymmetricFactor {
 public:
    void analyse(const Matrix& lower, std::vector<int> signs) final {
        if (lower.rows() != lower.cols() || static_cast<Eigen::Index>(signs.size()) != lower.rows())
            throw ModelError("SymmetricFactor: a square matrix and one sign a row are needed");
        signs_ = std::move(signs);
        shifted_ = lower;
        shifted_.makeCompressed();
        find_diagonal();
        if (shifted_.rows() > 0) analyse_pattern(shifted_);
    }

    FactorOutcome factorize(const Matrix& lower, const Eigen::VectorXd& shift) final {
        if (lower.nonZeros() != shifted_.nonZeros() || shift.size() != shifted_.rows())
            throw ModelError("SymmetricFactor: not the analysed pattern");
        if (shifted_.rows() == 0) return FactorOutcome::ok;
        std::copy_n(lower.valuePtr(), lower.nonZeros(), shifted_.valuePtr());
        for (std::size_t i = 0; i < signs_.size(); ++i)
            shifted_.valuePtr()[diagonal_[i]] += signs_[i] * shift[static_cast<Eigen::Index>(i)];
        return factorize_values(shifted_);
    }

 protected:
    virtual void analyse_pattern(const Matrix& lower) = 0;
    virtual FactorOutcome factorize_values(const Matrix& lower) = 0;
    [[nodiscard]] const std::vector<int>& signs() const { return signs_; }

 private:
    void find_diagonal() {
        diagonal_.assign(signs_.size(), -1);
        for (Eigen::Index j = 0; j < shifted_.cols(); ++j)
            for (Eigen::Index p = shifted_.outerIndexPtr()[j]; p < shifted_.outerIndexPtr()[j + 1]; ++p)
                if (shifted_.innerIndexPtr()[p] == j) diagonal_[static_cast<std::size_t>(j)] = p;
        if (std::find(diagonal_.begin(), diagonal_.end(), Eigen::Index{-1}) != diagonal_.end())
            throw ModelError("SymmetricFactor: every diagonal entry must be stored");
    }

    Matrix shifted_;
    std::vector<int> signs_;
    std::vector<Eigen::Index> diagonal_;  ///< where each diagonal entry is stored
};

}  // namespace camopt

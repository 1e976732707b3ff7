// SPDX-License-Identifier: MIT
// Internal to linear/: the factorizations of SuiteSparse behind SymmetricFactor. Both throw UnavailableError
// in a build without it.
#pragma once

#include "core/errors.hpp"
#include "linear/sparse_symmetric.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace camopt {

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

// SPDX-License-Identifier: MIT
#include "linear/suitesparse_factors.hpp"

#include "core/errors.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/KLUSupport>

#include <utility>
#include <vector>

namespace camopt {
namespace {

using Matrix = SymmetricFactor::Matrix;
using Eigen::Index;
using Eigen::VectorXd;

/// What both share: the shifted lower triangle, of a fixed pattern.
class ShiftedFactor : public SymmetricFactor {
 public:
    void analyse(const Matrix& lower, std::vector<int> signs) final {
        if (lower.rows() != lower.cols() || static_cast<Index>(signs.size()) != lower.rows())
            throw ModelError("SymmetricFactor: a square matrix and one sign a row are needed");
        signs_ = std::move(signs);
        shifted_ = lower;
        shifted_.makeCompressed();
        if (shifted_.rows() > 0) analyse_pattern(shifted_);
    }

    FactorOutcome factorize(const Matrix& lower, const VectorXd& shift) final {
        if (lower.nonZeros() != shifted_.nonZeros() || shift.size() != shifted_.rows())
            throw ModelError("SymmetricFactor: not the analysed pattern");
        if (shifted_.rows() == 0) return FactorOutcome::ok;
        std::copy_n(lower.valuePtr(), lower.nonZeros(), shifted_.valuePtr());
        // Of a lower triangle with sorted columns the diagonal comes first.
        for (Index j = 0; j < shifted_.cols(); ++j)
            shifted_.valuePtr()[shifted_.outerIndexPtr()[j]] +=
                signs_[static_cast<std::size_t>(j)] * shift[j];
        return factorize_values(shifted_) ? FactorOutcome::ok : FactorOutcome::zero_pivot;
    }

 protected:
    virtual void analyse_pattern(const Matrix& lower) = 0;
    virtual bool factorize_values(const Matrix& lower) = 0;

 private:
    Matrix shifted_;
    std::vector<int> signs_;
};

class CholmodFactor final : public ShiftedFactor {
 public:
    void solve_in_place(VectorXd& right_side) const override {
        if (right_side.size() > 0) right_side = factor_.solve(right_side).eval();
    }
    std::string_view name() const override { return "cholmod"; }

 protected:
    void analyse_pattern(const Matrix& lower) override {
        factor_.cholmod().print = 0;  // a library prints nothing
        factor_.analyzePattern(lower);
    }
    bool factorize_values(const Matrix& lower) override {
        factor_.factorize(lower);
        return factor_.info() == Eigen::Success;
    }

 private:
    Eigen::CholmodSimplicialLDLT<Matrix, Eigen::Lower> factor_;
};

class KluFactor final : public ShiftedFactor {
 public:
    void solve_in_place(VectorXd& right_side) const override {
        if (right_side.size() > 0) right_side = factor_.solve(right_side).eval();
    }
    std::string_view name() const override { return "klu"; }

 protected:
    void analyse_pattern(const Matrix& lower) override {
        full_ = lower.selfadjointView<Eigen::Lower>();
        full_.makeCompressed();
        // Which stored entry of the triangle every entry of the whole matrix repeats.
        Matrix numbered = lower;
        for (Index k = 0; k < numbered.nonZeros(); ++k) numbered.valuePtr()[k] = static_cast<double>(k);
        const Matrix whole = numbered.selfadjointView<Eigen::Lower>();
        source_.assign(whole.valuePtr(), whole.valuePtr() + whole.nonZeros());
        factor_.analyzePattern(full_);
    }
    bool factorize_values(const Matrix& lower) override {
        for (std::size_t k = 0; k < source_.size(); ++k) full_.valuePtr()[k] = lower.valuePtr()[source_[k]];
        factor_.factorize(full_);
        return factor_.info() == Eigen::Success;
    }

 private:
    mutable Eigen::KLU<Matrix> factor_;
    Matrix full_;
    std::vector<Index> source_;
};

}  // namespace

bool has_suitesparse_factors() {
    return true;
}

std::unique_ptr<SymmetricFactor> make_cholmod_factor() {
    return std::make_unique<CholmodFactor>();
}

std::unique_ptr<SymmetricFactor> make_klu_factor() {
    return std::make_unique<KluFactor>();
}

}  // namespace camopt

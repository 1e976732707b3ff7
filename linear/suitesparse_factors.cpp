// SPDX-License-Identifier: MIT
#include "linear/sparse_symmetric.hpp"

#include <Eigen/CholmodSupport>
#include <Eigen/KLUSupport>

namespace camopt {
namespace {

using Matrix = SymmetricFactor::Matrix;
using Eigen::Index;
using Eigen::VectorXd;

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
    FactorOutcome factorize_values(const Matrix& lower) override {
        factor_.factorize(lower);
        return factor_.info() == Eigen::Success ? FactorOutcome::ok : FactorOutcome::zero_pivot;
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
        // For every entry of the whole matrix the stored entry of the triangle that it repeats.
        Matrix numbered = lower;
        for (Index k = 0; k < numbered.nonZeros(); ++k) numbered.valuePtr()[k] = static_cast<double>(k);
        const Matrix whole = numbered.selfadjointView<Eigen::Lower>();
        source_.assign(whole.valuePtr(), whole.valuePtr() + whole.nonZeros());
        factor_.analyzePattern(full_);
    }
    FactorOutcome factorize_values(const Matrix& lower) override {
        for (std::size_t k = 0; k < source_.size(); ++k) full_.valuePtr()[k] = lower.valuePtr()[source_[k]];
        factor_.factorize(full_);
        return factor_.info() == Eigen::Success ? FactorOutcome::ok : FactorOutcome::zero_pivot;
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

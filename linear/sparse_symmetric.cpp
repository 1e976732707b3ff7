// SPDX-License-Identifier: MIT
#include "linear/sparse_symmetric.hpp"

#include "linear/chain_factor.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

namespace camopt {
namespace {

using Matrix = SymmetricFactor::Matrix;
using Eigen::Index;
using Eigen::VectorXd;

class SimplicialFactor final : public ShiftedFactor {
 public:
    void solve_in_place(VectorXd& right_side) const override {
        if (right_side.size() > 0) right_side = factor_.solve(right_side).eval();
    }

    std::string_view name() const override { return "simplicial"; }

 protected:
    void analyse_pattern(const Matrix& lower) override { factor_.analyzePattern(lower); }

    FactorOutcome factorize_values(const Matrix& lower) override {
        factor_.factorize(lower);
        if (factor_.info() != Eigen::Success) return FactorOutcome::zero_pivot;
        const VectorXd pivots = factor_.vectorD();
        if (!pivots.allFinite()) return FactorOutcome::not_finite;
        const auto& order = factor_.permutationPinv().indices();
        for (Index k = 0; k < pivots.size(); ++k) {
            const Index row = order.size() == 0 ? k : order[k];
            if (pivots[k] * signs()[row] <= 0.0) return FactorOutcome::wrong_sign;
        }
        return FactorOutcome::ok;
    }

 private:
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
};

VectorXd residual_of(const Matrix& lower, const VectorXd& x, const VectorXd& right_side) {
    VectorXd result = right_side;
    result.noalias() -= lower.selfadjointView<Eigen::Lower>() * x;
    return result;
}

/// One cycle of flexible GMRES from the residual `start`; returns the correction.
VectorXd gmres_cycle(const SymmetricFactor& factor, const Matrix& lower, const VectorXd& start, double target,
                     int steps, int& solves) {
    const double length = start.norm();
    std::vector<VectorXd> basis{start / length}, directions;
    Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(steps + 1, steps);
    VectorXd reduced_right = VectorXd::Zero(steps + 1), coefficients;
    reduced_right[0] = length;
    for (int k = 0; k < steps; ++k) {
        VectorXd direction = basis.back();
        factor.solve_in_place(direction);
        ++solves;
        if (!direction.allFinite()) break;
        VectorXd image = lower.selfadjointView<Eigen::Lower>() * direction;
        if (!image.allFinite()) break;
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i <= k; ++i) {
                const double part = basis[i].dot(image);
                hessenberg(i, k) += part;
                image -= part * basis[i];
            }
        hessenberg(k + 1, k) = image.norm();
        directions.push_back(std::move(direction));
        const auto block = hessenberg.topLeftCorner(k + 2, k + 1);
        coefficients = block.colPivHouseholderQr().solve(reduced_right.head(k + 2));
        const double rest = (block * coefficients - reduced_right.head(k + 2)).norm();
        if (rest <= target || hessenberg(k + 1, k) <= 1e-300) break;
        basis.emplace_back(image / hessenberg(k + 1, k));
    }
    VectorXd correction = VectorXd::Zero(start.size());
    for (std::size_t i = 0; i < directions.size(); ++i)
        correction += coefficients[static_cast<Index>(i)] * directions[i];
    return correction;
}

}  // namespace

std::unique_ptr<SymmetricFactor> make_simplicial_factor() {
    return std::make_unique<SimplicialFactor>();
}

std::unique_ptr<SymmetricFactor> make_symmetric_factor(FactorKind kind, const Matrix& lower,
                                                       const std::vector<int>& signs) {
    if (kind == FactorKind::automatic || kind == FactorKind::chain) {
        if (auto chain = make_chain_factor(lower, signs)) return chain;
    }
    std::unique_ptr<SymmetricFactor> factor;
    if (kind == FactorKind::cholmod) factor = make_cholmod_factor();
    if (kind == FactorKind::klu) factor = make_klu_factor();
    if (kind == FactorKind::simplicial || !factor) factor = make_simplicial_factor();
    factor->analyse(lower, signs);
    return factor;
}

RefinedSolve refined_solve(const SymmetricFactor& factor, const Matrix& lower, const VectorXd& right_side,
                           const RefinementLimits& limits) {
    constexpr int cycle = 10;  // a restart recomputes the residual, which accumulates round-off in the basis
    RefinedSolve result;
    result.solution = VectorXd::Zero(right_side.size());
    const double length = right_side.norm();
    result.finite = std::isfinite(length);
    if (length == 0.0 || !result.finite) return result;
    result.residual = 1.0;
    VectorXd residual = right_side;
    while (result.solves < limits.solves && result.residual > limits.target) {
        const int steps = std::min(cycle, limits.solves - result.solves);
        const VectorXd trial = result.solution + gmres_cycle(factor, lower, residual, limits.target * length,
                                                             steps, result.solves);
        VectorXd trial_residual = residual_of(lower, trial, right_side);
        const double size = trial_residual.norm() / length;
        if (!(size < result.residual)) break;
        const bool stalled = size > 0.5 * result.residual;
        result.solution = trial;
        result.residual = size;
        residual = std::move(trial_residual);
        if (stalled) break;
    }
    result.finite = result.residual < 1.0;
    return result;
}

}  // namespace camopt

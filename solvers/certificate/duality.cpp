// SPDX-License-Identifier: MIT
#include "solvers/certificate/certificate.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <numeric>

namespace camopt {

namespace {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Sorted by row, then by column, without duplicates.
bool is_in_order(const SparsityPattern& pattern) {
    for (std::size_t k = 1; k < pattern.rows.size(); ++k) {
        const bool same_row = pattern.rows[k] == pattern.rows[k - 1];
        if (pattern.rows[k] < pattern.rows[k - 1]) return false;
        if (same_row && pattern.columns[k] <= pattern.columns[k - 1]) return false;
    }
    return true;
}

SparseRows jacobian_of(const Nlp& problem, const Eigen::VectorXd& x) {
    const NlpShape& shape = problem.shape();
    const SparsityPattern& pattern = shape.jacobian;
    const auto count = static_cast<std::size_t>(pattern.size());
    SparseRows jacobian(shape.constraints(), shape.variables());
    if (is_in_order(pattern)) {  // the usual case: the values are the matrix
        jacobian.resizeNonZeros(static_cast<Eigen::Index>(count));
        problem.jacobian(x, {jacobian.valuePtr(), count});
        std::ranges::copy(pattern.columns, jacobian.innerIndexPtr());
        int* const begin = jacobian.outerIndexPtr();
        std::fill(begin, begin + shape.constraints() + 1, 0);
        for (const int row : pattern.rows) ++begin[row + 1];
        std::partial_sum(begin, begin + shape.constraints() + 1, begin);
        return jacobian;
    }
    std::vector<double> values(count);
    problem.jacobian(x, values);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(count);
    for (std::size_t k = 0; k < count; ++k)
        entries.emplace_back(pattern.rows[k], pattern.columns[k], values[k]);
    jacobian.setFromTriplets(entries.begin(), entries.end());
    return jacobian;
}

/// min ½‖Aᵀλ + c‖², λ_i >= 0 where signs_i > 0, <= 0 where < 0, free where 0.
class MultiplierFit final : public Nlp {
 public:
    MultiplierFit(const SparseRows& rows, const Eigen::VectorXd& cost, const std::vector<int>& signs) {
        const int size = static_cast<int>(signs.size());
        gram_ = rows * SparseRows(rows.transpose());
        linear_ = rows * cost;
        constant_ = 0.5 * cost.squaredNorm();
        shape_.x_lower = Eigen::VectorXd::Constant(size, -infinity);
        shape_.x_upper = Eigen::VectorXd::Constant(size, infinity);
        for (int i = 0; i < size; ++i) {
            if (signs[i] > 0) shape_.x_lower[i] = 0.0;
            if (signs[i] < 0) shape_.x_upper[i] = 0.0;
        }
        for (int i = 0; i < gram_.outerSize(); ++i) {
            for (SparseRows::InnerIterator entry(gram_, i); entry; ++entry) {
                if (entry.col() > i) continue;
                shape_.hessian.rows.push_back(i);
                shape_.hessian.columns.push_back(static_cast<int>(entry.col()));
                values_.push_back(entry.value());
            }
        }
        shape_.convex = true;
        shape_.quadratic_cost = true;
    }
    double cost(const ConstVectorRef& x) const override {
        return 0.5 * x.dot(gram_ * x) + linear_.dot(x) + constant_;
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override { out = gram_ * x + linear_; }
    void constraints(const ConstVectorRef&, VectorRef) const override {}
    void jacobian(const ConstVectorRef&, std::span<double>) const override {}
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        for (std::size_t k = 0; k < out.size(); ++k) out[k] = sigma * values_[k];
    }
    std::string variable_name(int index) const override { return "multiplier " + std::to_string(index); }
    std::string row_name(int) const override { return {}; }

 private:
    SparseRows gram_;
    Eigen::VectorXd linear_;
    double constant_ = 0.0;
    std::vector<double> values_;
};

double size_of(double bound) {
    return std::max(1.0, std::abs(bound));
}

}  // namespace

DualityProof duality_proof(const Nlp& problem, const Eigen::VectorXd& x,
                           const Eigen::VectorXd& row_multipliers, const Box& box,
                           const std::string& statement) {
    const NlpShape& shape = problem.shape();
    const SparseRows jacobian = jacobian_of(problem, x);
    Eigen::VectorXd values(shape.constraints());
    problem.constraints(x, values);
    DualityProof proof;
    proof.statement = statement;
    proof.cost.resize(shape.variables());
    problem.gradient(x, proof.cost);
    // A linear cost is its own tangent: writing its constant as f(x) − cᵀx would only add rounding.
    proof.constant = shape.linear_cost ? problem.cost(Eigen::VectorXd::Zero(shape.variables()))
                                       : problem.cost(x) - proof.cost.dot(x);
    for (int j = 0; j < shape.variables(); ++j) proof.variables.push_back(problem.variable_name(j));

    std::vector<int> kept;
    std::vector<double> multipliers;
    for (int i = 0; i < shape.constraints(); ++i) {
        const double multiplier = row_multipliers[i];
        const double side = multiplier > 0.0 ? shape.g_upper[i] : shape.g_lower[i];
        if (multiplier == 0.0 || !std::isfinite(side)) continue;
        kept.push_back(i);
        multipliers.push_back(multiplier);
        proof.origins.push_back(problem.row_origin(i));
    }
    const auto rows = static_cast<Eigen::Index>(kept.size());
    proof.matrix.resize(rows, shape.variables());
    proof.lower.resize(rows);
    proof.upper.resize(rows);
    proof.multipliers = Eigen::Map<Eigen::VectorXd>(multipliers.data(), rows);
    const Eigen::VectorXd linear_part = jacobian * x;
    proof.matrix.reserve(jacobian.nonZeros());
    for (Eigen::Index k = 0; k < rows; ++k) {
        const int i = kept[k];
        const double offset = values[i] - linear_part[i];
        const double rounding = shape.rows[static_cast<std::size_t>(i)].rounding;
        proof.lower[k] = shape.g_lower[i] - offset - rounding;
        proof.upper[k] = shape.g_upper[i] - offset + rounding;
        proof.matrix.startVec(k);
        for (SparseRows::InnerIterator entry(jacobian, i); entry; ++entry)
            proof.matrix.insertBack(k, entry.col()) = entry.value();
    }
    proof.matrix.finalize();
    proof.box = {box.lower.cwiseMax(shape.x_lower), box.upper.cwiseMin(shape.x_upper)};
    proof.bound = recomputed_bound(proof);
    balance_peaks(proof);
    return proof;
}

Eigen::VectorXd fitted_multipliers(const Nlp& problem, const Eigen::VectorXd& x, double active,
                                   const SolveControl& control) {
    const NlpShape& shape = problem.shape();
    Eigen::VectorXd values(shape.constraints());
    problem.constraints(x, values);
    std::vector<int> rows;
    std::vector<int> signs;
    for (int i = 0; i < shape.constraints(); ++i) {
        const bool at_upper = values[i] >= shape.g_upper[i] - active * size_of(shape.g_upper[i]);
        const bool at_lower = values[i] <= shape.g_lower[i] + active * size_of(shape.g_lower[i]);
        if (!at_upper && !at_lower) continue;
        rows.push_back(i);
        signs.push_back(at_upper && at_lower ? 0 : at_upper ? 1 : -1);
    }
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(shape.constraints());
    if (rows.empty() || control.ending()) return multipliers;
    const SparseRows jacobian = jacobian_of(problem, x);
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
        for (SparseRows::InnerIterator entry(jacobian, rows[k]); entry; ++entry)
            entries.emplace_back(k, entry.col(), entry.value());
    }
    SparseRows active_rows(static_cast<Eigen::Index>(rows.size()), shape.variables());
    active_rows.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd cost(shape.variables());
    problem.gradient(x, cost);
    const MultiplierFit fit(active_rows, cost, signs);
    const BackendResult result = make_structured_solver()->minimize(
        fit, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size())), {}, control);
    if (result.x.size() == 0) return multipliers;
    for (std::size_t k = 0; k < rows.size(); ++k)
        multipliers[rows[k]] = result.x[static_cast<Eigen::Index>(k)];
    return multipliers;
}

double stationarity_of(const Nlp& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& row_multipliers,
                       double active) {
    const NlpShape& shape = problem.shape();
    Eigen::VectorXd residual(shape.variables());
    problem.gradient(x, residual);
    residual += jacobian_of(problem, x).transpose() * row_multipliers;
    for (int j = 0; j < shape.variables(); ++j) {
        // A bound multiplier absorbs the residual at an active bound.
        const bool at_lower = x[j] <= shape.x_lower[j] + active * size_of(shape.x_lower[j]);
        const bool at_upper = x[j] >= shape.x_upper[j] - active * size_of(shape.x_upper[j]);
        if ((at_lower && residual[j] > 0.0) || (at_upper && residual[j] < 0.0)) residual[j] = 0.0;
    }
    double worst = residual.size() > 0 ? residual.cwiseAbs().maxCoeff() : 0.0;
    Eigen::VectorXd values(shape.constraints());
    problem.constraints(x, values);
    for (int i = 0; i < shape.constraints(); ++i) {
        const double side = row_multipliers[i] > 0.0 ? shape.g_upper[i] : shape.g_lower[i];
        if (row_multipliers[i] == 0.0) continue;
        if (!std::isfinite(side)) return infinity;
        worst = std::max(worst, std::abs(row_multipliers[i] * (values[i] - side)));
    }
    return worst;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "solvers/certificate/certificate.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <Eigen/QR>

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

/// A variable that only relaxes its rows (a peak) has the reduced cost c_j − Σ λ_i |a_ij|. Where that is
/// below zero by the accuracy of the multipliers, its upper bound counts, which for a peak of little weight
/// is wide: its multipliers, made smaller by what they are too large, prove more.
void balance_relaxing_variables(DualityProof& proof) {
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    const Eigen::Index variables = proof.cost.size();
    Eigen::VectorXd relaxing = Eigen::VectorXd::Zero(variables);
    std::vector<char> hurts(static_cast<std::size_t>(variables), 0);
    const auto for_entries = [&](const auto& use) {
        for (Eigen::Index i = 0; i < proof.matrix.rows(); ++i)
            for (SparseRows::InnerIterator entry(proof.matrix, i); entry; ++entry)
                use(i, entry.col(), proof.multipliers[i] * entry.value());
    };
    for_entries([&](Eigen::Index, Eigen::Index j, double part) {
        relaxing[j] -= part;
        if (part > 0.0) hurts[static_cast<std::size_t>(j)] = 1;
    });
    Eigen::VectorXd factor = Eigen::VectorXd::Ones(variables);
    bool any = false;
    for (Eigen::Index j = 0; j < variables; ++j) {
        const double most = proof.cost[j] * (1.0 - rounding);
        if (hurts[static_cast<std::size_t>(j)] || !(proof.cost[j] > 0.0) || !(relaxing[j] > most)) continue;
        factor[j] = most / relaxing[j];
        any = true;
    }
    if (!any) return;
    DualityProof balanced = proof;
    Eigen::VectorXd of_row = Eigen::VectorXd::Ones(proof.matrix.rows());
    for_entries([&](Eigen::Index i, Eigen::Index j, double) { of_row[i] = std::min(of_row[i], factor[j]); });
    balanced.multipliers = proof.multipliers.cwiseProduct(of_row);
    balanced.bound = recomputed_bound(balanced);
    if (balanced.bound > proof.bound) proof = std::move(balanced);
}

/// c + Gᵀλ, summed in long double.
Eigen::VectorXd reduced_costs(const DualityProof& proof) {
    std::vector<long double> sums(proof.cost.begin(), proof.cost.end());
    for (Eigen::Index i = 0; i < proof.matrix.rows(); ++i)
        for (SparseRows::InnerIterator entry(proof.matrix, i); entry; ++entry)
            sums[static_cast<std::size_t>(entry.col())] +=
                static_cast<long double>(proof.multipliers[i]) * entry.value();
    Eigen::VectorXd reduced(proof.cost.size());
    std::ranges::transform(sums, reduced.begin(), [](long double sum) { return static_cast<double>(sum); });
    return reduced;
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
    balance_relaxing_variables(proof);
    return proof;
}

namespace {

/// min ‖A x − b‖, x_k >= 0 but where `free`, by active sets (Lawson and Hanson, Solving Least Squares
/// Problems, 1974, chapter 23), from x and the independent ones among its columns that are not zero.
class NonnegativeFit {
 public:
    NonnegativeFit(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, std::vector<char> free,
                   Eigen::VectorXd x)
        : a_(a), b_(b), free_(std::move(free)), x_(std::move(x)) {
        const Eigen::MatrixXd weighted = a_ * x_.cwiseAbs().asDiagonal();
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(weighted);
        factor.setThreshold(dependent);
        for (Eigen::Index k = 0; k < factor.rank(); ++k)
            passive_.push_back(factor.colsPermutation().indices()[k]);
        Eigen::VectorXd kept = Eigen::VectorXd::Zero(x_.size());
        kept(passive_) = x_(passive_);
        x_ = std::move(kept);
    }

    Eigen::VectorXd solve() {
        for (Eigen::Index step = 0; step < 3 * x_.size(); ++step) {
            settle();
            const Eigen::VectorXd left = b_ - a_ * x_;
            const Eigen::VectorXd gain = a_.transpose() * left;
            Eigen::Index best = -1;
            double most = dependent * left.norm();
            for (Eigen::Index k = 0; k < x_.size(); ++k) {
                const double own = free_[k] ? std::abs(gain[k]) : gain[k];
                if (own <= most * a_.col(k).norm() || std::ranges::find(passive_, k) != passive_.end())
                    continue;
                most = own / a_.col(k).norm();
                best = k;
            }
            if (best < 0 || left.norm() <= rounding * b_.norm()) break;
            passive_.push_back(best);
        }
        return x_;
    }

 private:
    static constexpr double dependent = 1e-13, rounding = 1e-15;

    /// The least squares of the passive columns, without those that would be below zero.
    void settle() {
        while (!passive_.empty()) {
            const Eigen::MatrixXd columns = a_(Eigen::all, passive_);
            const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(columns);
            Eigen::VectorXd wanted = factor.solve(b_);
            wanted += factor.solve(b_ - columns * wanted);
            double part = 1.0;
            for (std::size_t k = 0; k < passive_.size(); ++k) {
                const double now = x_[passive_[k]], next = wanted[static_cast<Eigen::Index>(k)];
                if (!free_[passive_[k]] && next <= 0.0)
                    part = std::min(part, now > next ? now / (now - next) : 0.0);
            }
            const Eigen::VectorXd now = x_(passive_);
            x_(passive_) = now + part * (wanted - now);
            if (part == 1.0) return;
            std::erase_if(passive_, [&](Eigen::Index k) {
                const bool leaves = !free_[k] && x_[k] <= rounding * std::abs(x_.maxCoeff());
                if (leaves) x_[k] = 0.0;
                return leaves;
            });
        }
    }

    const Eigen::MatrixXd& a_;
    const Eigen::VectorXd& b_;
    std::vector<char> free_;
    Eigen::VectorXd x_;
    std::vector<Eigen::Index> passive_;
};

}  // namespace

void sharpen(DualityProof& proof, double target) {
    // Dense factorizations: of larger problems they would take longer than their solve.
    constexpr std::size_t most_variables = 250;
    constexpr double balanced = 1e-6;  // of its cost: what is left of a variable with a multiplier
    constexpr double idle = 1e-13;     // of the largest part of a reduced cost: rows that are not active
    constexpr double farthest = 1e12;  // of open sides
    const Eigen::VectorXd reduced = reduced_costs(proof);
    std::vector<Eigen::Index> zero;
    for (Eigen::Index j = 0; j < proof.cost.size(); ++j) {
        const bool either_sign = proof.box.lower[j] < 0.0 && proof.box.upper[j] > 0.0;
        if (either_sign || std::abs(reduced[j]) <= balanced * std::abs(proof.cost[j])) zero.push_back(j);
    }
    if (proof.multipliers.size() == 0 || zero.empty() || zero.size() > most_variables) return;
    Eigen::VectorXi place = Eigen::VectorXi::Constant(proof.cost.size(), -1);
    for (std::size_t k = 0; k < zero.size(); ++k) place[zero[k]] = static_cast<int>(k);
    // Each variable in what its remainder may cost, each row with the sign of its multiplier.
    const Eigen::VectorXd costs =
        proof.box.upper(zero).cwiseMax(-proof.box.lower(zero)).cwiseMin(farthest).cwiseMax(1.0 / farthest);
    // The last row says that they prove the target.
    Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(costs.size() + 1, proof.multipliers.size());
    for (Eigen::Index i = 0; i < proof.matrix.rows(); ++i) {
        const double sign = proof.multipliers[i] < 0.0 ? -1.0 : 1.0;
        parts(costs.size(), i) = sign > 0.0 ? proof.upper[i] : -proof.lower[i];
        for (SparseRows::InnerIterator entry(proof.matrix, i); entry; ++entry)
            if (const int k = place[entry.col()]; k >= 0) parts(k, i) = sign * costs[k] * entry.value();
    }
    const Eigen::VectorXd sizes =
        parts.colwise().lpNorm<Eigen::Infinity>().transpose().cwiseProduct(proof.multipliers.cwiseAbs());
    std::vector<Eigen::Index> active;
    std::vector<char> free;
    for (Eigen::Index i = 0; i < sizes.size(); ++i) {
        if (sizes[i] <= idle * sizes.maxCoeff()) continue;
        active.push_back(i);
        free.push_back(proof.upper[i] - proof.lower[i] < infinity);
    }
    const Eigen::MatrixXd columns = parts(Eigen::all, active);
    Eigen::VectorXd wanted(costs.size() + 1);
    wanted << -costs.cwiseProduct(proof.cost(zero)), proof.constant - target;
    const Eigen::VectorXd found =
        NonnegativeFit(columns, wanted, free, proof.multipliers(active).cwiseAbs()).solve();
    DualityProof sharper = proof;
    sharper.multipliers.setZero();
    for (std::size_t k = 0; k < active.size(); ++k) {
        const double size = found[static_cast<Eigen::Index>(k)];
        sharper.multipliers[active[k]] = proof.multipliers[active[k]] < 0.0 ? -size : size;
    }
    sharper.bound = recomputed_bound(sharper);
    balance_relaxing_variables(sharper);
    if (sharper.bound > proof.bound) proof = std::move(sharper);
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

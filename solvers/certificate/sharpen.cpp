// SPDX-License-Identifier: MIT
// What the accuracy of multipliers costs a proof, removed.
#include "solvers/certificate/certificate.hpp"

#include <Eigen/QR>

namespace camopt {

namespace {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

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

/// min ‖A x − b‖, x_k >= 0 but where `free`, by active sets (Lawson and Hanson, Solving Least Squares
/// Problems, 1974, chapter 23), from x and the independent ones among its columns that are not zero.
class NonnegativeFit {
 public:
    NonnegativeFit(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, std::vector<bool> free,
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
        double least = std::numeric_limits<double>::infinity();
        for (int idle = 0; idle < most_idle;) {
            settle();
            const Eigen::VectorXd left = b_ - a_ * x_;
            // A dependent column comes and goes without end.
            idle = left.norm() < progress * least ? 0 : idle + 1;
            least = std::min(least, left.norm());
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
    static constexpr double dependent = 1e-13, rounding = 1e-15, progress = 0.99;
    static constexpr int most_idle = 10;

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
    std::vector<bool> free_;
    Eigen::VectorXd x_;
    std::vector<Eigen::Index> passive_;
};

/// Variables whose reduced cost is to be zero: that may have either sign, or peaks that are active.
std::vector<Eigen::Index> to_balance(const DualityProof& proof) {
    constexpr double balanced = 1e-6;  // of its terms: what is left of a peak with multipliers
    const Eigen::VectorXd reduced = reduced_costs(proof);
    const Eigen::VectorXd terms =
        proof.cost.cwiseAbs() + proof.matrix.cwiseAbs().transpose() * proof.multipliers.cwiseAbs();
    std::vector<Eigen::Index> zero;
    for (Eigen::Index j = 0; j < proof.cost.size(); ++j) {
        const bool either_sign = proof.box.lower[j] < 0.0 && proof.box.upper[j] > 0.0;
        const bool is_active = terms[j] > 0.0 && std::abs(reduced[j]) <= balanced * terms[j];
        if (either_sign || is_active) zero.push_back(j);
    }
    return zero;
}

/// What a multiplier of size 1 of each row adds to the reduced costs of these variables, times `costs`; in
/// the last row to what is proved, negative.
Eigen::MatrixXd parts_of_sums(const DualityProof& proof, const std::vector<Eigen::Index>& variables,
                              const Eigen::VectorXd& costs) {
    Eigen::VectorXi place = Eigen::VectorXi::Constant(proof.cost.size(), -1);
    for (std::size_t k = 0; k < variables.size(); ++k) place[variables[k]] = static_cast<int>(k);
    Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(costs.size() + 1, proof.multipliers.size());
    for (Eigen::Index i = 0; i < proof.matrix.rows(); ++i) {
        const double sign = proof.multipliers[i] < 0.0 ? -1.0 : 1.0;
        parts(costs.size(), i) = sign > 0.0 ? proof.upper[i] : -proof.lower[i];
        for (SparseRows::InnerIterator entry(proof.matrix, i); entry; ++entry)
            if (const int k = place[entry.col()]; k >= 0) parts(k, i) = sign * costs[k] * entry.value();
    }
    return parts;
}

}  // namespace

void balance_peaks(DualityProof& proof) {
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    const Eigen::Index variables = proof.cost.size();
    Eigen::VectorXd relaxing = Eigen::VectorXd::Zero(variables);
    std::vector<bool> hurts(static_cast<std::size_t>(variables), false);
    const auto for_entries = [&](const auto& use) {
        for (Eigen::Index i = 0; i < proof.matrix.rows(); ++i)
            for (SparseRows::InnerIterator entry(proof.matrix, i); entry; ++entry)
                use(i, entry.col(), proof.multipliers[i] * entry.value());
    };
    for_entries([&](Eigen::Index, Eigen::Index j, double part) {
        relaxing[j] -= part;
        if (part > 0.0) hurts[static_cast<std::size_t>(j)] = true;
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

void sharpen(DualityProof& proof, double target) {
    // Dense factorizations: of larger problems they would take longer than their solve.
    constexpr std::size_t most_variables = 250;
    constexpr double idle = 1e-13;     // of the largest part of a reduced cost: rows that are not active
    constexpr double farthest = 1e12;  // of open sides
    const std::vector<Eigen::Index> zero = to_balance(proof);
    if (proof.multipliers.size() == 0 || zero.empty() || zero.size() > most_variables) return;
    // Each variable in what its remainder may cost.
    const Eigen::VectorXd costs =
        proof.box.upper(zero).cwiseMax(-proof.box.lower(zero)).cwiseMin(farthest).cwiseMax(1.0 / farthest);
    const Eigen::MatrixXd parts = parts_of_sums(proof, zero, costs);
    const Eigen::VectorXd sizes =
        parts.colwise().lpNorm<Eigen::Infinity>().transpose().cwiseProduct(proof.multipliers.cwiseAbs());
    std::vector<Eigen::Index> active;
    std::vector<bool> free;
    for (Eigen::Index i = 0; i < sizes.size(); ++i) {
        if (sizes[i] <= idle * sizes.maxCoeff()) continue;
        active.push_back(i);
        free.push_back(proof.upper[i] - proof.lower[i] < infinity);
    }
    const Eigen::MatrixXd columns = parts(Eigen::all, active);
    const double most = std::max(1.0, proof.multipliers.cwiseAbs().maxCoeff()) * columns.norm();
    if (active.empty() || !std::isfinite(most * most)) return;  // numbers beyond what squares of doubles hold
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
    balance_peaks(sharper);
    if (sharper.bound > proof.bound) proof = std::move(sharper);
}

}  // namespace camopt

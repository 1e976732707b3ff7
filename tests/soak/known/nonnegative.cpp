// SPDX-License-Identifier: MIT
#include "tests/soak/known/nonnegative.hpp"

#include <Eigen/QR>

#include <vector>

namespace camopt::soak {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Least squares over some columns, refined once: the residual of a consistent system is then rounding alone.
VectorXd solved_over(const MatrixXd& a, const VectorXd& b, const std::vector<Index>& columns) {
    const MatrixXd own = a(Eigen::all, columns);
    const Eigen::HouseholderQR<MatrixXd> factor(own);
    VectorXd x = factor.solve(b);
    x += factor.solve(b - own * x);
    return x;
}

}  // namespace

std::optional<VectorXd> balanced(const MatrixXd& a, const VectorXd& b) {
    constexpr double tolerance = 1e-11;
    VectorXd x = VectorXd::Zero(a.cols());
    std::vector<Index> used;
    std::vector<bool> in(static_cast<std::size_t>(a.cols()), false);
    for (Index round = 0; round < 6 * a.rows() + 20; ++round) {
        const VectorXd rest = b - a * x;
        if (rest.norm() <= tolerance * b.norm()) return x;
        const VectorXd gain = a.transpose() * rest;
        Index best = -1;
        for (Index k = 0; k < gain.size(); ++k)
            if (!in[static_cast<std::size_t>(k)] && gain[k] > 0.0 && (best < 0 || gain[k] > gain[best]))
                best = k;
        if (best < 0 || static_cast<Index>(used.size()) >= a.rows()) return std::nullopt;
        used.push_back(best);
        in[static_cast<std::size_t>(best)] = true;
        while (!used.empty()) {
            const VectorXd next = solved_over(a, b, used);
            double step = 1.0;
            for (std::size_t k = 0; k < used.size(); ++k) {
                const double now = x[used[k]], then = next[static_cast<Index>(k)];
                if (then <= 0.0) step = std::min(step, now > 0.0 ? now / (now - then) : 0.0);
            }
            for (std::size_t k = 0; k < used.size(); ++k)
                x[used[k]] += step * (next[static_cast<Index>(k)] - x[used[k]]);
            if (step >= 1.0) break;
            std::vector<Index> kept;
            for (std::size_t k = 0; k < used.size(); ++k) {
                const bool leaves = next[static_cast<Index>(k)] <= 0.0 && x[used[k]] <= 1e-14;
                if (leaves) x[used[k]] = 0.0;
                if (leaves) in[static_cast<std::size_t>(used[k])] = false;
                if (!leaves) kept.push_back(used[k]);
            }
            if (kept.size() == used.size()) return std::nullopt;  // rounding: no progress
            used = std::move(kept);
        }
    }
    return std::nullopt;
}

}  // namespace camopt::soak

// SPDX-License-Identifier: MIT
// A cam problem from outside, for any solver of nonlinear programs: the shape of a valve cam of the
// collection COPS 3.0 ("camshape", also in MINLPLib, where its optima are proved).
//
//   min −(π/n) Σ r_i   over the radii r_1 … r_n at the angles i Δθ, Δθ = 2π/(5(n + 1)),
//   1 ≤ r_i ≤ 2,   |r_{i+1} − r_i| ≤ 1.5 Δθ for i = 0 … n,
//   r_{i−1} r_i + r_i r_{i+1} − 2 r_{i−1} r_{i+1} cos Δθ ≥ 0 for i = 0 … n + 1: the cam is convex,
//
// with r_{−1} = r_0 = 1, r_{n+1} = 2, r_{n+2} = r_n. The set is not convex. The rows of convexity are divided
// by Δθ², of whose size they are, so that a tolerance means as much at every n.
#pragma once

#include "core/nlp.hpp"

#include <vector>

namespace camopt::benchmarks {

class Camshape final : public Nlp {
 public:
    explicit Camshape(int radii);  ///< n ≥ 2

    /// From 1 to 2 in a straight line.
    [[nodiscard]] Eigen::VectorXd straight_line() const;

    [[nodiscard]] double cost(const ConstVectorRef& x) const override;
    void gradient(const ConstVectorRef& x, VectorRef out) const override;
    void constraints(const ConstVectorRef& x, VectorRef out) const override;
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override;
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override;
    [[nodiscard]] std::string variable_name(int index) const override;
    [[nodiscard]] std::string row_name(int index) const override;

 private:
    /// factor · r_first · r_second in a row; where its derivatives stand in the patterns, −1: a radius is
    /// given.
    struct Product {
        int row = 0;
        double factor = 0.0;
        int first = 0, second = 0;  ///< radii, from −1
        int by_first = -1, by_second = -1, by_both = -1;
    };

    [[nodiscard]] double radius(const ConstVectorRef& x, int index) const;
    [[nodiscard]] int variable_of(int radius) const;
    [[nodiscard]] int jacobian_entry(int row, int variable);
    [[nodiscard]] int hessian_entry(int one, int other);
    void add_convexity();
    void add_slopes();

    int radii_;
    double step_;  ///< Δθ
    std::vector<Product> products_;
};

struct CamshapeOptimum {
    int radii = 0;
    double cost = 0.0;
};
/// Proved; MINLPLib, instances camshape100 … camshape800.
[[nodiscard]] const std::vector<CamshapeOptimum>& camshape_optima();

/// The largest violation of a bound or row as this class scales them; 0: none.
[[nodiscard]] double violation_of(const Nlp& problem, const Eigen::VectorXd& x);

}  // namespace camopt::benchmarks

// SPDX-License-Identifier: MIT
// Polynomials in one variable, p(t) = Σ_m c_m t^m: coefficients ascending, as Eigen vectors of size >= 1.
#pragma once

#include "core/numbers/extremum.hpp"

#include <Eigen/Core>

namespace camopt {

[[nodiscard]] double evaluate_polynomial(const Eigen::Ref<const Eigen::VectorXd>& coefficients, double t);

/// The derivative of an order: that many coefficients less, at least 1; the zero polynomial beyond the
/// degree.
[[nodiscard]] Eigen::VectorXd differentiated(const Eigen::Ref<const Eigen::VectorXd>& coefficients,
                                             int order = 1);
/// The same into `out`, which has the right size.
void differentiate(const Eigen::Ref<const Eigen::VectorXd>& coefficients, int order,
                   Eigen::Ref<Eigen::VectorXd> out);

[[nodiscard]] Eigen::VectorXd product(const Eigen::Ref<const Eigen::VectorXd>& left,
                                      const Eigen::Ref<const Eigen::VectorXd>& right);

/// Every sign change t of p in (lower, upper), ascending, to round-off. Found between the sign changes of p'
/// (recursively), so none is missed; a root where p only touches zero is not a sign change.
[[nodiscard]] std::vector<double> sign_changes(const Eigen::Ref<const Eigen::VectorXd>& coefficients,
                                               double lower, double upper);

/// The largest value on [0, 1] and its first location, to round-off; nullopt where the polynomial does not
/// exceed `floor`, which the Bernstein coefficients usually prove without a root. At most 28 coefficients.
[[nodiscard]] std::optional<Extremum> maximum_above(const Eigen::Ref<const Eigen::VectorXd>& coefficients,
                                                    double floor);

// Five-point Gauss-Legendre quadrature: ∫ f over an interval is the sum of weight · half · f(middle + half ·
// node), exact for polynomials of degree 9.

struct QuadraturePoint {
    double place = 0.0, weight = 0.0;  ///< on [−1, 1]; the weights add up to 2
};

// Nodes 0 and ± sqrt(5 ∓ 2 sqrt(10/7)) / 3; weights 128/225 and (322 ± 13 sqrt(70)) / 900.
inline constexpr std::array<QuadraturePoint, 5> gauss_legendre = {
    {{-0.90617984593866399, 0.23692688505618909},
     {-0.53846931010568309, 0.47862867049936647},
     {0.0, 0.56888888888888889},
     {0.53846931010568309, 0.47862867049936647},
     {0.90617984593866399, 0.23692688505618909}}};

/// ∫ over [begin, end], cut into equal parts, as Σ weight · f(x): calls visit(x, weight).
template <class Visit>
void visit_quadrature(double begin, double end, int parts, Visit&& visit) {
    const double half = 0.5 * (end - begin) / parts;
    for (int k = 0; k < parts; ++k)
        for (const QuadraturePoint& point : gauss_legendre)
            visit(begin + half * (2 * k + 1 + point.place), half * point.weight);
}

}  // namespace camopt

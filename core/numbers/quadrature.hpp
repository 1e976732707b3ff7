// SPDX-License-Identifier: MIT
// Five-point Gauss-Legendre quadrature: ∫ f over an interval is the sum of weight · half · f(middle + half ·
// node), exact for polynomials of degree 9.
#pragma once

#include <array>

namespace camopt {

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

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "dynamics/matrix_exponential.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>

namespace camopt {

namespace {

// Scaling and squaring with the Padé approximant of degree 13: N. J. Higham, SIAM J. Matrix Anal. Appl. 26
// (2005), 1179-1193. Up to this 1-norm the approximant is the exponential of a matrix that differs by less
// than 2^-53 (his table 2.3).
constexpr double largest_norm = 5.371920351148152;
/// Of the numerator p(A), lowest power first; the denominator is p(-A).
constexpr std::array<double, 14> pade = {64764752532480000.0,
                                         32382376266240000.0,
                                         7771770303897600.0,
                                         1187353796428800.0,
                                         129060195264000.0,
                                         10559470521600.0,
                                         670442572800.0,
                                         33522128640.0,
                                         1323241920.0,
                                         40840800.0,
                                         960960.0,
                                         16380.0,
                                         182.0,
                                         1.0};

}  // namespace

Eigen::MatrixXd exponential_of(Eigen::MatrixXd matrix) {
    using Eigen::MatrixXd;
    const Eigen::Index n = matrix.rows();
    if (n == 0) return matrix;
    const double norm = matrix.cwiseAbs().colwise().sum().maxCoeff();
    if (!std::isfinite(norm)) return MatrixXd::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
    const int squarings =
        norm > largest_norm ? static_cast<int>(std::ceil(std::log2(norm / largest_norm))) : 0;
    matrix *= std::ldexp(1.0, -squarings);
    const MatrixXd one = MatrixXd::Identity(n, n);
    const MatrixXd second = matrix * matrix, fourth = second * second, sixth = fourth * second;
    const MatrixXd high_odd = pade[13] * sixth + pade[11] * fourth + pade[9] * second;
    const MatrixXd low_odd =
        sixth * high_odd + pade[7] * sixth + pade[5] * fourth + pade[3] * second + pade[1] * one;
    const MatrixXd odd = matrix * low_odd;
    const MatrixXd high_even = pade[12] * sixth + pade[10] * fourth + pade[8] * second;
    const MatrixXd even =
        sixth * high_even + pade[6] * sixth + pade[4] * fourth + pade[2] * second + pade[0] * one;
    MatrixXd result = (even - odd).partialPivLu().solve(even + odd);
    for (int i = 0; i < squarings; ++i) result = MatrixXd(result * result);
    return result;
}

}  // namespace camopt

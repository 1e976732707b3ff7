// SPDX-License-Identifier: MIT
#include "dynamics/small_matrices.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
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

Eigen::MatrixXd triangular_root(const Eigen::MatrixXd& matrix) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> factor(matrix);
    return factor.matrixQR().topRows(matrix.cols()).triangularView<Eigen::Upper>();
}

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix) {
    return matrix.partialPivLu().inverse();
}

Eigen::VectorXd solution_of(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
    return matrix.fullPivLu().solve(right);
}

/// The eigenvalues of [0 A; -Aᵀ 0] are ± i times the singular values, and zeros.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
    const Eigen::Index m = matrix.rows(), n = matrix.cols();
    Eigen::MatrixXd skew = Eigen::MatrixXd::Zero(m + n, m + n);
    skew.topRightCorner(m, n) = matrix;
    skew.bottomLeftCorner(n, m) = -matrix.transpose();
    Eigen::VectorXd sizes = Eigen::EigenSolver<Eigen::MatrixXd>(skew, false).eigenvalues().cwiseAbs();
    std::ranges::sort(sizes);
    const Eigen::Index count = std::min(m, n), zeros = m + n - 2 * count;
    return Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index i) { return sizes[zeros + 2 * i]; });
}

Eigenvectors eigenvectors_of(const Eigen::MatrixXd& matrix) {
    const Eigen::EigenSolver<Eigen::MatrixXd> eigen(matrix);
    Eigenvectors found{eigen.eigenvalues(), eigen.eigenvectors(), {}};
    // The inverse of X + iY is in that of [X -Y; Y X].
    const Eigen::Index n = matrix.rows();
    Eigen::MatrixXd real(2 * n, 2 * n);
    real.topLeftCorner(n, n) = real.bottomRightCorner(n, n) = found.right.real();
    real.bottomLeftCorner(n, n) = found.right.imag();
    real.topRightCorner(n, n) = -found.right.imag();
    const Eigen::MatrixXd inverse = inverse_of(real);
    found.left.resize(n, n);
    found.left.real() = inverse.topLeftCorner(n, n);
    found.left.imag() = inverse.bottomLeftCorner(n, n);
    return found;
}

}  // namespace camopt

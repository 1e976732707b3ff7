// SPDX-License-Identifier: MIT
// The rest-to-rest cubic y = 3x² − 2x³ passes (1/2, 1/2).
#include <camopt/spline_curve.hpp>
#include <iostream>

int main() {
    Eigen::MatrixXd piece(4, 1);
    piece << 0.0, 0.0, 3.0, -2.0;
    const camopt::SplineCurve cubic({3, 2, {0.0, 1.0}}, piece);
    std::cout << "cubic midpoint " << cubic.at(0.5).derivative[0] << '\n';
}

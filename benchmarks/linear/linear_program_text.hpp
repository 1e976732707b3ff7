// SPDX-License-Identifier: MIT
// A linear grid problem as plain numbers that NumPy and Octave read in one call.
//
//     min cᵀx + c0   subject to   x_L <= x <= x_U,   g_L <= A x <= g_U
//
// Text: variables, rows, entries, c0; then c, x_L, x_U of each variable; then g_L, g_U, size of each row
// (what a violation is relative to); then row and column from 0 and value of each entry of A. Infinities are
// "inf".
#pragma once

#include "core/nlp.hpp"

#include <Eigen/SparseCore>

#include <string>

namespace camopt::benchmarks {

struct LinearProgram {
    double constant = 0.0;
    Eigen::VectorXd cost, x_lower, x_upper, row_lower, row_upper, row_size;
    Eigen::SparseMatrix<double> rows;  ///< constraints x variables
};

/// Throws ModelError where the cost or a row is not linear.
[[nodiscard]] LinearProgram linear_program(const Nlp& problem);

[[nodiscard]] std::string linear_program_text(const LinearProgram& program);

}  // namespace camopt::benchmarks

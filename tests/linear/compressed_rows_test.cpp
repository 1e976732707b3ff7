// SPDX-License-Identifier: MIT
#include "linear/compressed_rows.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace camopt {
namespace compressed_rows_test {

TEST(CompressedRows, ProductsAreThoseOfTheMatrix) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const int rows = 40, columns = 30;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < rows; ++i)  // rows of 0 … 19 entries
        for (int k = 0; k < i % 20; ++k) entries.emplace_back(i, (7 * k + i) % columns, normal(random));
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const CompressedRows compressed(matrix);
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(columns, -1.0, 3.0);
    Eigen::VectorXd product(rows);
    compressed.multiply(x, product);
    EXPECT_LE((product - matrix * x).lpNorm<Eigen::Infinity>(), 1e-13);
    Eigen::VectorXd sum = Eigen::VectorXd::Ones(rows);
    compressed.add_product(-2.0, x.data(), sum.data(), sum.data());
    EXPECT_LE((sum - (Eigen::VectorXd::Ones(rows) - 2.0 * (matrix * x))).lpNorm<Eigen::Infinity>(), 1e-13);
}

}  // namespace compressed_rows_test
}  // namespace camopt

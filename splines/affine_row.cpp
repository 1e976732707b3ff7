// SPDX-License-Identifier: MIT
#include "splines/affine_row.hpp"

namespace camopt {

namespace {
// A sum this small relative to its terms is the round-off of zero.
constexpr double cancelled = 1e-13;
}  // namespace

double AffineRow::value(const Eigen::VectorXd& x) const {
    double sum = offset;
    for (std::size_t k = 0; k < columns.size(); ++k) sum += weights[k] * x[columns[k]];
    return sum;
}

AffineRow combined(const AffineRow& row, double factor, const AffineRow& other) {
    AffineRow sum{row.offset + factor * other.offset, {}, {}};
    sum.columns.reserve(row.columns.size() + other.columns.size());
    sum.weights.reserve(row.columns.size() + other.columns.size());
    std::size_t i = 0, j = 0;
    while (i < row.columns.size() || j < other.columns.size()) {
        const bool left =
            j == other.columns.size() || (i < row.columns.size() && row.columns[i] <= other.columns[j]);
        const bool right =
            i == row.columns.size() || (j < other.columns.size() && other.columns[j] <= row.columns[i]);
        sum.columns.push_back(left ? row.columns[i] : other.columns[j]);
        double weight = left ? row.weights[i++] : 0.0;
        if (right) weight += factor * other.weights[j++];
        sum.weights.push_back(weight);
    }
    return sum;
}

AffineRow functional_of(const LocalMap& map, double t, int order) {
    AffineRow row;
    row.columns = map.columns;
    row.weights.resize(map.columns.size());
    /// visit(m, d^order/dt^order t^m)
    const auto each_power = [&](auto&& visit) {
        double power = 1.0;
        for (Eigen::Index m = order; m < map.offset.size(); ++m) {
            double factor = power;
            for (int r = 0; r < order; ++r) factor *= static_cast<double>(m - r);
            visit(m, factor);
            power *= t;
        }
    };
    each_power([&](Eigen::Index m, double factor) { row.offset += factor * map.offset[m]; });
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        double weight = 0.0, size = 0.0;
        each_power([&](Eigen::Index m, double factor) {
            const double term = factor * map.matrix(m, static_cast<Eigen::Index>(k));
            weight += term;
            size += std::abs(term);
        });
        // At the end of a segment the entries of the other end cancel: the remainder is round-off and must
        // not form a row.
        row.weights[k] = std::abs(weight) <= cancelled * size ? 0.0 : weight;
    }
    return row;
}

Eigen::VectorXd LocalMap::polynomial(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result(offset.size());
    for (Eigen::Index m = 0; m < result.size(); ++m) {
        long double sum = offset[m];
        for (std::size_t k = 0; k < columns.size(); ++k)
            sum += static_cast<long double>(matrix(m, static_cast<Eigen::Index>(k))) * x[columns[k]];
        result[m] = static_cast<double>(sum);
    }
    return result;
}

}  // namespace camopt

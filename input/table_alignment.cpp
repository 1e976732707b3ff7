// SPDX-License-Identifier: MIT
#include "input/table_alignment.hpp"

#include "core/numbers/extremum.hpp"
#include "core/numbers/robust_fit.hpp"

#include <Eigen/QR>

#include <set>

namespace camopt::input {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double least_half = 2.0, most_half = 50.0;      // rows of a neighbourhood, to either side
constexpr double least_spread = 1e-9, last_step = 1e-13;  // m, rad: of round-off; of a settled fit
constexpr int plain_steps = 5, most_steps = 60, search_steps = 180;
constexpr std::size_t search_rows = 120;
constexpr double clearly_better = 0.9;  // of two offsets the smaller one unless the other is this good

double rows_within(double angle, const std::vector<AlignedRow>& rows) {
    return static_cast<double>(rows.size()) * angle / std::max(rows.back().angle - rows.front().angle, angle);
}

/// Medians of neighbours, outliers and weights of the rows.
void judge(TableAlignment& found) {
    std::ranges::stable_sort(found.rows, {}, &AlignedRow::angle);
    const std::size_t count = found.rows.size();
    const auto half =
        static_cast<std::size_t>(std::clamp(rows_within(neighbourhood, found.rows), least_half, most_half));
    std::array<std::vector<double>, 2> parts;  // lobe, base circle
    std::vector<double> from_neighbours;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> values;
        for (std::size_t k = i - std::min(i, half); k < std::min(i + half + 1, count); ++k)
            if (k != i) values.push_back(found.rows[k].aligned);
        AlignedRow& row = found.rows[i];
        row.around = median_of(std::move(values));
        from_neighbours.push_back(row.aligned - row.around);
        parts[row.base ? 1 : 0].push_back(row.around);
    }
    found.noise = spread_of(std::move(from_neighbours), least_spread);
    const std::array<double, 2> spreads = {spread_of(parts[0], least_spread),
                                           spread_of(parts[1], least_spread)};
    for (AlignedRow& row : found.rows) {
        row.outlier = std::abs(row.aligned - row.around) > outlying * found.noise;
        const double u = std::min(1.0, std::abs(row.around) / (biweight * spreads[row.base ? 1 : 0]));
        row.weight = row.outlier ? 0.0 : std::pow(1.0 - u * u, 2);
    }
}

}  // namespace

double searched_offset(std::vector<AlignedRow> rows, const CompareRow& compare) {
    double best = infinity, offset = 0.0;
    for (int i = 0; i <= search_steps; ++i) {
        const int from_zero = i % 2 == 0 ? -i / 2 : (i + 1) / 2;
        const double tried = units::turn * from_zero / search_steps;
        std::vector<double> seen;
        for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / search_rows) {
            compare(rows[k], {0.0, tried, 0.0, 0.0});
            seen.push_back(rows[k].aligned);
        }
        double sum = 0.0;
        for (const double middle = median_of(seen); const double one : seen) sum += std::abs(one - middle);
        if (sum < clearly_better * best) std::tie(best, offset) = std::tie(sum, tried);
    }
    return offset;
}

bool covers_revolution(const std::vector<AlignedRow>& rows) {
    std::set<double> twelfths;
    for (const AlignedRow& row : rows)
        twelfths.insert(std::floor(12.0 * std::remainder(row.angle, units::turn) / units::turn));
    return twelfths.size() >= 12;
}

void align(TableAlignment& found, const CompareRow& compare, bool robust) {
    Matrix4d inverse;
    std::vector<Vector4d> scores;
    double weights = 0.0, squares = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        for (AlignedRow& row : found.rows) compare(row, found.alignment);
        if (step > plain_steps && !robust) return;
        if (step > plain_steps) judge(found);
        Matrix4d normal = Matrix4d::Zero();
        Vector4d right = Vector4d::Zero();
        scores.clear();
        weights = squares = 0.0;
        for (AlignedRow& row : found.rows) {
            if (found.fitted == 2) row.slope.tail<2>().setZero();
            normal += row.weight * row.slope * row.slope.transpose();
            right += scores.emplace_back(row.weight * row.aligned * row.slope);
            weights += row.weight;
            squares += row.weight * row.aligned * row.aligned;
        }
        inverse = normal.completeOrthogonalDecomposition().pseudoInverse();  // a round part keeps its angle
        const Vector4d change = inverse * right;
        if (step > plain_steps && !(change.cwiseAbs().maxCoeff() > last_step)) break;
        found.alignment -= change;
    }
    const auto lags =
        std::min(static_cast<std::size_t>(rows_within(shared_errors, found.rows)), scores.size() / 8);
    Matrix4d shared = Matrix4d::Zero();
    for (std::size_t i = 0; i < scores.size(); ++i)
        for (std::size_t lag = 0; lag <= std::min(lags, i); ++lag) {
            const double taper =
                lag == 0 ? 0.5 : 1.0 - static_cast<double>(lag) / static_cast<double>(lags + 1);
            const Matrix4d product = taper * scores[i] * scores[i - lag].transpose();
            shared += product + product.transpose();
        }
    const double free_rows = std::max(1.0, weights - found.fitted);
    const Vector4d usual = inverse.diagonal() * (squares / free_rows),
                   wider = (inverse * shared * inverse).diagonal() * (weights / free_rows);
    found.error = usual.cwiseMax(wider).cwiseSqrt();
}

}  // namespace camopt::input

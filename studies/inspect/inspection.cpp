// SPDX-License-Identifier: MIT
#include "studies/inspect/inspection.hpp"

#include "core/units.hpp"

#include <Eigen/QR>

#include <set>

namespace camopt {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

constexpr double neighbourhood = 2.5 * units::degree;   // to either side: below the width of a form error
constexpr double shared_errors = 10.0 * units::degree;  // rows this far apart share form errors
constexpr double least_half = 2.0, most_half = 50.0;    // rows of a neighbourhood, to either side
constexpr double biweight = 4.685;                      // 95 % efficiency with normal errors (J. W. Tukey)
constexpr double normal_mad = 1.4826;  // standard deviation over median of magnitudes, normal errors
constexpr double outlying = 5.0;       // robust standard deviations
constexpr double least_spread = 1e-9, settled = 1e-13;  // m, rad: of round-off; of a last step
constexpr int plain_steps = 5, most_steps = 60, search_steps = 180;
constexpr std::size_t search_rows = 120, most_worst = 5;
constexpr double clearly_better = 0.9;  // of two offsets the smaller one unless the other is this good

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double spread_of(std::vector<double> values) {
    for (double& value : values) value = std::abs(value);
    return std::max(normal_mad * median_of(std::move(values)), least_spread);
}

/// The angle offset nearest to 0 at which the rows agree best up to a constant.
double searched_offset(std::vector<InspectedRow> rows, const CompareRow& compare) {
    double best = infinity, offset = 0.0;
    for (int i = 0; i <= search_steps; ++i) {
        const double tried = (i % 2 == 0 ? -1.0 : 1.0) * ((i + 1) / 2) * units::turn / search_steps;
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

/// In each twelfth of the revolution a row; the first one counts twice where one is at its very end.
bool covers_revolution(const std::vector<InspectedRow>& rows) {
    std::set<double> twelfths;
    for (const InspectedRow& row : rows)
        twelfths.insert(std::floor(12.0 * std::remainder(row.angle, units::turn) / units::turn));
    return twelfths.size() >= 12;
}

double rows_within(double angle, const std::vector<InspectedRow>& rows) {
    return static_cast<double>(rows.size()) * angle / std::max(rows.back().angle - rows.front().angle, angle);
}

/// Medians of neighbours, outliers and weights of the rows.
void judge(Inspection& found) {
    std::ranges::stable_sort(found.rows, {}, &InspectedRow::angle);
    const std::size_t count = found.rows.size();
    const auto half =
        static_cast<std::size_t>(std::clamp(rows_within(neighbourhood, found.rows), least_half, most_half));
    std::array<std::vector<double>, 2> parts;  // lobe, base circle
    std::vector<double> from_neighbours;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> values;
        for (std::size_t k = i - std::min(i, half); k < std::min(i + half + 1, count); ++k)
            if (k != i) values.push_back(found.rows[k].aligned);
        InspectedRow& row = found.rows[i];
        row.around = median_of(std::move(values));
        from_neighbours.push_back(row.aligned - row.around);
        parts[row.base ? 1 : 0].push_back(row.around);
    }
    found.noise = spread_of(std::move(from_neighbours));
    const std::array<double, 2> spreads = {spread_of(parts[0]), spread_of(parts[1])};
    for (InspectedRow& row : found.rows) {
        row.outlier = std::abs(row.aligned - row.around) > outlying * found.noise;
        const double u = std::min(1.0, std::abs(row.around) / (biweight * spreads[row.base ? 1 : 0]));
        row.weight = row.outlier ? 0.0 : std::pow(1.0 - u * u, 2);
    }
}

void fit(Inspection& found, const CompareRow& compare) {
    Matrix4d inverse;
    std::vector<Vector4d> scores;
    double weights = 0.0, squares = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        for (InspectedRow& row : found.rows) compare(row, found.alignment);
        if (step > plain_steps) judge(found);
        Matrix4d normal = Matrix4d::Zero();
        Vector4d right = Vector4d::Zero();
        scores.clear();
        weights = squares = 0.0;
        for (InspectedRow& row : found.rows) {
            if (found.fitted == 2) row.slope.tail<2>().setZero();
            normal += row.weight * row.slope * row.slope.transpose();
            right += scores.emplace_back(row.weight * row.aligned * row.slope);
            weights += row.weight;
            squares += row.weight * row.aligned * row.aligned;
        }
        inverse = normal.completeOrthogonalDecomposition().pseudoInverse();  // a round part keeps its angle
        const Vector4d change = inverse * right;
        if (step > plain_steps && !(change.cwiseAbs().maxCoeff() > settled)) break;
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

DeviationFigures figures_of(const std::vector<InspectedRow>& rows, double InspectedRow::*deviation,
                            std::optional<bool> base = {}) {
    DeviationFigures figures{-infinity, 0.0, infinity};
    for (const InspectedRow& row : rows) {
        if (base && row.base != *base) continue;
        const double value = row.*deviation;
        if (value > figures.most) std::tie(figures.most, figures.most_at) = std::tie(value, row.angle);
        if (value < figures.least) std::tie(figures.least, figures.least_at) = std::tie(value, row.angle);
        figures.rms = std::hypot(figures.rms, value);
        ++figures.rows;
    }
    figures.rms /= std::sqrt(std::max(1, figures.rows));
    return figures;
}

/// The worst rows, and the stretches out of tolerance: those closer than a neighbourhood are one.
void name_worst(Inspection& found) {
    std::vector<InspectedRow> order = found.rows;
    std::ranges::stable_sort(order, std::greater(), [](const auto& row) { return std::abs(row.around); });
    for (const InspectedRow& row : order) {
        const auto near = [&](const InspectedRow& other) {
            return std::abs(std::remainder(row.angle - other.angle, units::turn)) < shared_errors;
        };
        if (found.worst.size() < most_worst && std::ranges::none_of(found.worst, near))
            found.worst.push_back(row);
    }
    for (const InspectedRow& row : found.rows) {
        if (!found.tolerance || std::abs(row.aligned) <= *found.tolerance) continue;
        if (found.out.empty() || row.angle - found.out.back()[1] > neighbourhood)
            found.out.push_back({row.angle, row.angle, row.aligned});
        found.out.back()[1] = row.angle;
        if (std::abs(row.aligned) > std::abs(found.out.back()[2])) found.out.back()[2] = row.aligned;
    }
}

}  // namespace

Inspection inspect_cam(const Solution& nominal, const input::InspectedTable& table, double probe_radius,
                       std::optional<double> tolerance) {
    const CompareRow compare = row_comparison(nominal, table, probe_radius);
    Inspection found;
    found.points = table.points;
    found.is_angle = nominal.scene.motion.lift_is_angle;
    found.tolerance = tolerance;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        found.rows.emplace_back().line = table.lines[i];
        found.rows.back().given = table.rows[i];
    }
    found.alignment[1] = searched_offset(found.rows, compare);
    for (InspectedRow& row : found.rows) {
        compare(row, Vector4d::Zero());
        row.raw = row.aligned;
        compare(row, found.alignment);
    }
    if (covers_revolution(found.rows)) found.fitted = 4;
    fit(found, compare);
    found.raw = figures_of(found.rows, &InspectedRow::raw);
    found.all = figures_of(found.rows, &InspectedRow::aligned);
    found.base = figures_of(found.rows, &InspectedRow::aligned, true);
    found.lobe = figures_of(found.rows, &InspectedRow::aligned, false);
    name_worst(found);
    return found;
}

}  // namespace camopt

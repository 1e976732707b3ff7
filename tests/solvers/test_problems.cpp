// SPDX-License-Identifier: MIT
#include "solvers/test_problems.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::test {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd vector_of(std::initializer_list<double> values) {
    VectorXd result(static_cast<Eigen::Index>(values.size()));
    std::copy(values.begin(), values.end(), result.begin());
    return result;
}

VectorXd all(Eigen::Index size, double value) {
    return VectorXd::Constant(size, value);
}

std::string numbered(const char* word, int number) {
    std::string name = word;
    name.append(std::to_string(number));
    return name;
}

class QuadraticNlp final : public Nlp {
 public:
    explicit QuadraticNlp(QuadraticData data) : data_(std::move(data)) {
        const Eigen::Index n = data_.slope.size(), m = data_.g_lower.size();
        shape_.x_lower = data_.x_lower.size() ? data_.x_lower : all(n, -infinity);
        shape_.x_upper = data_.x_upper.size() ? data_.x_upper : all(n, infinity);
        shape_.g_lower = data_.g_lower;
        shape_.g_upper = data_.g_upper;
        shape_.rows.resize(static_cast<std::size_t>(m));
        shape_.convex = data_.convex;
        shape_.linear_cost = data_.hessian.size() == 0;
        shape_.quadratic_cost = true;
        for (int i = 0; i < m; ++i)
            for (int j = 0; j < n; ++j)
                if (data_.rows(i, j) != 0.0) add(shape_.jacobian, i, j);
        for (int i = 0; i < data_.hessian.rows(); ++i)
            for (int j = 0; j <= i; ++j)
                if (data_.hessian(i, j) != 0.0) add(shape_.hessian, i, j);
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        const double quadratic = shape_.linear_cost ? 0.0 : 0.5 * x.dot(data_.hessian * x);
        return quadratic + data_.slope.dot(x) + data_.constant;
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        out = data_.slope;
        if (!shape_.linear_cost) out += data_.hessian * x;
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        if (out.size()) out = data_.rows * x;
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        for (std::size_t k = 0; k < out.size(); ++k)
            out[k] = data_.rows(shape_.jacobian.rows[k], shape_.jacobian.columns[k]);
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        for (std::size_t k = 0; k < out.size(); ++k)
            out[k] = sigma * data_.hessian(shape_.hessian.rows[k], shape_.hessian.columns[k]);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return numbered("x", index); }
    [[nodiscard]] std::string row_name(int index) const override { return numbered("row", index); }

 private:
    static void add(SparsityPattern& pattern, int row, int column) {
        pattern.rows.push_back(row);
        pattern.columns.push_back(column);
    }
    QuadraticData data_;
};

KnownProblem known(std::string name, QuadraticData data, VectorXd start, double cost, VectorXd x,
                   std::string source) {
    return {std::move(name),  quadratic_problem(std::move(data)), std::move(start), cost, std::move(x),
            std::move(source)};
}

/// Rows −peak <= difference(y) <= peak, as two rows each; variables y_0 … y_N, then the peaks.
class PeakRows {
 public:
    explicit PeakRows(int variables) : variables_(variables) {}
    void add(int first, std::initializer_list<double> stencil, int peak) {
        for (const double sign : {1.0, -1.0}) {
            VectorXd row = VectorXd::Zero(variables_);
            int column = first;
            for (const double weight : stencil) row[column++] = sign * weight;
            row[peak] = -1.0;
            append(row, -infinity, 0.0);
        }
    }
    void fix(int variable, double value) { append(VectorXd::Unit(variables_, variable), value, value); }
    void move_into(QuadraticData& data) const {
        const auto m = static_cast<Eigen::Index>(rows_.size());
        data.rows.resize(m, variables_);
        for (Eigen::Index i = 0; i < m; ++i)
            data.rows.row(i) = rows_[static_cast<std::size_t>(i)].transpose();
        data.g_lower = Eigen::Map<const VectorXd>(lower_.data(), m);
        data.g_upper = Eigen::Map<const VectorXd>(upper_.data(), m);
    }

 private:
    void append(VectorXd row, double lower, double upper) {
        rows_.push_back(std::move(row));
        lower_.push_back(lower);
        upper_.push_back(upper);
    }
    int variables_;
    std::vector<VectorXd> rows_;
    std::vector<double> lower_, upper_;
};

void fix_dwells(PeakRows& rows, int steps) {
    rows.fix(0, 0.0);
    rows.fix(1, 0.0);
    rows.fix(steps - 1, 1.0);
    rows.fix(steps, 1.0);
}

}  // namespace

std::unique_ptr<Nlp> quadratic_problem(QuadraticData data) {
    return std::make_unique<QuadraticNlp>(std::move(data));
}

KnownProblem corner_lp() {
    QuadraticData data;
    data.slope = vector_of({-1.0, -2.0});
    data.rows = (MatrixXd(2, 2) << 1.0, 1.0, 1.0, 3.0).finished();
    data.g_lower = all(2, -infinity);
    data.g_upper = vector_of({4.0, 6.0});
    data.x_lower = all(2, 0.0);
    data.x_upper = vector_of({3.0, infinity});
    return known("corner_lp", data, all(2, 0.5), -5.0, vector_of({3.0, 1.0}),
                 "x0 <= 3, x0 + x1 <= 4 and x0 + 3 x1 <= 6 meet at (3, 1)");
}

KnownProblem degenerate_lp() {
    QuadraticData data;
    data.slope = vector_of({1.0, 1.0});
    data.rows = (MatrixXd(4, 2) << 1.0, 2.0, 2.0, 1.0, 1.0, 1.0, 3.0, 3.0).finished();
    data.g_lower = vector_of({3.0, 3.0, 2.0, 6.0});
    data.g_upper = all(4, infinity);
    return known("degenerate_lp", data, vector_of({5.0, -2.0}), 2.0, {},
                 "four rows, one of them another thrice, meet at (1, 1); x0 + x1 >= 2 is a row itself");
}

KnownProblem equality_lp() {
    QuadraticData data;
    data.slope = vector_of({1.0, 2.0, 3.0});
    data.rows = (MatrixXd(2, 3) << 1.0, 1.0, 1.0, 1.0, -1.0, 0.0).finished();
    data.g_lower = data.g_upper = vector_of({1.0, 0.25});
    data.x_lower = vector_of({-infinity, -infinity, 0.0});
    data.x_upper = all(3, infinity);
    return known("equality_lp", data, all(3, 0.0), 1.375, vector_of({0.625, 0.375, 0.0}),
                 "x2 = t >= 0 leaves x1 = (0.75 - t) / 2, x0 = x1 + 0.25, cost 1.375 + 1.5 t");
}

KnownProblem two_sided_lp() {
    QuadraticData data;
    data.slope = vector_of({1.0, -1.0});
    data.rows = (MatrixXd(2, 2) << 1.0, 1.0, 1.0, -1.0).finished();
    data.g_lower = vector_of({-1.0, -2.0});
    data.g_upper = vector_of({5.0, 7.0});
    data.x_upper = vector_of({infinity, 1.5});
    data.x_lower = all(2, -infinity);
    return known("two_sided_lp", data, all(2, 0.0), -2.0, {},
                 "the cost is the second row, whose lower side is -2, reached with -1 <= x0 + x1 <= 1");
}

KnownProblem fixed_variable_lp() {
    QuadraticData data;
    data.slope = vector_of({1.0, 1.0, -4.0});
    data.rows = (MatrixXd(1, 3) << 1.0, 2.0, 1.0).finished();
    data.g_lower = vector_of({3.0});
    data.g_upper = vector_of({infinity});
    data.x_lower = vector_of({0.0, 0.0, 0.5});
    data.x_upper = vector_of({10.0, 10.0, 0.5});
    return known("fixed_variable_lp", data, vector_of({4.0, 4.0, 9.0}), -0.75, vector_of({0.0, 1.25, 0.5}),
                 "x2 = 0.5; then 2 x1 >= 2.5 is cheaper than x0 >= 2.5");
}

KnownProblem all_fixed_lp() {
    QuadraticData data;
    data.slope = vector_of({1.0, 3.0});
    data.rows = (MatrixXd(1, 2) << 1.0, 1.0).finished();
    data.g_lower = vector_of({0.0});
    data.g_upper = vector_of({4.0});
    data.x_lower = data.x_upper = vector_of({1.0, 2.0});
    return known("all_fixed_lp", data, all(2, 0.0), 7.0, vector_of({1.0, 2.0}), "nothing is free");
}

KnownProblem least_acceleration_lp(int steps) {
    const double scale = static_cast<double>(steps) * steps;
    const int peak = steps + 1;
    PeakRows rows(steps + 2);
    for (int k = 1; k < steps; ++k) rows.add(k - 1, {scale, -2.0 * scale, scale}, peak);
    fix_dwells(rows, steps);
    QuadraticData data;
    data.slope = VectorXd::Unit(steps + 2, peak);
    rows.move_into(data);
    const double half = 0.5 * (steps - 1);
    VectorXd start = VectorXd::LinSpaced(steps + 2, 0.0, 1.0);
    start[peak] = 10.0;
    return known(numbered("least_acceleration_lp_", steps), data, start, scale / (half * half), {},
                 "full speed up for half of the steps - 1 differences, full brake for the others: "
                 "y_N = A (N-1)² / (4 N²)");
}

KnownProblem weighted_peaks_lp(int steps) {
    const double rate = steps;
    const int peak = steps + 1;
    PeakRows rows(steps + 4);
    for (int k = 0; k < steps; ++k) rows.add(k, {-rate, rate}, peak);
    const double second = rate * rate, third = second * rate;
    for (int k = 1; k < steps; ++k) rows.add(k - 1, {second, -2.0 * second, second}, peak + 1);
    for (int k = 1; k < steps - 1; ++k) rows.add(k - 1, {-third, 3.0 * third, -3.0 * third, third}, peak + 2);
    fix_dwells(rows, steps);
    QuadraticData data;
    data.slope = VectorXd::Zero(steps + 4);
    data.slope.tail(3) << 0.5, 0.1, 0.01;
    rows.move_into(data);
    VectorXd start = VectorXd::LinSpaced(steps + 4, 0.0, 1.0);
    start.tail(3) << 2.0, 10.0, 100.0;
    const double cost = steps == 12 ? 1.5888 : 390.0 / 259.0;
    return known(numbered("weighted_peaks_lp_", steps), data, start, cost, {},
                 "HiGHS 1.x by scipy.optimize.linprog on the same rows");
}

KnownProblem unconstrained_qp() {
    QuadraticData data;
    data.hessian = (MatrixXd(2, 2) << 4.0, 1.0, 1.0, 3.0).finished();
    data.slope = vector_of({-1.0, -2.0});
    data.constant = 10.0;
    return known("unconstrained_qp", data, vector_of({3.0, -3.0}), 10.0 - 15.0 / 22.0,
                 vector_of({1.0 / 11.0, 7.0 / 11.0}), "4 x0 + x1 = 1, x0 + 3 x1 = 2; no rows at all");
}

KnownProblem projection_qp() {
    QuadraticData data;
    data.hessian = MatrixXd::Identity(3, 3);
    data.slope = vector_of({-1.0, -2.0, -3.0});
    data.constant = 7.0;
    data.rows = MatrixXd::Ones(1, 3);
    data.g_lower = data.g_upper = vector_of({3.0});
    data.x_lower = vector_of({0.5, -infinity, -infinity});
    data.x_upper = all(3, infinity);
    return known("projection_qp", data, all(3, 0.0), 1.6875, vector_of({0.5, 0.75, 1.75}),
                 "projection of (1, 2, 3) on the plane is (0, 1, 2); with x0 = 0.5 the rest moves by 0.25 "
                 "each: ½ (0.25 + 2 · 1.25²)");
}

KnownProblem least_square_acceleration_qp(int segments) {
    // ∫a² of a piecewise linear a is exact with the mass matrix h/6 [2 1; 1 2]; ∫a = 0, ∫(1-t) a = 1
    // likewise.
    const int n = segments + 1;
    const double h = 1.0 / segments;
    QuadraticData data;
    data.hessian = MatrixXd::Zero(n, n);
    data.slope = VectorXd::Zero(n);
    data.rows = MatrixXd::Zero(2, n);
    for (int k = 0; k < segments; ++k) {
        const double t = k * h;
        data.hessian.block<2, 2>(k, k) += (Eigen::Matrix2d() << 2.0, 1.0, 1.0, 2.0).finished() * (h / 3.0);
        data.rows.block<1, 2>(0, k).array() += h / 2.0;
        data.rows(1, k) += h * ((1.0 - t) / 2.0 - h / 6.0);
        data.rows(1, k + 1) += h * ((1.0 - t) / 2.0 - h / 3.0);
    }
    data.g_lower = data.g_upper = vector_of({0.0, 1.0});
    const VectorXd t = VectorXd::LinSpaced(n, 0.0, 1.0);
    return known("least_square_acceleration_qp", data, all(n, 0.0), 12.0, (6.0 - 12.0 * t.array()).matrix(),
                 "s = 3t² - 2t³ has s'' = 6 - 12t, ∫s''² = 12; a linear s'' lies in the space");
}

namespace {

class Hs71 final : public Nlp {
 public:
    Hs71() {
        shape_.x_lower = all(4, 1.0);
        shape_.x_upper = all(4, 5.0);
        shape_.g_lower = vector_of({25.0, 40.0});
        shape_.g_upper = vector_of({infinity, 40.0});
        shape_.rows.assign(2, RowKind{false, false, 1.0});
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 4; ++j) {
                shape_.jacobian.rows.push_back(i);
                shape_.jacobian.columns.push_back(j);
            }
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j <= i; ++j) {
                shape_.hessian.rows.push_back(i);
                shape_.hessian.columns.push_back(j);
            }
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        return x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2];
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        out[0] = x[3] * (2.0 * x[0] + x[1] + x[2]);
        out[1] = x[0] * x[3];
        out[2] = x[0] * x[3] + 1.0;
        out[3] = x[0] * (x[0] + x[1] + x[2]);
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        out[0] = x.prod();
        out[1] = x.squaredNorm();
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        for (int j = 0; j < 4; ++j) {
            out[j] = product_without(x, j, j);
            out[4 + j] = 2.0 * x[j];
        }
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        Eigen::Matrix4d cost = Eigen::Matrix4d::Zero();
        cost(0, 0) = 2.0 * x[3];
        cost(1, 0) = cost(2, 0) = x[3];
        cost(3, 0) = 2.0 * x[0] + x[1] + x[2];
        cost(3, 1) = cost(3, 2) = x[0];
        std::size_t k = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j <= i; ++j) {
                const double rows = i == j ? 2.0 * lambda[1] : lambda[0] * product_without(x, i, j);
                out[k++] = sigma * cost(i, j) + rows;
            }
    }
    [[nodiscard]] std::string variable_name(int index) const override { return numbered("x", index + 1); }
    [[nodiscard]] std::string row_name(int index) const override {
        return index == 0 ? "product" : "squares";
    }

 private:
    static double product_without(const ConstVectorRef& x, int i, int j) {
        double product = 1.0;
        for (int k = 0; k < 4; ++k)
            if (k != i && k != j) product *= x[k];
        return product;
    }
};

class Rosenbrock final : public Nlp {
 public:
    Rosenbrock() {
        shape_.x_lower = vector_of({-1.5, -infinity});
        shape_.x_upper = vector_of({0.5, 2.0});
        shape_.hessian.rows = {0, 1, 1};
        shape_.hessian.columns = {0, 0, 1};
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        return 100.0 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1.0 - x[0], 2);
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        const double rest = x[1] - x[0] * x[0];
        out[0] = -400.0 * x[0] * rest - 2.0 * (1.0 - x[0]);
        out[1] = 200.0 * rest;
    }
    void constraints(const ConstVectorRef&, VectorRef) const override {}
    void jacobian(const ConstVectorRef&, std::span<double>) const override {}
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        out[0] = sigma * (1200.0 * x[0] * x[0] - 400.0 * x[1] + 2.0);
        out[1] = -400.0 * sigma * x[0];
        out[2] = 200.0 * sigma;
    }
    [[nodiscard]] std::string variable_name(int index) const override { return index == 0 ? "x" : "y"; }
    [[nodiscard]] std::string row_name(int) const override { return {}; }
};

}  // namespace

KnownProblem hs71() {
    return {"hs71",
            std::make_unique<Hs71>(),
            vector_of({1.0, 5.0, 5.0, 1.0}),
            17.0140173,
            vector_of({1.0, 4.7429994, 3.8211503, 1.3794082}),
            "W. Hock, K. Schittkowski, Lecture Notes in Economics and Mathematical Systems 187 (1981), "
            "problem 71"};
}

KnownProblem bounded_rosenbrock() {
    return {"bounded_rosenbrock",   std::make_unique<Rosenbrock>(),
            vector_of({-1.2, 1.0}), 0.25,
            vector_of({0.5, 0.25}), "x <= 0.5 is active: y = x² leaves (1 - x)² = 0.25"};
}

KnownProblem infeasible_lp() {
    QuadraticData data;
    data.slope = vector_of({1.0, 1.0});
    data.rows = (MatrixXd(2, 2) << 1.0, 1.0, 1.0, 1.0).finished();
    data.g_lower = vector_of({3.0, -infinity});
    data.g_upper = vector_of({infinity, 1.0});
    data.x_lower = all(2, -10.0);
    data.x_upper = all(2, 10.0);
    return known("infeasible_lp", data, all(2, 0.0), infinity, {}, "x0 + x1 >= 3 and <= 1");
}

KnownProblem unbounded_lp() {
    QuadraticData data;
    data.slope = vector_of({-1.0, 0.0});
    data.rows = (MatrixXd(1, 2) << 1.0, -1.0).finished();
    data.g_lower = vector_of({-infinity});
    data.g_upper = vector_of({1.0});
    return known("unbounded_lp", data, all(2, 0.0), -infinity, {}, "along (1, 1) the cost falls for ever");
}

KnownProblem overdetermined() {
    QuadraticData data;
    data.slope = vector_of({1.0, 1.0});
    data.rows = (MatrixXd(3, 2) << 1.0, 0.0, 0.0, 1.0, 1.0, 1.0).finished();
    data.g_lower = data.g_upper = vector_of({1.0, 2.0, 3.0});
    return known("overdetermined", data, all(2, 0.0), 3.0, vector_of({1.0, 2.0}),
                 "three equalities for two variables, one of them the sum of the others");
}

double violation(const Nlp& problem, const VectorXd& x) {
    const NlpShape& shape = problem.shape();
    double worst = 0.0;
    const auto check = [&worst](const VectorXd& value, const VectorXd& lower, const VectorXd& upper) {
        for (Eigen::Index i = 0; i < value.size(); ++i) {
            if (std::isfinite(lower[i]))
                worst = std::max(worst, (lower[i] - value[i]) / std::max(1.0, std::abs(lower[i])));
            if (std::isfinite(upper[i]))
                worst = std::max(worst, (value[i] - upper[i]) / std::max(1.0, std::abs(upper[i])));
        }
    };
    VectorXd g(shape.constraints());
    problem.constraints(x, g);
    check(x, shape.x_lower, shape.x_upper);
    check(g, shape.g_lower, shape.g_upper);
    return worst;
}

double stationarity(const Nlp& problem, const VectorXd& x, const VectorXd& row_multipliers,
                    const VectorXd& bound_multipliers) {
    const NlpShape& shape = problem.shape();
    VectorXd slope(shape.variables());
    problem.gradient(x, slope);
    std::vector<double> values(shape.jacobian.rows.size());
    problem.jacobian(x, values);
    for (std::size_t k = 0; k < values.size(); ++k)
        slope[shape.jacobian.columns[k]] += values[k] * row_multipliers[shape.jacobian.rows[k]];
    return (slope + bound_multipliers).lpNorm<Eigen::Infinity>();
}

double complementarity(const Nlp& problem, const VectorXd& x, const VectorXd& row_multipliers,
                       const VectorXd& bound_multipliers) {
    const NlpShape& shape = problem.shape();
    double worst = 0.0;
    const auto check = [&worst](const VectorXd& multiplier, const VectorXd& value, const VectorXd& lower,
                                const VectorXd& upper) {
        for (Eigen::Index i = 0; i < value.size(); ++i) {
            if (lower[i] == upper[i]) continue;  // any sign is right
            const double bound = multiplier[i] > 0.0 ? upper[i] : lower[i];
            const double distance = std::isfinite(bound) ? std::abs(value[i] - bound) : 1.0;
            worst = std::max(worst, std::abs(multiplier[i]) * distance);
        }
    };
    VectorXd g(shape.constraints());
    problem.constraints(x, g);
    check(bound_multipliers, x, shape.x_lower, shape.x_upper);
    check(row_multipliers, g, shape.g_lower, shape.g_upper);
    return worst;
}

}  // namespace camopt::test

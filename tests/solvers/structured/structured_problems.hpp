// SPDX-License-Identifier: MIT
// Problems for the tests of the structured solver: quadratic programs from matrices, and the least-peak
// motion curve written by hand in two forms.
#pragma once

#include "core/nlp.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace camopt::testing {

using Sparse = Eigen::SparseMatrix<double>;

/// min ½ xᵀ H x + cᵀ x + k  subject to  lower <= G x + g_0 <= upper, x_lower <= x <= x_upper.
struct QuadraticData {
    Sparse hessian;  ///< full, symmetric; empty for a linear cost
    Eigen::VectorXd cost;
    Sparse rows;
    Eigen::VectorXd lower, upper, x_lower, x_upper;
    double constant = 0.0;
    Eigen::VectorXd row_constant;

    explicit QuadraticData(Eigen::Index variables = 0, Eigen::Index constraints = 0)
        : hessian(variables, variables),
          cost(Eigen::VectorXd::Zero(variables)),
          rows(constraints, variables),
          lower(Eigen::VectorXd::Constant(constraints, -infinity)),
          upper(Eigen::VectorXd::Constant(constraints, infinity)),
          x_lower(Eigen::VectorXd::Constant(variables, -infinity)),
          x_upper(Eigen::VectorXd::Constant(variables, infinity)) {}
};

class QuadraticNlp : public Nlp {
 public:
    explicit QuadraticNlp(QuadraticData data) : data_(std::move(data)) {
        shape_.x_lower = data_.x_lower;
        shape_.x_upper = data_.x_upper;
        shape_.g_lower = data_.lower;
        shape_.g_upper = data_.upper;
        shape_.rows.resize(static_cast<std::size_t>(data_.rows.rows()));
        if (data_.row_constant.size() == 0) data_.row_constant = Eigen::VectorXd::Zero(data_.rows.rows());
        each(data_.rows, [&](int row, int column, double) {
            shape_.jacobian.rows.push_back(row);
            shape_.jacobian.columns.push_back(column);
        });
        each(data_.hessian, [&](int row, int column, double) {
            if (row < column) return;
            shape_.hessian.rows.push_back(row);
            shape_.hessian.columns.push_back(column);
        });
        shape_.convex = true;
        shape_.quadratic_cost = true;
        shape_.linear_cost = data_.hessian.nonZeros() == 0;
    }
    NlpShape& mutable_shape() { return shape_; }
    const QuadraticData& data() const { return data_; }

    double cost(const ConstVectorRef& x) const override {
        return 0.5 * x.dot(data_.hessian * x) + data_.cost.dot(x) + data_.constant;
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        out = data_.hessian * x + data_.cost;
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        out = data_.rows * x + data_.row_constant;
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        std::size_t k = 0;
        each(data_.rows, [&](int, int, double value) { out[k++] = value; });
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        std::size_t k = 0;
        each(data_.hessian, [&](int row, int column, double value) {
            if (row >= column) out[k++] = sigma * value;
        });
    }
    std::string variable_name(int index) const override {
        return std::string("x").append(std::to_string(index));
    }
    std::string row_name(int index) const override { return std::string("g").append(std::to_string(index)); }

 private:
    template <class Visit>
    static void each(const Sparse& matrix, Visit visit) {
        for (Eigen::Index j = 0; j < matrix.outerSize(); ++j)
            for (Sparse::InnerIterator entry(matrix, j); entry; ++entry)
                visit(static_cast<int>(entry.row()), static_cast<int>(entry.col()), entry.value());
    }
    QuadraticData data_;
};

inline BackendResult solve(const Nlp& problem, const BackendOptions& options = {},
                           const SolveControl& control = {}) {
    const Eigen::VectorXd start = Eigen::VectorXd::Zero(problem.shape().variables());
    return make_structured_solver()->minimize(problem, start, options, control);
}

/// Signs, stationarity, feasibility and complementarity of a delivered optimum.
inline void expect_optimal(const Nlp& problem, const BackendResult& result, double tolerance) {
    const NlpShape& shape = problem.shape();
    ASSERT_EQ(result.termination, Termination::converged) << result.native_status;
    ASSERT_TRUE(result.row_multipliers && result.bound_multipliers);
    Eigen::VectorXd gradient(shape.variables()), rows(shape.constraints());
    problem.gradient(result.x, gradient);
    problem.constraints(result.x, rows);
    std::vector<double> values(static_cast<std::size_t>(shape.jacobian.size()));
    problem.jacobian(result.x, values);
    Eigen::VectorXd rest = gradient + *result.bound_multipliers;
    for (std::size_t e = 0; e < values.size(); ++e)
        rest[shape.jacobian.columns[e]] += values[e] * (*result.row_multipliers)[shape.jacobian.rows[e]];
    double products = 0.0;
    const auto check = [&](double value, double low, double high, double multiplier) {
        EXPECT_GE(value, low - tolerance * (1.0 + std::abs(low)));
        EXPECT_LE(value, high + tolerance * (1.0 + std::abs(high)));
        if (multiplier != 0.0 && low != high)
            products += std::abs(multiplier * (value - (multiplier > 0.0 ? high : low)));
    };
    for (Eigen::Index i = 0; i < rows.size(); ++i)
        check(rows[i], shape.g_lower[i], shape.g_upper[i], (*result.row_multipliers)[i]);
    for (Eigen::Index j = 0; j < rest.size(); ++j)
        check(result.x[j], shape.x_lower[j], shape.x_upper[j], (*result.bound_multipliers)[j]);
    EXPECT_LE(rest.size() > 0 ? rest.cwiseAbs().maxCoeff() : 0.0,
              tolerance * (1.0 + (rest.size() > 0 ? gradient.cwiseAbs().maxCoeff() : 0.0)));
    EXPECT_LE(products, tolerance * (1.0 + std::abs(problem.cost(result.x))));
    EXPECT_LE(result.iterations, 100);
}

/// The ray of an infeasible problem, checked against the definition in structured_solver.hpp.
inline void expect_farkas(const QuadraticNlp& problem, const BackendResult& result, double tolerance) {
    ASSERT_EQ(result.termination, Termination::infeasible) << result.native_status;
    ASSERT_TRUE(result.row_multipliers && result.bound_multipliers);
    const QuadraticData& data = problem.data();
    const Eigen::VectorXd& lambda = *result.row_multipliers;
    const Eigen::VectorXd& z = *result.bound_multipliers;
    const Eigen::VectorXd rest = data.rows.transpose() * lambda + z;
    double value = 0.0;
    const Eigen::VectorXd constant =
        data.row_constant.size() > 0 ? data.row_constant : Eigen::VectorXd::Zero(lambda.size());
    for (Eigen::Index i = 0; i < lambda.size(); ++i)
        if (lambda[i] != 0.0)
            value -= lambda[i] * ((lambda[i] > 0.0 ? data.upper[i] : data.lower[i]) - constant[i]);
    for (Eigen::Index j = 0; j < z.size(); ++j)
        if (z[j] != 0.0) value -= z[j] * (z[j] > 0.0 ? data.x_upper[j] : data.x_lower[j]);
    EXPECT_NEAR(value, 1.0, 1e-9);
    EXPECT_LE(rest.cwiseAbs().maxCoeff(), tolerance * std::max(1.0, lambda.cwiseAbs().maxCoeff()));
}

/// Rows collected one by one.
class RowCollector {
 public:
    void add(std::initializer_list<std::pair<int, double>> terms, double low, double high) {
        for (const auto& [column, factor] : terms) entries_.emplace_back(count(), column, factor);
        lower_.push_back(low);
        upper_.push_back(high);
    }
    int count() const { return static_cast<int>(lower_.size()); }
    /// In place of the rows that `data` has.
    void write(QuadraticData& data) const {
        data.rows.resize(0, data.cost.size());
        data.lower.resize(0);
        data.upper.resize(0);
        append(data);
    }
    /// After the rows that `data` has.
    void append(QuadraticData& data) const {
        const Eigen::Index before = data.rows.rows(), after = before + count();
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index j = 0; j < data.rows.outerSize(); ++j)
            for (Sparse::InnerIterator entry(data.rows, j); entry; ++entry)
                entries.emplace_back(static_cast<int>(entry.row()), static_cast<int>(j), entry.value());
        for (const Eigen::Triplet<double>& own : entries_)
            entries.emplace_back(static_cast<int>(before) + own.row(), own.col(), own.value());
        data.rows.resize(after, data.cost.size());
        data.rows.setFromTriplets(entries.begin(), entries.end());
        data.lower.conservativeResize(after);
        data.upper.conservativeResize(after);
        data.lower.tail(count()) = Eigen::Map<const Eigen::VectorXd>(lower_.data(), count());
        data.upper.tail(count()) = Eigen::Map<const Eigen::VectorXd>(upper_.data(), count());
    }

 private:
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<double> lower_, upper_;
};

struct CamCase {
    std::vector<double> steps;  ///< lengths of the segments, sum 1
    int samples = 8;            ///< velocity rows a segment
    double velocity = 0.4 / 1.76, acceleration = 0.4 / 5.53, jerk = 0.2 / 69.0;
    double velocity_cap = infinity, acceleration_cap = infinity, jerk_cap = infinity;
    int copies = 1;  ///< how often the continuity rows are written
};

inline CamCase uniform_cam(int segments) {
    CamCase made;
    made.steps.assign(static_cast<std::size_t>(segments), 1.0 / segments);
    return made;
}

/// −V <= y' <= V at the part t of segment i; states as in cam_problem().
inline void add_velocity_rows(RowCollector& rows, const CamCase& cam, int i, double t) {
    const double h = cam.steps[static_cast<std::size_t>(i)];
    const int v = 3 * i + 1, a = v + 1, a1 = v + 4, V = 3 * (static_cast<int>(cam.steps.size()) + 1);
    const double fa = h * (t - t * t / 2), fa1 = h * t * t / 2;  // y' = v + h (t a + t²/2 (a1 − a))
    rows.add({{v, 1.0}, {a, fa}, {a1, fa1}, {V, -1.0}}, -infinity, 0.0);
    rows.add({{v, 1.0}, {a, fa}, {a1, fa1}, {V, 1.0}}, 0.0, infinity);
}

/// Least-peak cubic in states form: x = (y_0, y'_0, y''_0, y_1, …, V, A, J).
inline QuadraticData cam_problem(const CamCase& cam) {
    const int n = static_cast<int>(cam.steps.size()), size = 3 * (n + 1) + 3;
    const int V = size - 3, A = size - 2, J = size - 1;
    QuadraticData data(size);
    for (int d = 0; d < 3; ++d) {
        data.x_lower[d] = data.x_upper[d] = 0.0;
        data.x_lower[3 * n + d] = data.x_upper[3 * n + d] = d == 0 ? 1.0 : 0.0;
    }
    for (const int peak : {V, A, J}) data.x_lower[peak] = 0.0;
    data.x_upper[V] = cam.velocity_cap;
    data.x_upper[A] = cam.acceleration_cap;
    data.x_upper[J] = cam.jerk_cap;
    data.cost[V] = cam.velocity;
    data.cost[A] = cam.acceleration;
    data.cost[J] = cam.jerk;
    RowCollector rows;
    for (int i = 0; i < n; ++i) {
        const double h = cam.steps[static_cast<std::size_t>(i)];
        const int y = 3 * i, v = y + 1, a = y + 2, y1 = y + 3, v1 = y + 4, a1 = y + 5;
        for (int copy = 0; copy < cam.copies; ++copy) {
            rows.add({{v1, 1.0}, {v, -1.0}, {a, -h / 2}, {a1, -h / 2}}, 0.0, 0.0);
            rows.add({{y1, 1.0}, {y, -1.0}, {v, -h}, {a, -h * h / 3}, {a1, -h * h / 6}}, 0.0, 0.0);
        }
        for (int k = 0; k < cam.samples; ++k)
            add_velocity_rows(rows, cam, i, static_cast<double>(k) / cam.samples);
        rows.add({{a1, 1.0}, {A, -1.0}}, -infinity, 0.0);
        rows.add({{a1, 1.0}, {A, 1.0}}, 0.0, infinity);
        rows.add({{a1, 1.0}, {a, -1.0}, {J, -h}}, -infinity, 0.0);
        rows.add({{a1, 1.0}, {a, -1.0}, {J, h}}, 0.0, infinity);
    }
    rows.write(data);
    return data;
}

}  // namespace camopt::testing

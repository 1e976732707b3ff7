// SPDX-License-Identifier: MIT
// Problems with curved rows: quadratic ones from matrices, and the limited curvature of a pitch curve.
#pragma once

#include "core/nlp.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace camopt::testing {

/// ½ xᵀ Q x + aᵀ x + b; Q empty for an affine function.
struct Quadratic {
    Eigen::MatrixXd curvature;
    Eigen::VectorXd slope;
    double constant = 0.0;
    [[nodiscard]] bool affine() const { return curvature.size() == 0; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const {
        return slope.dot(x) + constant + (affine() ? 0.0 : 0.5 * x.dot(curvature * x));
    }
    [[nodiscard]] Eigen::VectorXd gradient(const Eigen::VectorXd& x) const {
        return affine() ? slope : Eigen::VectorXd(slope + curvature * x);
    }
};

inline Quadratic affine(Eigen::VectorXd slope, double constant = 0.0) {
    return {{}, std::move(slope), constant};
}

/// ‖x − center‖² − radius², times `factor`.
inline Quadratic ball(const Eigen::VectorXd& center, double radius, double factor = 1.0) {
    const Eigen::Index n = center.size();
    return {2.0 * factor * Eigen::MatrixXd::Identity(n, n), -2.0 * factor * center,
            factor * (center.squaredNorm() - radius * radius)};
}

/// min cost subject to lower <= row <= upper, all quadratic and dense.
class CurvedNlp final : public Nlp {
 public:
    CurvedNlp(Quadratic cost, bool convex) : cost_(std::move(cost)) {
        const Eigen::Index n = cost_.slope.size();
        shape_.x_lower = Eigen::VectorXd::Constant(n, -infinity);
        shape_.x_upper = Eigen::VectorXd::Constant(n, infinity);
        shape_.convex = convex;
        shape_.linear_cost = cost_.affine();
        shape_.quadratic_cost = true;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j <= i; ++j) {
                shape_.hessian.rows.push_back(i);
                shape_.hessian.columns.push_back(j);
            }
    }
    CurvedNlp(const CurvedNlp& other) : Nlp(other.shape_), cost_(other.cost_), rows_(other.rows_) {}
    CurvedNlp& add(Quadratic row, double lower, double upper, double scale = 1.0) {
        const auto i = static_cast<int>(rows_.size());
        for (int j = 0; j < shape_.variables(); ++j) {
            shape_.jacobian.rows.push_back(i);
            shape_.jacobian.columns.push_back(j);
        }
        shape_.rows.push_back({row.affine(), false, scale});
        shape_.g_lower.conservativeResize(i + 1);
        shape_.g_upper.conservativeResize(i + 1);
        shape_.g_lower[i] = lower;
        shape_.g_upper[i] = upper;
        rows_.push_back(std::move(row));
        return *this;
    }
    CurvedNlp& box(double lower, double upper) {
        shape_.x_lower.setConstant(lower);
        shape_.x_upper.setConstant(upper);
        return *this;
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override { return cost_.value(x); }
    void gradient(const ConstVectorRef& x, VectorRef out) const override { out = cost_.gradient(x); }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        for (std::size_t i = 0; i < rows_.size(); ++i) out[static_cast<Eigen::Index>(i)] = rows_[i].value(x);
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        std::size_t k = 0;
        for (const Quadratic& row : rows_)
            for (const double value : row.gradient(x)) out[k++] = value;
    }
    void hessian(const ConstVectorRef&, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        const Eigen::Index n = cost_.slope.size();
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
        if (!cost_.affine()) sum += sigma * cost_.curvature;
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (!rows_[i].affine()) sum += lambda[static_cast<Eigen::Index>(i)] * rows_[i].curvature;
        std::size_t k = 0;
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j <= i; ++j) out[k++] = sum(i, j);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return named("x", index); }
    [[nodiscard]] std::string row_name(int index) const override { return named("row ", index); }

 private:
    static std::string named(const char* word, int index) {
        return std::string(word).append(std::to_string(index));
    }
    Quadratic cost_;
    std::vector<Quadratic> rows_;
};

/// A rise of a disk cam on `steps` equal parts of `angle`: y_0 … y_N, then the peaks V, A, J of the
/// differences. Minimizes their weighted sum; the pitch curve R = base + y has a curvature of at most
/// `most_curvature`:  R² + 2R'² − R R'' <= most_curvature (R² + R'²)^(3/2).
class PitchCurveNlp final : public Nlp {
 public:
    struct Data {
        int steps = 30;
        double angle = 1.2, base = 2.0, most_curvature = 0.62;
    };
    explicit PitchCurveNlp(const Data& data) : data_(data), h_(data.angle / data.steps) {
        const int n = data.steps + 1;
        shape_.x_lower = Eigen::VectorXd::Constant(n + 3, -infinity);
        shape_.x_upper = Eigen::VectorXd::Constant(n + 3, infinity);
        for (const int j : {0, 1}) shape_.x_lower[j] = shape_.x_upper[j] = 0.0;
        for (const int j : {n - 2, n - 1}) shape_.x_lower[j] = shape_.x_upper[j] = 1.0;
        std::vector<double> upper;
        const auto add = [&](int first, std::vector<double> stencil, int peak) {
            for (const double sign : {1.0, -1.0}) {
                const int row = static_cast<int>(upper.size());
                for (std::size_t k = 0; k < stencil.size(); ++k)
                    entry(row, first + static_cast<int>(k), sign * stencil[k]);
                entry(row, peak, -1.0);
                upper.push_back(0.0);
                shape_.rows.push_back({true, false, 1.0});
            }
        };
        for (int k = 0; k + 1 < n; ++k) add(k, {-1.0 / h_, 1.0 / h_}, n);
        for (int k = 0; k + 2 < n; ++k) add(k, {1.0 / (h_ * h_), -2.0 / (h_ * h_), 1.0 / (h_ * h_)}, n + 1);
        const double third = 1.0 / (h_ * h_ * h_);
        for (int k = 0; k + 3 < n; ++k) add(k, {-third, 3.0 * third, -3.0 * third, third}, n + 2);
        first_curved_ = static_cast<int>(upper.size());
        for (int k = 1; k + 1 < n; ++k) {
            for (int j = k - 1; j <= k + 1; ++j) entry(static_cast<int>(upper.size()), j, 0.0);
            upper.push_back(0.0);
            shape_.rows.push_back({false, true, 1.0});
        }
        shape_.g_upper = Eigen::Map<Eigen::VectorXd>(upper.data(), static_cast<Eigen::Index>(upper.size()));
        shape_.g_lower = Eigen::VectorXd::Constant(shape_.g_upper.size(), -infinity);
        for (int j = 0; j < n; ++j)
            for (int i = j; i < std::min(n, j + 3); ++i) {
                shape_.hessian.rows.push_back(i);
                shape_.hessian.columns.push_back(j);
            }
        shape_.linear_cost = shape_.quadratic_cost = true;
    }
    [[nodiscard]] Eigen::VectorXd start() const {
        const int n = data_.steps + 1;
        Eigen::VectorXd x = Eigen::VectorXd::Zero(n + 3);
        for (int k = 0; k < n; ++k) {
            const double t = std::clamp((k - 1.0) / (n - 3.0), 0.0, 1.0);
            x[k] = t * t * (3.0 - 2.0 * t);
        }
        return x;
    }
    [[nodiscard]] double cost(const ConstVectorRef& x) const override {
        return x.tail(3).dot(Eigen::Vector3d(0.2, 0.05, 0.002));
    }
    void gradient(const ConstVectorRef&, VectorRef out) const override {
        out.setZero();
        out.tail(3) << 0.2, 0.05, 0.002;
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        out.setZero();
        for (std::size_t e = 0; e < values_.size(); ++e)
            if (shape_.jacobian.rows[e] < first_curved_)
                out[shape_.jacobian.rows[e]] += values_[e] * x[shape_.jacobian.columns[e]];
        for (int k = 1; k < data_.steps; ++k) out[first_curved_ + k - 1] = curved(x, k).value;
    }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        std::size_t e = 0;
        for (; shape_.jacobian.rows[e] < first_curved_; ++e) out[e] = values_[e];
        for (int k = 1; k < data_.steps; ++k) {
            const Eigen::Vector3d slope = map().transpose() * curved(x, k).gradient;
            for (int j = 0; j < 3; ++j) out[e++] = slope[j];
        }
    }
    void hessian(const ConstVectorRef& x, double, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        const int n = data_.steps + 1;
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
        for (int k = 1; k + 1 < n; ++k)
            sum.block<3, 3>(k - 1, k - 1) +=
                lambda[first_curved_ + k - 1] * map().transpose() * curved(x, k).hessian * map();
        for (std::size_t e = 0; e < out.size(); ++e)
            out[e] = sum(shape_.hessian.rows[e], shape_.hessian.columns[e]);
    }
    [[nodiscard]] std::string variable_name(int index) const override {
        return std::string("y").append(std::to_string(index));
    }
    [[nodiscard]] std::string row_name(int index) const override {
        return std::string("row ").append(std::to_string(index));
    }

 private:
    struct Local {
        double value;
        Eigen::Vector3d gradient;
        Eigen::Matrix3d hessian;
    };
    void entry(int row, int column, double value) {
        shape_.jacobian.rows.push_back(row);
        shape_.jacobian.columns.push_back(column);
        values_.push_back(value);
    }
    /// (R, R', R'') from three neighbours.
    [[nodiscard]] Eigen::Matrix3d map() const {
        return (Eigen::Matrix3d() << 0.0, 1.0, 0.0, -0.5 / h_, 0.0, 0.5 / h_, 1.0 / (h_ * h_),
                -2.0 / (h_ * h_), 1.0 / (h_ * h_))
            .finished();
    }
    [[nodiscard]] Local curved(const ConstVectorRef& x, int k) const {
        const Eigen::Vector3d point = map() * x.segment<3>(k - 1) + Eigen::Vector3d(data_.base, 0.0, 0.0);
        const double r = point[0], d = point[1], s = point[2], q = r * r + d * d, c = data_.most_curvature;
        const double root = std::sqrt(q);
        Local result{r * r + 2.0 * d * d - r * s - c * q * root,
                     {2.0 * r - s - 3.0 * c * root * r, 4.0 * d - 3.0 * c * root * d, -r},
                     {}};
        result.hessian << 2.0 - 3.0 * c * (root + r * r / root), -3.0 * c * r * d / root, -1.0,
            -3.0 * c * r * d / root, 4.0 - 3.0 * c * (root + d * d / root), 0.0, -1.0, 0.0, 0.0;
        return result;
    }
    Data data_;
    double h_;
    int first_curved_ = 0;
    std::vector<double> values_;
};

}  // namespace camopt::testing

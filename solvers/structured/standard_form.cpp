// SPDX-License-Identifier: MIT
#include "solvers/structured/standard_form.hpp"

#include <bit>
#include <cstdint>
#include <numeric>

namespace camopt::structured {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// The nearest power of two by ratio. Of a normal number: the bits that √2 lacks to 2, added to its bits,
/// carry into the exponent from √2 on.
double power_of_two_near(double value) {
    constexpr std::uint64_t fraction = (std::uint64_t{1} << 52) - 1;
    constexpr std::uint64_t lacking =
        (std::uint64_t{1} << 52) - (std::bit_cast<std::uint64_t>(std::numbers::sqrt2) & fraction);
    if (value >= std::numeric_limits<double>::min() && value <= 0.25 * std::numeric_limits<double>::max())
        return std::bit_cast<double>((std::bit_cast<std::uint64_t>(value) + lacking) & ~fraction);
    int exponent = 0;
    const double part = std::frexp(value, &exponent);  // in [1/2, 1)
    return std::ldexp(1.0, part < std::numbers::sqrt2 / 2.0 ? exponent - 1 : exponent);
}

/// The Nlp's cost as a function of x̂.
class ScaledCost final : public ConvexCost {
 public:
    struct Frame {
        VectorXd base;
        std::vector<int> kept;
        VectorXd scale;
        double cost_scale;
        std::vector<int> hessian_entries;  ///< which entries of the Nlp's Hessian are used
    };
    ScaledCost(const Nlp& problem, Frame frame) : problem_(problem), frame_(std::move(frame)) {
        const NlpShape& shape = problem.shape();
        values_.resize(static_cast<std::size_t>(shape.hessian.size()));
        no_multipliers_ = VectorXd::Zero(shape.constraints());
        full_point_ = frame_.base;
        full_gradient_.resize(frame_.base.size());
        reduced_.assign(static_cast<std::size_t>(shape.variables()), -1);
        for (std::size_t k = 0; k < frame_.kept.size(); ++k)
            reduced_[static_cast<std::size_t>(frame_.kept[k])] = static_cast<int>(k);
    }
    double value(const VectorXd& x) const override { return frame_.cost_scale * problem_.cost(point(x)); }
    void gradient(const VectorXd& x, VectorXd& out) const override {
        problem_.gradient(point(x), full_gradient_);
        out.resize(x.size());
        for (Index k = 0; k < x.size(); ++k)
            out[k] = frame_.cost_scale * frame_.scale[k] *
                     full_gradient_[frame_.kept[static_cast<std::size_t>(k)]];
    }
    void hessian(const VectorXd& x, std::span<double> out) const override {
        if (out.empty()) return;
        problem_.hessian(point(x), 1.0, no_multipliers_, values_);
        const SparsityPattern& pattern = problem_.shape().hessian;
        for (std::size_t e = 0; e < out.size(); ++e) {
            const auto source = static_cast<std::size_t>(frame_.hessian_entries[e]);
            const int row = reduced_[static_cast<std::size_t>(pattern.rows[source])];
            const int column = reduced_[static_cast<std::size_t>(pattern.columns[source])];
            out[e] = frame_.cost_scale * frame_.scale[row] * frame_.scale[column] * values_[source];
        }
    }

 private:
    const VectorXd& point(const VectorXd& x) const {
        for (Index k = 0; k < x.size(); ++k)
            full_point_[frame_.kept[static_cast<std::size_t>(k)]] = frame_.scale[k] * x[k];
        return full_point_;
    }
    const Nlp& problem_;
    Frame frame_;
    VectorXd no_multipliers_;
    std::vector<int> reduced_;
    mutable std::vector<double> values_;
    mutable VectorXd full_point_, full_gradient_;
};

/// The Jacobian by columns, rows ascending; entries named twice are added.
Matrix matrix_of(const NlpShape& shape, const std::vector<double>& values) {
    const SparsityPattern& pattern = shape.jacobian;
    std::vector<int> next(static_cast<std::size_t>(shape.variables()) + 1, 0);
    bool ascending = true;
    for (std::size_t e = 0; e < values.size(); ++e) {
        ++next[static_cast<std::size_t>(pattern.columns[e]) + 1];
        ascending = ascending &&
                    (e == 0 || pattern.rows[e] > pattern.rows[e - 1] ||
                     (pattern.rows[e] == pattern.rows[e - 1] && pattern.columns[e] > pattern.columns[e - 1]));
    }
    Matrix matrix(shape.constraints(), shape.variables());
    if (!ascending) {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t e = 0; e < values.size(); ++e)
            entries.emplace_back(pattern.rows[e], pattern.columns[e], values[e]);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    matrix.resizeNonZeros(static_cast<Index>(values.size()));
    std::ranges::copy(next, matrix.outerIndexPtr());
    for (std::size_t e = 0; e < values.size(); ++e) {
        const int place = next[static_cast<std::size_t>(pattern.columns[e])]++;
        matrix.innerIndexPtr()[place] = pattern.rows[e];
        matrix.valuePtr()[place] = values[e];
    }
    return matrix;
}

}  // namespace

StandardForm::StandardForm(const Nlp& problem, const VectorXd& start) : problem_(problem) {
    read(start);
    if (status_ == Status::ready && problem.shape().linear_cost) leave_out_idle(start);
    if (status_ == Status::ready) keep_rows();
    if (status_ == Status::ready) equilibrate(start);
    if (status_ == Status::ready) scale_cost(start);
}

void StandardForm::fail(Status status, std::string detail) {
    status_ = status;
    detail_ = std::move(detail);
}

void StandardForm::read(const VectorXd& start) {
    const NlpShape& shape = problem_.shape();
    base_ = VectorXd::Zero(shape.variables());
    for (int j = 0; j < shape.variables(); ++j) {
        if (!(shape.x_lower[j] <= shape.x_upper[j]))
            return fail(Status::crossed_bounds, "bounds of " + problem_.variable_name(j) + " cross");
        if (shape.x_lower[j] == shape.x_upper[j])
            base_[j] = shape.x_lower[j];
        else
            kept_variables_.push_back(j);
    }
    for (int i = 0; i < shape.constraints(); ++i)
        if (!(shape.g_lower[i] <= shape.g_upper[i]))
            return fail(Status::crossed_bounds, "bounds of row " + problem_.row_name(i) + " cross");

    std::vector<double> values(static_cast<std::size_t>(shape.jacobian.size()));
    problem_.jacobian(start, values);
    full_ = matrix_of(shape, values);
    VectorXd at_start(shape.constraints());
    problem_.constraints(start, at_start);
    constant_ = at_start - full_ * start;
    // Round-off of the difference must not change a homogeneous row.
    VectorXd size = at_start.cwiseAbs();
    for (Index j = 0; j < full_.outerSize(); ++j)
        for (Matrix::InnerIterator entry(full_, j); entry; ++entry)
            size[entry.row()] += std::abs(entry.value() * start[j]);
    for (Index i = 0; i < constant_.size(); ++i)
        if (std::abs(constant_[i]) <= 1e-14 * size[i]) constant_[i] = 0.0;
    const bool finite = constant_.allFinite() &&
                        std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (!finite) return fail(Status::evaluation_error, "constraint rows are not finite");
    gradient_.resize(shape.variables());
    problem_.gradient(start, gradient_);
}

/// Variables in no row that has a side, and not in the cost: nothing would keep them from running away, and
/// what rows may be off is relative to the largest variable.
void StandardForm::leave_out_idle(const VectorXd& start) {
    const NlpShape& shape = problem_.shape();
    const auto in_row = [&](int j) {
        for (Matrix::InnerIterator entry(full_, j); entry; ++entry)
            if (entry.value() != 0.0 &&
                (std::isfinite(shape.g_lower[entry.row()]) || std::isfinite(shape.g_upper[entry.row()])))
                return true;
        return false;
    };
    const auto is_idle = [&](int j) {
        if (gradient_[j] != 0.0 || in_row(j)) return false;
        base_[j] = std::clamp(start[j], shape.x_lower[j], shape.x_upper[j]);
        return true;
    };
    std::erase_if(kept_variables_, is_idle);
}

void StandardForm::keep_rows() {
    const NlpShape& shape = problem_.shape();
    const VectorXd moved = constant_ + full_ * base_;
    VectorXd largest = VectorXd::Zero(shape.constraints());
    for (const int j : kept_variables_)
        for (Matrix::InnerIterator entry(full_, j); entry; ++entry)
            largest[entry.row()] = std::max(largest[entry.row()], std::abs(entry.value()));
    for (int i = 0; i < shape.constraints(); ++i) {
        if (largest[i] > 0.0) {
            if (std::isfinite(shape.g_lower[i]) || std::isfinite(shape.g_upper[i])) kept_rows_.push_back(i);
            continue;
        }
        const double excess = std::max(shape.g_lower[i] - moved[i], moved[i] - shape.g_upper[i]);
        if (excess <= 1e-9 * (1.0 + std::abs(moved[i]))) continue;
        Ray ray{VectorXd::Zero(shape.constraints()), {}};
        ray.row_multipliers[i] = (moved[i] > shape.g_upper[i] ? 1.0 : -1.0) / excess;
        ray.bound_multipliers = bound_multipliers(VectorXd::Zero(shape.variables()), ray.row_multipliers);
        ray_ = std::move(ray);
        return fail(Status::infeasible,
                    "row " + problem_.row_name(i) + " cannot be satisfied with the fixed variables");
    }
    std::vector<int> row_index(static_cast<std::size_t>(shape.constraints()), -1);
    for (std::size_t k = 0; k < kept_rows_.size(); ++k)
        row_index[static_cast<std::size_t>(kept_rows_[k])] = static_cast<int>(k);
    const auto rows = static_cast<Index>(kept_rows_.size()),
               columns = static_cast<Index>(kept_variables_.size());
    model_.x_lower.resize(columns);
    model_.x_upper.resize(columns);
    model_.rows.resize(rows, columns);
    model_.rows.resizeNonZeros(full_.nonZeros());
    int* const begin = model_.rows.outerIndexPtr();
    int* const inner = model_.rows.innerIndexPtr();
    double* const values = model_.rows.valuePtr();
    int entries = 0;
    for (Index k = 0; k < columns; ++k) {
        const int j = kept_variables_[static_cast<std::size_t>(k)];
        model_.x_lower[k] = shape.x_lower[j];
        model_.x_upper[k] = shape.x_upper[j];
        begin[k] = entries;
        for (Matrix::InnerIterator entry(full_, j); entry; ++entry) {
            const int row = row_index[static_cast<std::size_t>(entry.row())];
            if (row < 0 || entry.value() == 0.0) continue;
            inner[entries] = row;
            values[entries++] = entry.value();
        }
    }
    begin[columns] = entries;
    model_.rows.resizeNonZeros(entries);
    model_.row_lower.resize(rows);
    model_.row_upper.resize(rows);
    for (Index k = 0; k < rows; ++k) {
        const int i = kept_rows_[static_cast<std::size_t>(k)];
        model_.row_lower[k] = shape.g_lower[i] - moved[i];
        model_.row_upper[k] =
            shape.g_lower[i] == shape.g_upper[i] ? model_.row_lower[k] : shape.g_upper[i] - moved[i];
    }
}

void StandardForm::equilibrate(const VectorXd& start) {
    const NlpShape& shape = problem_.shape();
    model_.kind = shape.linear_cost      ? CostKind::linear
                  : shape.quadratic_cost ? CostKind::quadratic
                                         : CostKind::smooth;
    ScaledCost::Frame frame{base_, kept_variables_, VectorXd::Ones(model_.variables()), 1.0, {}};
    std::vector<int> column_index(static_cast<std::size_t>(shape.variables()), -1);
    for (std::size_t k = 0; k < kept_variables_.size(); ++k)
        column_index[static_cast<std::size_t>(kept_variables_[k])] = static_cast<int>(k);
    for (int e = 0; model_.kind != CostKind::linear && e < shape.hessian.size(); ++e) {
        const auto entry = static_cast<std::size_t>(e);
        const int row = column_index[static_cast<std::size_t>(shape.hessian.rows[entry])];
        const int column = column_index[static_cast<std::size_t>(shape.hessian.columns[entry])];
        if (row < 0 || column < 0) continue;
        model_.hessian.rows.push_back(std::max(row, column));
        model_.hessian.columns.push_back(std::min(row, column));
        frame.hessian_entries.push_back(e);
    }
    model_.cost = std::make_unique<ScaledCost>(problem_, frame);
    std::vector<double> curvature(frame.hessian_entries.size());
    model_.cost->hessian(to_model(start), curvature);
    if (!std::all_of(curvature.begin(), curvature.end(), [](double v) { return std::isfinite(v); }))
        return fail(Status::evaluation_error, "the cost's Hessian is not finite at the start");

    constexpr int sweeps = 12;
    constexpr double balanced = 2.0;  // powers of two are applied: closer is not worth a sweep
    column_scale_ = VectorXd::Ones(model_.variables());
    row_scale_ = VectorXd::Ones(model_.constraints());
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        VectorXd column_size = VectorXd::Zero(model_.variables()),
                 row_size = VectorXd::Zero(model_.constraints());
        for (Index j = 0; j < model_.variables(); ++j)
            for (Matrix::InnerIterator entry(model_.rows, j); entry; ++entry) {
                const double size = std::abs(entry.value()) * column_scale_[j] * row_scale_[entry.row()];
                column_size[j] = std::max(column_size[j], size);
                row_size[entry.row()] = std::max(row_size[entry.row()], size);
            }
        double farthest = 1.0;
        const auto balance = [&](VectorXd& size, VectorXd& scale) {
            if (size.size() == 0) return;
            size = (size.array() > 0.0).select(size, 1.0);
            farthest = std::max({farthest, size.maxCoeff(), 1.0 / size.minCoeff()});
            scale.array() /= size.array().sqrt();
        };
        balance(column_size, column_scale_);
        balance(row_size, row_scale_);
        if (farthest <= balanced) break;
    }
    // Variables in no row are scaled by their curvature.
    for (std::size_t e = 0; e < curvature.size(); ++e) {
        const int j = model_.hessian.rows[e];
        if (j == model_.hessian.columns[e] && curvature[e] > 0.0 && model_.rows.col(j).nonZeros() == 0)
            column_scale_[j] = 1.0 / std::sqrt(curvature[e]);
    }
    column_scale_ = column_scale_.unaryExpr(&power_of_two_near);
    shrink_far_rows();
    row_scale_ = row_scale_.unaryExpr(&power_of_two_near);

    for (Index j = 0; j < model_.variables(); ++j)
        for (Matrix::InnerIterator entry(model_.rows, j); entry; ++entry)
            entry.valueRef() *= row_scale_[entry.row()] * column_scale_[j];
    model_.row_lower.array() *= row_scale_.array();
    model_.row_upper.array() *= row_scale_.array();
    model_.x_lower.array() /= column_scale_.array();
    model_.x_upper.array() /= column_scale_.array();
    frame.scale = column_scale_;
    model_.cost = std::make_unique<ScaledCost>(problem_, frame);
}

/// Limits on one variable that lie far beyond it: their slacks would be far from those of all other rows.
void StandardForm::shrink_far_rows() {
    constexpr double far = 1e4;
    VectorXd entries = VectorXd::Zero(model_.constraints());
    for (Index j = 0; j < model_.variables(); ++j)
        for (Matrix::InnerIterator entry(model_.rows, j); entry; ++entry) entries[entry.row()] += 1.0;
    for (Index i = 0; i < model_.constraints(); ++i) {
        const double low = std::abs(model_.row_lower[i]), high = std::abs(model_.row_upper[i]);
        const double nearest = row_scale_[i] * std::min(low, high);
        const bool is_limit = entries[i] == 1.0 && low != high && std::isfinite(nearest);
        if (is_limit && nearest > far) row_scale_[i] /= nearest;
    }
}

void StandardForm::scale_cost(const VectorXd& start) {
    const VectorXd x = to_model(start);
    std::vector<double> curvature(static_cast<std::size_t>(model_.hessian.size()));
    model_.cost->hessian(x, curvature);
    const VectorXd gradient = gradient_(kept_variables_).cwiseProduct(column_scale_);
    double size = gradient.size() > 0 ? gradient.cwiseAbs().maxCoeff() : 0.0;
    for (const double entry : curvature) size = std::max(size, std::abs(entry));
    if (!std::isfinite(size)) return fail(Status::evaluation_error, "the cost is not finite at the start");
    if (size == 0.0) return;
    cost_scale_ = power_of_two_near(1.0 / size);
    model_.cost_unit = std::min(1.0, cost_scale_);
    if (model_.kind == CostKind::linear) {
        const double value = model_.cost->value(x);
        model_.cost =
            std::make_unique<LinearCost>(cost_scale_ * gradient, cost_scale_ * (value - gradient.dot(x)));
        return;
    }
    ScaledCost::Frame frame{base_, kept_variables_, column_scale_, cost_scale_, {}};
    const SparsityPattern& pattern = problem_.shape().hessian;
    for (int e = 0; model_.kind != CostKind::linear && e < pattern.size(); ++e) {
        const auto entry = static_cast<std::size_t>(e);
        const bool kept =
            std::binary_search(kept_variables_.begin(), kept_variables_.end(), pattern.rows[entry]) &&
            std::binary_search(kept_variables_.begin(), kept_variables_.end(), pattern.columns[entry]);
        if (kept) frame.hessian_entries.push_back(e);
    }
    model_.cost = std::make_unique<ScaledCost>(problem_, frame);
}

VectorXd StandardForm::to_model(const VectorXd& x) const {
    VectorXd result(static_cast<Index>(kept_variables_.size()));
    for (Index k = 0; k < result.size(); ++k) {
        result[k] = x[kept_variables_[static_cast<std::size_t>(k)]];
        if (column_scale_.size() == result.size()) result[k] /= column_scale_[k];
    }
    return result;
}

VectorXd StandardForm::to_problem(const VectorXd& x) const {
    VectorXd result = base_;
    const NlpShape& shape = problem_.shape();
    for (Index k = 0; k < x.size(); ++k) {
        const int j = kept_variables_[static_cast<std::size_t>(k)];
        result[j] = std::clamp(x[k] * column_scale_[k], shape.x_lower[j], shape.x_upper[j]);
    }
    return result;
}

VectorXd StandardForm::row_multipliers(const VectorXd& lambda, double cost_scale) const {
    VectorXd result = VectorXd::Zero(problem_.shape().constraints());
    for (Index k = 0; k < lambda.size(); ++k)
        result[kept_rows_[static_cast<std::size_t>(k)]] = lambda[k] * row_scale_[k] / cost_scale;
    return result;
}

VectorXd StandardForm::model_multipliers(const VectorXd& lambda) const {
    VectorXd result = VectorXd::Zero(static_cast<Index>(kept_rows_.size()));
    for (Index k = 0; k < result.size(); ++k) {
        const Index row = kept_rows_[static_cast<std::size_t>(k)];
        if (row < lambda.size()) result[k] = lambda[row] * cost_scale_ / row_scale_[k];
    }
    return result;
}

VectorXd StandardForm::bound_multipliers(const VectorXd& gradient, const VectorXd& lambda) const {
    const NlpShape& shape = problem_.shape();
    VectorXd result = -(gradient + full_.transpose() * lambda);
    for (Index j = 0; j < result.size(); ++j)
        if (!std::isfinite(result[j] > 0.0 ? shape.x_upper[j] : shape.x_lower[j])) result[j] = 0.0;
    return result;
}

double StandardForm::ray_value(const Ray& ray) const {
    const NlpShape& shape = problem_.shape();
    double value = 0.0;
    for (Index i = 0; i < ray.row_multipliers.size(); ++i) {
        const double factor = ray.row_multipliers[i];
        if (factor != 0.0)
            value -= factor * ((factor > 0.0 ? shape.g_upper[i] : shape.g_lower[i]) - constant_[i]);
    }
    for (Index j = 0; j < ray.bound_multipliers.size(); ++j) {
        const double factor = ray.bound_multipliers[j];
        if (factor != 0.0) value -= factor * (factor > 0.0 ? shape.x_upper[j] : shape.x_lower[j]);
    }
    return value;
}

}  // namespace camopt::structured

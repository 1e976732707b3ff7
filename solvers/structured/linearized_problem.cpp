// SPDX-License-Identifier: MIT
#include "solvers/structured/linearized_problem.hpp"

namespace camopt::structured {

using Eigen::Index;
using Eigen::VectorXd;

bool NlpPoint::finite() const {
    return std::isfinite(cost) && rows.allFinite() && gradient.allFinite() &&
           std::all_of(jacobian.begin(), jacobian.end(), [](double v) { return std::isfinite(v); });
}

NlpPoint evaluated(const Nlp& problem, VectorXd x) {
    NlpPoint point;
    point.x = std::move(x);
    point.rows.resize(problem.shape().constraints());
    point.cost = problem.cost(point.x);
    problem.constraints(point.x, point.rows);
    return point;
}

void differentiate(const Nlp& problem, NlpPoint& point) {
    point.gradient.resize(problem.shape().variables());
    point.jacobian.resize(static_cast<std::size_t>(problem.shape().jacobian.size()));
    problem.gradient(point.x, point.gradient);
    problem.jacobian(point.x, point.jacobian);
}

LinearizedProblem::LinearizedProblem(const Nlp& problem, const NlpPoint& point, const StepModel& model)
    : problem_(problem), model_(model), variables_(problem.shape().variables()), values_(point.jacobian) {
    const NlpShape& base = problem.shape();
    shape_.x_lower = model.step_lower / model.unit;
    shape_.x_upper = model.step_upper / model.unit;
    shape_.g_lower = (base.g_lower - model.rows) / model.unit;
    shape_.g_upper = (base.g_upper - model.rows) / model.unit;
    shape_.rows = base.rows;
    for (RowKind& row : shape_.rows) row.linear = true;
    shape_.jacobian = base.jacobian;
    for (Index j = 0; j < model.curvature.outerSize(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(model.curvature, j); entry; ++entry) {
            shape_.hessian.rows.push_back(static_cast<int>(entry.row()));
            shape_.hessian.columns.push_back(static_cast<int>(entry.col()));
        }
    shape_.convex = shape_.quadratic_cost = true;
    shape_.linear_cost = shape_.hessian.size() == 0;
    if (model.without_nonlinear_rows) drop_nonlinear_rows();
    if (model.penalty > 0.0) add_elastic_rows();
}

/// Their values need not even be finite.
void LinearizedProblem::drop_nonlinear_rows() {
    const NlpShape& base = problem_.shape();
    const auto linear = [&](int row) { return base.rows[static_cast<std::size_t>(row)].linear; };
    for (int i = 0; i < base.constraints(); ++i)
        if (!linear(i)) {
            shape_.g_lower[i] = -infinity;
            shape_.g_upper[i] = infinity;
        }
    for (std::size_t e = 0; e < values_.size(); ++e)
        if (!linear(base.jacobian.rows[e])) values_[e] = 0.0;
}

void LinearizedProblem::add_elastic_rows() {
    const NlpShape& base = problem_.shape();
    const int t = variables_;
    shape_.x_lower.conservativeResize(t + 1);
    shape_.x_upper.conservativeResize(t + 1);
    shape_.x_lower[t] = -model_.elastic_base / model_.unit;
    shape_.x_upper[t] = infinity;
    std::vector<int> extra_of(static_cast<std::size_t>(base.constraints()), -1);
    const auto add_entry = [&](int row, int column, double value) {
        shape_.jacobian.rows.push_back(row);
        shape_.jacobian.columns.push_back(column);
        values_.push_back(value);
    };
    std::vector<double> extra_lower;
    for (int i = 0; i < base.constraints(); ++i) {
        if (base.rows[static_cast<std::size_t>(i)].linear) continue;
        const bool upper = std::isfinite(base.g_upper[i]), lower = std::isfinite(base.g_lower[i]);
        const double room = model_.weights[i] * model_.elastic_base / model_.unit;
        shape_.g_upper[i] += room;
        shape_.g_lower[i] -= room;
        if (upper || lower) add_entry(i, t, upper ? -model_.weights[i] : model_.weights[i]);
        if (!upper || !lower) continue;
        const int row = base.constraints() + static_cast<int>(extra_rows_.size());
        extra_of[static_cast<std::size_t>(i)] = row;
        extra_rows_.push_back(i);
        extra_lower.push_back(shape_.g_lower[i]);
        shape_.g_lower[i] = -infinity;
        shape_.rows.push_back(shape_.rows[static_cast<std::size_t>(i)]);
        add_entry(row, t, model_.weights[i]);
    }
    for (std::size_t e = 0; e < base.jacobian.rows.size(); ++e) {
        const int row = extra_of[static_cast<std::size_t>(base.jacobian.rows[e])];
        if (row >= 0) add_entry(row, base.jacobian.columns[e], values_[e]);
    }
    const auto extra = static_cast<Index>(extra_lower.size());
    shape_.g_lower.conservativeResize(base.constraints() + extra);
    shape_.g_upper.conservativeResize(base.constraints() + extra);
    shape_.g_lower.tail(extra) = Eigen::Map<const VectorXd>(extra_lower.data(), extra);
    shape_.g_upper.tail(extra).setConstant(infinity);
}

double LinearizedProblem::cost(const ConstVectorRef& u) const {
    const VectorXd step = u.head(variables_);
    const VectorXd image = model_.curvature.selfadjointView<Eigen::Lower>() * step;
    double value = model_.slope.dot(step) + 0.5 * model_.unit * step.dot(image);
    if (u.size() > variables_) value += model_.penalty * u[variables_];
    return value / model_.cost_unit;
}

void LinearizedProblem::gradient(const ConstVectorRef& u, VectorRef out) const {
    const VectorXd step = u.head(variables_);
    const VectorXd image = model_.curvature.selfadjointView<Eigen::Lower>() * step;
    out.head(variables_) = (model_.slope + model_.unit * image) / model_.cost_unit;
    if (u.size() > variables_) out[variables_] = model_.penalty / model_.cost_unit;
}

void LinearizedProblem::constraints(const ConstVectorRef& u, VectorRef out) const {
    out.setZero();
    for (std::size_t e = 0; e < values_.size(); ++e)
        out[shape_.jacobian.rows[e]] += values_[e] * u[shape_.jacobian.columns[e]];
}

void LinearizedProblem::hessian(const ConstVectorRef&, double sigma, const ConstVectorRef&,
                                std::span<double> out) const {
    std::size_t k = 0;
    for (Index j = 0; j < model_.curvature.outerSize(); ++j)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(model_.curvature, j); entry; ++entry)
            out[k++] = sigma * model_.unit / model_.cost_unit * entry.value();
}

int LinearizedProblem::source_row(int index) const {
    const int own = problem_.shape().constraints();
    return index < own ? index : extra_rows_[static_cast<std::size_t>(index - own)];
}

VectorXd LinearizedProblem::step_of(const VectorXd& u) const {
    return model_.unit * u.head(variables_);
}

double LinearizedProblem::elastic_of(const VectorXd& u) const {
    return u.size() > variables_ ? model_.elastic_base + model_.unit * u[variables_] : 0.0;
}

VectorXd LinearizedProblem::multipliers_of(const VectorXd& lambda) const {
    const int own = problem_.shape().constraints();
    VectorXd result = lambda.head(own);
    for (std::size_t k = 0; k < extra_rows_.size(); ++k)
        result[extra_rows_[k]] += lambda[own + static_cast<Index>(k)];
    return model_.cost_unit * result;
}

StepModel projection_model(const Nlp& problem, const NlpPoint& start) {
    const NlpShape& shape = problem.shape();
    StepModel model;
    model.slope = VectorXd::Zero(shape.variables());
    model.curvature.resize(shape.variables(), shape.variables());
    model.curvature.setIdentity();
    model.rows = start.rows;
    model.step_lower = shape.x_lower - start.x;
    model.step_upper = shape.x_upper - start.x;
    model.weights = VectorXd::Ones(shape.constraints());
    model.without_nonlinear_rows = true;
    return model;
}

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Largest sum of absolute values of a row: a bound of every eigenvalue (Gershgorin).
double row_sum(const Matrix& lower) {
    VectorXd sums = VectorXd::Zero(lower.rows());
    for (Index j = 0; j < lower.outerSize(); ++j)
        for (Matrix::InnerIterator entry(lower, j); entry; ++entry) {
            sums[entry.row()] += std::abs(entry.value());
            if (entry.row() != entry.col()) sums[entry.col()] += std::abs(entry.value());
        }
    return sums.size() > 0 ? sums.maxCoeff() : 0.0;
}

}  // namespace

ActiveRows ActiveRows::part(const std::function<bool(Index)>& chosen) const {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> kept;
    for (Index i = 0; i < residuals.size(); ++i) {
        if (!chosen(i)) continue;
        const int row = static_cast<int>(kept.size());
        for (decltype(normals)::InnerIterator entry(normals, i); entry; ++entry)
            entries.emplace_back(row, static_cast<int>(entry.col()), entry.value());
        kept.push_back(residuals[i]);
    }
    ActiveRows result;
    result.normals.resize(static_cast<Index>(kept.size()), normals.cols());
    result.normals.setFromTriplets(entries.begin(), entries.end());
    result.residuals = Eigen::Map<const VectorXd>(kept.data(), static_cast<Index>(kept.size()));
    return result;
}

/// False: an entry that trial_ has no place for.
bool HessianConvexifier::read_values(const Matrix& lower, const ActiveRows& active) {
    if (trial_.rows() != lower.rows()) return false;
    own_.setZero(trial_.nonZeros());
    gram_.setZero(trial_.nonZeros());
    const Matrix by_column = active.normals;
    bool complete = true;
    const auto add = [&](VectorXd& values, Index row, double value) {
        const int place = place_[static_cast<std::size_t>(row)];
        if (place < 0)
            complete = false;
        else
            values[place] += value;
    };
    for (Index j = 0; j < trial_.outerSize() && complete; ++j) {
        const int begin = trial_.outerIndexPtr()[j], end = trial_.outerIndexPtr()[j + 1];
        const int* const rows = trial_.innerIndexPtr();
        for (int p = begin; p < end; ++p) place_[static_cast<std::size_t>(rows[p])] = p;
        for (Matrix::InnerIterator entry(lower, j); entry; ++entry) add(own_, entry.row(), entry.value());
        for (Matrix::InnerIterator own(by_column, j); own; ++own)
            for (decltype(active.normals)::InnerIterator entry(active.normals, own.row()); entry; ++entry)
                if (entry.col() >= j) add(gram_, entry.col(), own.value() * entry.value());
        for (int p = begin; p < end; ++p) place_[static_cast<std::size_t>(rows[p])] = -1;
    }
    return complete;
}

void HessianConvexifier::grow(const Matrix& lower, const ActiveRows& active) {
    const Index size = lower.rows();
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](Index row, Index column) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), 1.0);
    };
    for (Index j = 0; j < size; ++j) add(j, j);
    for (const Matrix* known : {&std::as_const(trial_), &lower})
        for (Index j = 0; j < known->outerSize(); ++j)
            for (Matrix::InnerIterator entry(*known, j); entry; ++entry) add(entry.row(), j);
    for (Index i = 0; i < active.normals.rows(); ++i)
        for (decltype(active.normals)::InnerIterator one(active.normals, i); one; ++one)
            for (decltype(active.normals)::InnerIterator other(active.normals, i); other; ++other)
                if (other.col() > one.col()) add(other.col(), one.col());
    trial_.resize(size, size);
    trial_.setFromTriplets(entries.begin(), entries.end());
    place_.assign(static_cast<std::size_t>(size), -1);
    factor_ = make_symmetric_factor(FactorKind::automatic, trial_,
                                    std::vector<int>(static_cast<std::size_t>(size), 1));
}

void HessianConvexifier::read(const Matrix& lower, const ActiveRows& active, double least) {
    if (!read_values(lower, active)) {
        grow(lower, active);
        static_cast<void>(read_values(lower, active));
    }
    for (Index j = 0; j < trial_.outerSize(); ++j) own_[trial_.outerIndexPtr()[j]] += least;
}

bool HessianConvexifier::is_definite(double weight, double shift) {
    Eigen::Map<VectorXd>(trial_.valuePtr(), trial_.nonZeros()) = own_ + weight * gram_;
    return factor_->factorize(trial_, VectorXd::Constant(trial_.rows(), shift)) == FactorOutcome::ok;
}

/// Slightly more than needed: a large shift keeps the sequence at saddle points for long.
double HessianConvexifier::least_shift(double weight, double bound) {
    constexpr double first_shift = 1e-4, growth = 4.0, margin = 1.2;
    constexpr int halvings = 4;
    double refused = 0.0, shift = first_shift * bound;
    for (; shift < bound && !is_definite(weight, shift); shift *= growth) refused = shift;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (refused + shift);
        (is_definite(weight, middle) ? shift : refused) = middle;
    }
    return margin * shift;
}

ConvexifiedHessian HessianConvexifier::convexified(const Matrix& lower, const ActiveRows& active,
                                                   double least) {
    constexpr int weights = 5;
    read(lower, active, least);
    ConvexifiedHessian result;
    result.slope = VectorXd::Zero(lower.rows());
    const double bound = row_sum(lower);
    double weight = 0.0;
    if (bound > 0.0 && !is_definite(0.0, 0.0)) {
        weight = bound;
        result.holds = active.normals.rows() > 0;
        bool definite = false;
        for (int k = 0; k < weights && result.holds && !definite; ++k)
            definite = is_definite(weight = bound * std::pow(10.0, k), 0.0);
        if (!definite) result.shift = least_shift(weight = bound, bound);
        if (result.holds) result.slope = weight * (active.normals.transpose() * active.residuals);
    }
    result.lower = trial_;
    Eigen::Map<VectorXd> values(result.lower.valuePtr(), result.lower.nonZeros());
    values = own_ + weight * gram_;
    for (Index j = 0; j < trial_.outerSize(); ++j) values[trial_.outerIndexPtr()[j]] += result.shift;
    result.lower.prune([](Index, Index, double value) { return value != 0.0; });
    return result;
}

}  // namespace camopt::structured

// SPDX-License-Identifier: MIT
#include "objectives/free_knots/free_knot_problem.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int orders = 6;       // y … y^{(5)}
constexpr int rule_orders = 4;  // those in a rule

/// The lowest derivative in a rule, and whether it is the only one.
int lowest_order(const PointRule& rule) {
    if (!rule.linear()) return 0;
    const RuleValue affine =
        rule.evaluate({0.0, {}}, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rule.parameters().size())));
    int order = 0;
    while (order < rule_orders - 1 && affine.gradient[order] == 0.0) ++order;
    return order;
}

}  // namespace

FreeKnotNlp::FreeKnotNlp(std::shared_ptr<const CamModel> model, std::shared_ptr<const FreeKnotForm> form,
                         std::vector<FreeSample> samples)
    : model_(std::move(model)), form_(std::move(form)), samples_(std::move(samples)) {
    set_scale();
    set_bounds();
    add_form_rows();
    add_parameter_rows();
    for (int k = 0; k < static_cast<int>(samples_.size()); ++k) add_sample_row(k);
    add_cost_terms();
    fix_patterns();
}

void FreeKnotNlp::set_scale() {
    const FreeKnotForm& form = *form_;
    const auto parameters = static_cast<int>(model_->parameters.size());
    scale_.resize(form.size() + parameters);
    for (int j = 0; j < form.size(); ++j) {
        const int order = form.order(j);
        if (order < 0) {
            scale_[j] = form.mean_length();
        } else if (order < 3) {
            scale_[j] = model_->entry_scale[order];
        } else {
            scale_[j] = model_->jerk_reference / std::pow(form.mean_length(), order - 3);
        }
    }
    for (int p = 0; p < parameters; ++p) scale_[form.size() + p] = model_->parameters[p].reference;
}

void FreeKnotNlp::set_bounds() {
    const int size = form_->size();
    shape_.x_lower = shape_.x_upper = Eigen::VectorXd(scale_.size());
    shape_.x_lower.head(size) = form_->lower().cwiseQuotient(scale_.head(size));
    shape_.x_upper.head(size) = form_->upper().cwiseQuotient(scale_.head(size));
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        const Eigen::Index variable = size + static_cast<Eigen::Index>(p);
        const bool rms = parameter.kind == Parameter::Kind::rms;
        shape_.x_lower[variable] = rms ? least_rms : parameter.lower;
        shape_.x_upper[variable] = parameter.upper;
    }
}

void FreeKnotNlp::push(Row row, double lower, double upper, RowKind kind) {
    rows_.push_back(std::move(row));
    const auto count = static_cast<Eigen::Index>(rows_.size());
    shape_.g_lower.conservativeResize(count);
    shape_.g_upper.conservativeResize(count);
    shape_.g_lower[count - 1] = lower;
    shape_.g_upper[count - 1] = upper;
    shape_.rows.push_back(kind);
}

FreeKnotNlp::Row FreeKnotNlp::placed_row(Row::Kind kind, const FreePlace& place, int first) const {
    Row row;
    row.kind = kind;
    row.place = place;
    row.first = first;
    for (int m = first; m <= form_->degree(); ++m)
        row.columns.push_back(form_->coefficient(place.segment, m));
    if (first < form_->degree() && !(place.moves && place.at == 0.0)) {  // else the value is constant
        const int left = form_->breakpoint(place.segment);
        const int right = form_->breakpoint(place.segment + 1);
        if (left >= 0) row.columns.push_back(left);
        if (right >= 0 && place.moves) row.columns.push_back(right);
    }
    row.own = static_cast<int>(row.columns.size());
    return row;
}

void FreeKnotNlp::add_form_rows() {
    for (const FreeEquality& equality : form_->equalities()) {
        Row row = placed_row(Row::Kind::functional, equality.place, equality.order);
        row.name = equality.name;
        row.order = equality.order;
        row.unit = scale_[form_->coefficient(0, equality.order)];
        row.offset = -equality.value;
        if (equality.minus >= 0) row.columns.push_back(equality.minus);
        const bool moves = row.own > form_->degree() - equality.order + 1;
        push(std::move(row), 0.0, 0.0, {!moves, false, 1.0});
    }
    for (int i = 1; i + 1 < form_->segments(); ++i) {
        Row row;
        row.name = fmt::format("length of segment {}", i);
        row.columns = {form_->breakpoint(i), form_->breakpoint(i + 1)};
        row.weights = {-1.0, 1.0};
        push(std::move(row), form_->least_length(i) / form_->mean_length(), infinity, {true, false, 1.0});
    }
}

void FreeKnotNlp::add_parameter_rows() {
    for (const ParameterRow& source : model_->parameter_rows) {
        Row row;
        row.name = source.name;
        for (const int parameter : source.parameters) row.columns.push_back(form_->size() + parameter);
        row.weights = source.weights;
        push(std::move(row), -infinity, source.upper, {true, source.limit, source.scale});
    }
}

void FreeKnotNlp::add_sample_row(int sample) {
    const FreeSample& source = samples_[sample];
    const PointRule& rule = *model_->rules[source.rule];
    Row row = placed_row(Row::Kind::rule, {source.segment, true, source.fraction}, lowest_order(rule));
    row.name = fmt::format("{} at {:.6g} of segment {}{}", rule.name(), source.fraction, source.segment,
                           source.mirrored ? " mirrored" : "");
    row.sample = sample;
    const bool moves = row.own > form_->degree() - row.first + 1;
    for (const int parameter : rule.parameters()) row.columns.push_back(form_->size() + parameter);
    push(std::move(row), -infinity, 0.0, {rule.linear() && !moves, rule.limit(), rule.scale()});
}

void FreeKnotNlp::add_cost_terms() {
    linear_cost_ = Eigen::VectorXd::Zero(shape_.variables());
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        const int variable = form_->size() + static_cast<int>(p);
        if (parameter.kind == Parameter::Kind::rms) {
            rms_.push_back({variable, parameter.order, parameter.weight, parameter.reference});
        } else {
            linear_cost_[variable] = parameter.weight;
        }
    }
    shape_.linear_cost = shape_.quadratic_cost = rms_.empty();
}

// ---- one row
// ------------------------------------------------------------------------------------------------

FreeKnotNlp::Outer FreeKnotNlp::rule_outer(const Row& row, const Eigen::VectorXd& x,
                                           const FreePoint& point) const {
    const FreeSample& sample = samples_[row.sample];
    const PointRule& rule = *model_->rules[sample.rule];
    MotionPoint place{point.x, {}};
    std::array<double, rule_orders> sign{};
    for (int r = 0; r < rule_orders; ++r) {
        const auto at = static_cast<std::size_t>(r);
        sign[at] = sample.mirrored ? form_->mirror_sign(r) : 1.0;
        place.derivative[at] =
            sign[at] * point.derivative[at] + (sample.mirrored ? form_->mirror_offset(r) : 0.0);
    }
    if (sample.mirrored) place.x = form_->begin() + form_->whole_end() - point.x;
    const auto parameters = static_cast<Eigen::Index>(rule.parameters().size());
    Eigen::VectorXd q(parameters);
    for (Eigen::Index k = 0; k < parameters; ++k) {
        const int column = row.columns[row.own + k];
        q[k] = x[column] / scale_[column];  // a rule takes parameters in units of their references
    }
    const RuleValue value = rule.evaluate(place, q);
    Eigen::VectorXd unit(rule_orders + parameters);
    unit << Eigen::Map<const Eigen::Vector4d>(sign.data()), Eigen::VectorXd::Ones(parameters);
    const Eigen::VectorXd slope = unit.cwiseProduct(value.gradient);
    Outer outer{value.value, Eigen::VectorXd::Zero(orders + parameters), {}};
    outer.slope << slope.head<rule_orders>(), 0.0, 0.0, slope.tail(parameters);
    if (rule.linear()) return outer;
    const Eigen::MatrixXd curved = unit.asDiagonal() * value.hessian * unit.asDiagonal();
    outer.curvature = Eigen::MatrixXd::Zero(orders + parameters, orders + parameters);
    outer.curvature.topLeftCorner<rule_orders, rule_orders>() =
        curved.topLeftCorner<rule_orders, rule_orders>();
    outer.curvature.topRightCorner(orders, parameters).topRows<rule_orders>() =
        curved.topRightCorner(rule_orders, parameters);
    outer.curvature.bottomLeftCorner(parameters, orders).leftCols<rule_orders>() =
        curved.bottomLeftCorner(parameters, rule_orders);
    outer.curvature.bottomRightCorner(parameters, parameters) =
        curved.bottomRightCorner(parameters, parameters);
    return outer;
}

FreeKnotNlp::Outer FreeKnotNlp::outer(const Row& row, const Eigen::VectorXd& x,
                                      const FreePoint& point) const {
    if (row.kind == Row::Kind::rule) return rule_outer(row, x, point);
    const auto others = static_cast<Eigen::Index>(row.columns.size()) - row.own;
    Outer outer{
        (point.derivative[row.order] + row.offset) / row.unit, Eigen::VectorXd::Zero(orders + others), {}};
    outer.slope[row.order] = 1.0 / row.unit;
    if (others > 0) {  // `minus` has the unit of the row
        outer.value -= x[row.columns.back()] / row.unit;
        outer.slope[orders] = -1.0;
    }
    return outer;
}

Eigen::MatrixXd FreeKnotNlp::chain(const Row& row, const FreePoint& point) const {
    Eigen::MatrixXd chain = Eigen::MatrixXd::Zero(orders, row.own);
    const int coefficients = form_->degree() - row.first + 1;
    for (int k = 0; k < row.own; ++k) {
        const int column = row.columns[k];
        const double by = column == form_->breakpoint(row.place.segment) ? point.by_left : point.by_right;
        for (int r = 0; r < orders; ++r) {
            chain(r, k) = k < coefficients ? FreeKnotForm::power(point.tau, r, row.first + k)
                                           : by * point.derivative[static_cast<std::size_t>(r) + 1];
        }
    }
    for (int k = 0; k < row.own; ++k) chain.col(k) *= scale_[row.columns[k]];
    return chain;
}

void FreeKnotNlp::constraints(const ConstVectorRef& x, VectorRef out) const {
    const Eigen::VectorXd own = physical(x);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        double value = row.offset;
        if (row.kind == Row::Kind::linear) {
            for (std::size_t k = 0; k < row.columns.size(); ++k) value += row.weights[k] * x[row.columns[k]];
        } else {
            value = outer(row, own, form_->point(own, row.place)).value;
        }
        out[static_cast<Eigen::Index>(i)] = value;
    }
}

void FreeKnotNlp::jacobian(const ConstVectorRef& x, std::span<double> out) const {
    const Eigen::VectorXd own = physical(x);
    auto next = out.begin();
    for (const Row& row : rows_) {
        if (row.kind == Row::Kind::linear) {
            next = std::ranges::copy(row.weights, next).out;
            continue;
        }
        const FreePoint point = form_->point(own, row.place);
        const Outer value = outer(row, own, point);
        const Eigen::VectorXd by_own = chain(row, point).transpose() * value.slope.head<orders>();
        next = std::ranges::copy(by_own, next).out;
        for (Eigen::Index k = orders; k < value.slope.size(); ++k) *next++ = value.slope[k];
    }
}

bool FreeKnotNlp::may_curve(const Row& row, int a, int b) const {
    if (row.kind == Row::Kind::rule && !model_->rules[samples_[row.sample].rule]->linear()) return true;
    const int coefficients = form_->degree() - row.first + 1;
    return std::max(a, b) >= coefficients && std::max(a, b) < row.own;
}

/// Chainᵀ outer'' chain + Σ_r outer'_r ∇²y^{(r)} over all columns of a row.
Eigen::MatrixXd FreeKnotNlp::row_curvature(const Row& row, const Eigen::VectorXd& x) const {
    const FreePoint point = form_->point(x, row.place);
    const Outer value = outer(row, x, point);
    const auto all = static_cast<Eigen::Index>(row.columns.size());
    const Eigen::Index others = all - row.own;
    Eigen::MatrixXd curvature = Eigen::MatrixXd::Zero(all, all);
    if (value.curvature.size() > 0) {
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(orders + others, all);
        full.topLeftCorner(orders, row.own) = chain(row, point);
        full.bottomRightCorner(others, others).setIdentity();
        curvature = full.transpose() * value.curvature * full;
    }
    const int coefficients = form_->degree() - row.first + 1;
    const auto by = [&](int k) {
        const int column = row.columns[k];
        const double rate = column == form_->breakpoint(row.place.segment) ? point.by_left : point.by_right;
        return rate * scale_[column];
    };
    for (int r = 0; r < orders; ++r) {
        if (value.slope[r] == 0.0) continue;
        for (int t = coefficients; t < row.own; ++t) {
            for (int k = 0; k < coefficients; ++k) {
                const double mixed = value.slope[r] * by(t) *
                                     FreeKnotForm::power(point.tau, r + 1, row.first + k) *
                                     scale_[row.columns[k]];
                curvature(t, k) += mixed;
                curvature(k, t) += mixed;
            }
            for (int u = coefficients; u < row.own; ++u) {
                curvature(t, u) +=
                    value.slope[r] * by(t) * by(u) * point.derivative[static_cast<std::size_t>(r) + 2];
            }
        }
    }
    return curvature;
}

}  // namespace camopt

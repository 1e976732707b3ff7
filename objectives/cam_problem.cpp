// SPDX-License-Identifier: MIT
#include "objectives/cam_problem.hpp"

#include "core/errors.hpp"
#include "objectives/curve_bounds.hpp"
#include "splines/extrema.hpp"
#include "splines/polynomial.hpp"

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Samples of one rule closer than this part of their segment are one sample.
constexpr double same_sample = 1e-9;
// A maximum is bracketed by rows at this part of the distance to the nearest sample on either side.
constexpr double bracket = 0.25;

/// The rule along one segment as a polynomial in t, for a linear rule.
Eigen::VectorXd along_segment(const PointRule& rule, const SplineCurve& curve, const Eigen::VectorXd& q,
                              int segment) {
    const RuleValue affine = rule.evaluate({0.0, {}}, q);
    Eigen::VectorXd polynomial = Eigen::VectorXd::Zero(curve.degree() + 1);
    polynomial[0] = affine.value;
    for (int order = 0; order < 4; ++order) {
        if (affine.gradient[order] == 0.0) continue;
        const Eigen::VectorXd derivative = curve.derivative_polynomial(segment, order);
        polynomial.head(derivative.size()) += affine.gradient[order] * derivative;
    }
    return polynomial;
}

/// The highest derivative the rule looks at, and with it where the rule may jump or bend.
int highest_order(const PointRule& rule) {
    const RuleValue affine =
        rule.evaluate({0.0, {}}, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rule.parameters().size())));
    int highest = 0;
    for (int order = 0; order < 4; ++order) {
        if (affine.gradient[order] != 0.0) highest = order;
    }
    return highest;
}

}  // namespace

CamProblem::CamProblem(CamModel model) : CamProblem(std::move(model), {}) {}

CamProblem::CamProblem(CamModel model, std::vector<RuleSample> samples)
    : model_(std::make_shared<const CamModel>(std::move(model))), places_(model_->rules.size()) {
    for (const auto& rule : model_->rules) {
        if (!rule->linear())
            throw ModelError(rule->name() + ": its continuous maxima cannot be found: it is not linear");
    }
    projection_ = std::make_unique<EqualityProjection>(model_->design.equalities(), design_scales(*model_));
    start_grid();
    for (const RuleSample& sample : samples) add_sample(sample.rule, sample.at, sample.side);
    rebuild();
}

void CamProblem::start_grid() {
    const SplineSpace& space = model_->design.space();
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) {
        const int order = highest_order(*model_->rules[r]);
        const int degree = space.degree() - order;  // of the rule on a segment
        const bool jumps = order > space.continuity();
        for (int i = 0; i < space.segments(); ++i) {
            const double left = space.breakpoints()[i];
            if (degree >= 1 || jumps) {
                if (i == 0 || jumps) add_sample(r, left, Side::right);
                if (degree >= 1) add_sample(r, space.breakpoints()[i + 1], Side::left);
            }
            if (degree >= 2) add_sample(r, left + 0.5 * space.width(i), Side::right);
        }
    }
}

bool CamProblem::add_sample(int rule, double at, Side side) {
    const SplineSpace& space = model_->design.space();
    const int segment = space.segment_of(at, side);
    const double tolerance = same_sample * space.width(segment);
    auto& places = places_[rule];
    const auto next = places.lower_bound({segment, at - tolerance});
    if (next != places.end() && next->first.first == segment && next->first.second <= at + tolerance) {
        return false;
    }
    places.emplace(std::pair{segment, at}, static_cast<int>(samples_.size()));
    samples_.push_back({rule, at, side});
    return true;
}

void CamProblem::rebuild() {
    grid_ = std::make_unique<GridNlp>(model_, samples_);
}

Eigen::VectorXd CamProblem::design_values(const Eigen::VectorXd& x) const {
    return design_scales(*model_).cwiseProduct(x.head(model_->design.size()));
}

SplineCurve CamProblem::curve(const Eigen::VectorXd& x) const {
    return model_->design.curve(design_values(x));
}

Eigen::VectorXd CamProblem::start() const {
    // The curve of least mean square jerk: smooth, unique, close to every optimum, and one linear system
    // away.
    const DesignVector& design = model_->design;
    const Eigen::Index size = design.size();
    const Eigen::Index rows = projection_->matrix().rows();
    const QuadraticForm energy = mean_square_form(design, 3);
    const Eigen::VectorXd scale = design_scales(*model_);
    const double unit = model_->jerk_reference * model_->jerk_reference;
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < energy.matrix.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator e(energy.matrix, column); e; ++e) {
            entries.emplace_back(e.row(), column, scale[e.row()] * scale[column] * e.value() / unit);
        }
    }
    const Eigen::SparseMatrix<double>& equality = projection_->matrix();
    for (int column = 0; column < equality.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator e(equality, column); e; ++e) {
            entries.emplace_back(size + e.row(), column, e.value());
            entries.emplace_back(column, size + e.row(), e.value());
        }
    }
    Eigen::SparseMatrix<double> system(size + rows, size + rows);
    system.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd right(size + rows);
    right << -scale.cwiseProduct(energy.linear) / unit, -projection_->offset();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(grid_->shape().variables());
    if (size > 0) {
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(system);
        const Eigen::VectorXd solution =
            factor.info() == Eigen::Success ? Eigen::VectorXd(factor.solve(right)) : Eigen::VectorXd();
        if (solution.size() > 0 && solution.allFinite()) x.head(size) = solution.head(size);
    }
    return completed(x);
}

Eigen::VectorXd CamProblem::parameter_values(const SplineCurve& curve) const {
    const Peaks peaks = peaks_of(curve);
    const std::array<double, 4> peak = {0.0, peaks.velocity.value, peaks.acceleration.value,
                                        peaks.jerk.value};
    const std::array<double, 4> rms = {0.0, peaks.rms_velocity, peaks.rms_acceleration, peaks.rms_jerk};
    Eigen::VectorXd values(static_cast<Eigen::Index>(model_->parameters.size()));
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        const bool is_peak = parameter.kind == Parameter::Kind::peak;
        values[static_cast<Eigen::Index>(p)] = (is_peak ? peak : rms)[parameter.order] / parameter.reference;
    }
    return values;
}

Eigen::VectorXd CamProblem::completed(const Eigen::VectorXd& x) const {
    Eigen::VectorXd full = x;
    const Eigen::Index size = model_->design.size();
    full.head(size) = projection_->project(x.head(size));
    full.tail(x.size() - size) = parameter_values(curve(full));
    return full;
}

double CamProblem::objective(const Eigen::VectorXd& x) const {
    return grid_->cost(completed(x));
}

std::vector<Violation> CamProblem::violations(const Eigen::VectorXd& x, double slack) const {
    std::vector<Violation> found;
    const SplineCurve spline = curve(x);
    const Eigen::VectorXd q = x.tail(static_cast<Eigen::Index>(model_->parameters.size()));
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) {
        const PointRule& rule = *model_->rules[r];
        const Eigen::VectorXd own = q(rule.parameters());
        const auto along = [&](int segment) { return along_segment(rule, spline, own, segment); };
        for (const Extremum& maximum : local_maxima(spline.space(), along)) {
            const double amount = maximum.value / rule.scale();
            if (amount > -slack) found.push_back({r, maximum, amount, rule.limit()});
        }
    }
    for (int k = 0; k < static_cast<int>(model_->parameter_rows.size()); ++k) {
        const ParameterRow& row = model_->parameter_rows[k];
        double value = -row.upper;
        for (std::size_t i = 0; i < row.parameters.size(); ++i)
            value += row.weights[i] * q[row.parameters[i]];
        const int rule = static_cast<int>(model_->rules.size()) + k;
        if (value / row.scale > -slack)
            found.push_back({rule, {value, spline.begin()}, value / row.scale, row.limit});
    }
    std::ranges::stable_sort(found, std::greater{}, &Violation::amount);
    return found;
}

int CamProblem::refine(std::span<const Violation> worst) {
    const std::size_t before = samples_.size();
    const SplineSpace& space = model_->design.space();
    for (const Violation& violation : worst) {
        if (violation.rule >= static_cast<int>(places_.size()))
            continue;  // rows on parameters are always there
        const double at = violation.where.at;
        const int segment = space.segment_of(at, violation.where.side);
        const auto& places = places_[violation.rule];
        double left = space.breakpoints()[segment];
        double right = space.breakpoints()[segment + 1];
        const auto after = places.lower_bound({segment, at});
        if (after != places.end() && after->first.first == segment) right = after->first.second;
        if (after != places.begin() && std::prev(after)->first.first == segment) {
            left = std::prev(after)->first.second;
        }
        if (!add_sample(violation.rule, at, violation.where.side)) continue;
        if (at - left > 0.0) add_sample(violation.rule, at - bracket * (at - left), Side::right);
        if (right - at > 0.0) add_sample(violation.rule, at + bracket * (right - at), Side::right);
    }
    const int added = static_cast<int>(samples_.size() - before);
    if (added > 0) rebuild();
    return added;
}

Box CamProblem::box(double incumbent, double relaxation) const {
    const CamModel& model = *model_;
    const SplineSpace& space = model.design.space();
    KnownBounds known;
    known.sup.fill(infinity);
    known.rms.fill(infinity);
    known.begin_state = model.design.begin_state();
    known.end_state = model.design.end_state();
    const int parameters = static_cast<int>(model.parameters.size());
    Eigen::VectorXd parameter_bound = Eigen::VectorXd::Constant(parameters, infinity);
    for (int p = 0; p < parameters; ++p) {
        if (model.parameters[p].weight > 0.0) parameter_bound[p] = incumbent / model.parameters[p].weight;
    }
    for (const ParameterRow& row : model.parameter_rows) {  // parameters and weights are not negative
        for (std::size_t k = 0; k < row.parameters.size(); ++k) {
            if (row.weights[k] <= 0.0) continue;
            const double slack = row.limit ? relaxation * row.scale : 0.0;
            double& bound = parameter_bound[row.parameters[k]];
            bound = std::min(bound, (row.upper + slack) / row.weights[k]);
        }
    }
    for (int p = 0; p < parameters; ++p) {
        const Parameter& parameter = model.parameters[p];
        double& bound = (parameter.kind == Parameter::Kind::peak ? known.sup : known.rms)[parameter.order];
        bound = std::min(bound, parameter_bound[p] * parameter.reference);
    }
    const Eigen::MatrixXd bounds = derivative_bounds(space, known);
    Box box;
    box.upper.resize(grid_->shape().variables());
    box.upper.head(model.design.size()) =
        model.design.entry_bounds(bounds).cwiseQuotient(design_scales(model));
    box.lower = -box.upper;
    for (int p = 0; p < parameters; ++p) {
        const Parameter& parameter = model.parameters[p];
        // A peak nothing else bounds may be taken as the curve's own.
        const double own = bounds.row(parameter.order).maxCoeff() / parameter.reference;
        const int variable = model.design.size() + p;
        box.upper[variable] = std::min(parameter_bound[p], own);
        box.lower[variable] = 0.0;
    }
    return box;
}

}  // namespace camopt

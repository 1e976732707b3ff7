// SPDX-License-Identifier: MIT
#include "objectives/grid/cam_problem.hpp"

#include <numeric>

namespace camopt {

namespace {

/// Calls visit(row, column, value) for the lower triangle of a symmetric matrix.
template <typename Visit>
void visit_lower(const Eigen::SparseMatrix<double>& matrix, Visit&& visit) {
    for (int column = 0; column < matrix.outerSize(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry) {
            if (entry.row() >= column) visit(static_cast<int>(entry.row()), column, entry.value());
        }
    }
}

/// Of a root mean square: the form in the optimizer's units, divided by reference².
QuadraticForm scaled_form(const CamModel& model, const Parameter& parameter) {
    const bool energy = parameter.kind == Parameter::Kind::energy;
    QuadraticForm form =
        energy ? parameter.defined_by->whole()->form(model.family_of(parameter.seen)).value()
               : model.design.mean_square(parameter.order, model.mean_square_weights(parameter.order));
    const double factor = 1.0 / (parameter.reference * parameter.reference);
    form.scale(energy ? 1.0 : factor, design_scales(model));
    return form;
}

}  // namespace

double variable_scale(const CamModel& model, int index) {
    const int design_size = model.design.size();
    if (index >= design_size) return model.parameters[index - design_size].reference;
    const double factor = model.entry_factors.empty() ? 1.0 : model.entry_factors[index];
    return factor * model.entry_scale[model.design.order(index)];
}

Eigen::VectorXd design_scales(const CamModel& model) {
    Eigen::VectorXd scales(model.design.size());
    for (int j = 0; j < scales.size(); ++j) scales[j] = variable_scale(model, j);
    return scales;
}

GridNlp::GridNlp(std::shared_ptr<const CamModel> model, std::vector<RuleSample> samples)
    : model_(std::move(model)),
      samples_(std::move(samples)),
      scale_(design_scales(*model_)),
      affine_(model_->rules.size() + 1) {
    const int variables = design_size() + static_cast<int>(model_->parameters.size());
    shape_.x_lower = Eigen::VectorXd::Constant(variables, -infinity);
    shape_.x_upper = Eigen::VectorXd::Constant(variables, infinity);
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        const int variable = design_size() + static_cast<int>(p);
        const bool rms = parameter.kind == Parameter::Kind::rms || parameter.kind == Parameter::Kind::energy;
        shape_.x_lower[variable] = rms ? least_rms : parameter.lower;
        shape_.x_upper[variable] = parameter.upper;
    }
    shape_.convex = true;
    add_cost_terms();
    claim_cost();
    add_fixed_rows();
    add_sample_rows(0);
}

void GridNlp::append(std::span<const RuleSample> samples) {
    const auto first = static_cast<int>(samples_.size());
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    add_sample_rows(first);
}

void GridNlp::add_fixed_rows() {
    const CamModel& model = *model_;
    std::vector<double> lower;
    std::vector<double> upper;
    for (const Equality& equality : model.design.equalities()) {
        AffineRow unit = unit_row(equality.row, scale_);
        Row row{std::move(unit.columns), std::move(unit.weights), unit.offset, -1, {}};
        rows_.push_back(std::move(row));
        lower.push_back(0.0);
        upper.push_back(0.0);
        shape_.rows.push_back({true, false, 1.0, 0.0, equality.uncertainty});
    }
    for (const ParameterRow& source : model.parameter_rows) {
        Row row;
        for (std::size_t k = 0; k < source.parameters.size(); ++k) {
            row.columns.push_back(design_size() + source.parameters[k]);
            row.weights.push_back(source.weights[k]);
        }
        rows_.push_back(std::move(row));
        lower.push_back(-infinity);
        upper.push_back(source.upper);
        shape_.rows.push_back({true, source.limit, source.scale});
    }
    first_sample_row_ = static_cast<int>(rows_.size());
    shape_.g_lower = Eigen::Map<Eigen::VectorXd>(lower.data(), static_cast<Eigen::Index>(lower.size()));
    shape_.g_upper = Eigen::Map<Eigen::VectorXd>(upper.data(), static_cast<Eigen::Index>(upper.size()));
    claim_rows(0);
}

void GridNlp::add_sample_rows(int first) {
    const CamModel& model = *model_;
    const auto samples = static_cast<int>(samples_.size());
    const auto first_row = static_cast<int>(rows_.size());
    const Eigen::Index rows = first_row + samples - first;
    rows_.reserve(static_cast<std::size_t>(rows));
    shape_.rows.reserve(static_cast<std::size_t>(rows));
    for (int k = first; k < samples; ++k) {
        add_sample_row(k);
        const PlacedRule& placed = model.rules[samples_[k].rule];
        const PointRule& rule = *placed;
        const auto [least, most] = model.expected_range(placed);
        shape_.convex = shape_.convex && rule.curvature(least, most) != Curvature::general;
        const double unit = rule.linear() && !rule.whole() ? unit_of(samples_[k]) : 1.0;
        shape_.rows.push_back({rule.linear(), rule.limit(), rule.scale(), unit * rule.rounding()});
    }
    shape_.g_lower.conservativeResize(rows);
    shape_.g_upper.conservativeResize(rows);
    shape_.g_lower.tail(samples - first).setConstant(-infinity);
    shape_.g_upper.tail(samples - first).setZero();
    claim_rows(first_row);
}

void GridNlp::add_sample_row(int sample) {
    const PointRule& rule = *model_->rules[samples_[sample].rule];
    if (rule.linear())
        add_linear_row(sample);
    else if (rule.whole())
        add_energy_row(sample);
    else
        add_curved_row(sample);
}

void GridNlp::add_energy_row(int sample) {
    const PlacedRule& rule = model_->rules[samples_[sample].rule];
    QuadraticForm form = rule->whole()->form(model_->family_of(rule)).value();
    form.scale(1.0, scale_);
    Row row;
    row.sample = sample;
    row.columns.resize(static_cast<std::size_t>(design_size()));
    std::iota(row.columns.begin(), row.columns.end(), 0);
    row.form = std::make_shared<const QuadraticForm>(std::move(form));
    rows_.push_back(std::move(row));
}

/// A linear rule's value and slopes where everything is 0.
const RuleValue& GridNlp::affine_rule(const RuleSample& place) {
    const PointRule& rule = *model_->rules[place.rule];
    const bool same_everywhere = rule.places().empty();
    std::optional<RuleValue>& known = same_everywhere ? affine_[place.rule] : affine_.back();
    if (!same_everywhere || !known)
        known = rule.evaluate({place.at, {}},
                              Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rule.parameters().size())));
    return *known;
}

/// Multiplied out, with only the derivatives and entries that occur in the rule.
AffineRow GridNlp::linear_rule_row(const RuleSample& place, const RuleValue& affine) const {
    const PlacedRule& rule = model_->rules[place.rule];
    AffineRow sum{affine.value, {}, {}};
    for (int order = 0; order < 4; ++order) {
        const double factor = affine.gradient[order];
        if (factor == 0.0) continue;
        AffineRow derivative = model_->family_of(rule).functional(place.at, order, place.side);
        for (double& weight : derivative.weights) weight *= factor;
        derivative.offset *= factor;
        sum = sum.columns.empty() ? AffineRow{sum.offset + derivative.offset, std::move(derivative.columns),
                                              std::move(derivative.weights)}
                                  : combined(sum, 1.0, derivative);
    }
    if (rule.datum == PlacedRule::Datum::zero || affine.gradient[0] == 0.0) return sum;
    const auto& stretch = model_->design.stretches()[rule.stretch];
    return combined(sum, -affine.gradient[0],
                    rule.datum == PlacedRule::Datum::begin ? stretch.from : stretch.to);
}

/// Rows are scaled by the weight of their violations: a backend has one tolerance.
double GridNlp::unit_of(const RuleSample& place) const {
    const PointRule& rule = *model_->rules[place.rule];
    return rule.scale() / rule.scale_at(place.at);
}

void GridNlp::add_linear_row(int sample) {
    const RuleSample& place = samples_[sample];
    const PlacedRule& placed = model_->rules[place.rule];
    const PointRule& rule = *placed;
    const WholeMotionRule* const whole = rule.whole();
    const RuleValue* const affine = whole ? nullptr : &affine_rule(place);
    const AffineRow sum = whole ? whole->row(model_->family_of(placed), place.at, place.side, place.setting)
                                : linear_rule_row(place, *affine);
    const double unit = whole ? 1.0 : unit_of(place);
    Row row;
    row.offset = unit * sum.offset;
    const std::size_t entries = sum.columns.size() + rule.parameters().size();
    row.columns.reserve(entries);
    row.weights.reserve(entries);
    for (std::size_t k = 0; k < sum.columns.size(); ++k) {
        if (sum.weights[k] == 0.0) continue;
        row.columns.push_back(sum.columns[k]);
        row.weights.push_back(unit * sum.weights[k] * scale_[sum.columns[k]]);
    }
    for (std::size_t k = 0; k < rule.parameters().size(); ++k) {
        row.columns.push_back(design_size() + rule.parameters()[k]);
        // Rules of the whole motion are f − q.
        row.weights.push_back(whole ? -1.0 : unit * affine->gradient[4 + static_cast<Eigen::Index>(k)]);
    }
    rows_.push_back(std::move(row));
}

void GridNlp::add_curved_row(int sample) {
    const RuleSample& place = samples_[sample];
    Row row;
    row.sample = sample;
    const MotionFamily& family = model_->family_of(model_->rules[place.rule]);
    for (int order = 0; order < 4; ++order) {
        const AffineRow derivative = family.functional(place.at, order, place.side);
        if (order == 0) {
            row.columns = derivative.columns;
            row.map = Eigen::MatrixXd::Zero(4, static_cast<Eigen::Index>(derivative.columns.size()));
        }
        for (std::size_t k = 0; k < derivative.columns.size(); ++k) {
            row.map(order, static_cast<Eigen::Index>(k)) =
                derivative.weights[k] * scale_[derivative.columns[k]];
        }
        row.map_offset[order] = derivative.offset;
    }
    for (const int parameter : model_->rules[place.rule]->parameters())
        row.columns.push_back(design_size() + parameter);
    rows_.push_back(std::move(row));
}

void GridNlp::add_cost_terms() {
    linear_cost_ = Eigen::VectorXd::Zero(shape_.variables());
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        const int variable = design_size() + static_cast<int>(p);
        if (parameter.kind == Parameter::Kind::rms || parameter.kind == Parameter::Kind::energy)
            rms_.push_back({variable, parameter.weight, scaled_form(*model_, parameter)});
    }
    follow_weights();
    shape_.linear_cost = rms_.empty();
    shape_.quadratic_cost = rms_.empty();
}

void GridNlp::follow_weights() {
    const auto weight = [&](int variable) { return model_->parameters[variable - design_size()].weight; };
    for (int variable = design_size(); variable < shape_.variables(); ++variable)
        linear_cost_[variable] = weight(variable);
    for (RmsTerm& term : rms_) {
        term.weight = weight(term.variable);
        linear_cost_[term.variable] = 0.0;
    }
}

void GridNlp::follow_uppers() {
    std::size_t row = model_->design.equalities().size();
    for (const ParameterRow& source : model_->parameter_rows) {
        shape_.g_upper[static_cast<Eigen::Index>(row)] = source.upper;
        shape_.rows[row++].scale = source.scale;
    }
}

void GridNlp::claim_cost() {
    const auto claim = [&](int row, int column) { hessian_slots_.claim(shape_.hessian, row, column); };
    for (const RmsTerm& term : rms_) {
        visit_lower(term.form.matrix, [&](int row, int column, double) { claim(row, column); });
        for (int j = 0; j < design_size(); ++j) claim(term.variable, j);
        claim(term.variable, term.variable);
    }
}

/// Of the rows from `first` on.
void GridNlp::claim_rows(int first) {
    for (auto i = static_cast<std::size_t>(first); i < rows_.size(); ++i) {
        const std::vector<int>& columns = rows_[i].columns;
        shape_.jacobian.rows.insert(shape_.jacobian.rows.end(), columns.size(), static_cast<int>(i));
        shape_.jacobian.columns.insert(shape_.jacobian.columns.end(), columns.begin(), columns.end());
        if (rows_[i].sample < 0) continue;
        if (rows_[i].form) {
            visit_lower(rows_[i].form->matrix, [&](int row, int column, double) {
                hessian_slots_.claim(shape_.hessian, row, column);
            });
            continue;
        }
        for (std::size_t a = 0; a < columns.size(); ++a)
            for (std::size_t b = 0; b <= a; ++b) hessian_slots_.claim(shape_.hessian, columns[a], columns[b]);
    }
}

double GridNlp::cost(const ConstVectorRef& x) const {
    double value = model_->cost_constant + linear_cost_.dot(x);
    const auto design = x.head(design_size());
    for (const RmsTerm& term : rms_) {
        value += 0.5 * term.weight * (term.form.value(design) / x[term.variable] + x[term.variable]);
    }
    return value;
}

void GridNlp::gradient(const ConstVectorRef& x, VectorRef out) const {
    out = linear_cost_;
    if (rms_.empty()) return;
    const Eigen::VectorXd design = x.head(design_size());
    for (const RmsTerm& term : rms_) {
        const double q = x[term.variable];
        out.head(design_size()) += term.weight / q * term.form.slope(design);
        out[term.variable] += 0.5 * term.weight * (1.0 - term.form.value(design) / (q * q));
    }
}

const RuleValue& GridNlp::rule_value(const Row& row, const ConstVectorRef& x) const {
    const RuleSample& place = samples_[row.sample];
    const Eigen::Index local = row.map.cols();
    const auto parameters = static_cast<Eigen::Index>(row.columns.size()) - local;
    Eigen::VectorXd entries(local);
    for (Eigen::Index k = 0; k < local; ++k) entries[k] = x[row.columns[k]];
    Eigen::VectorXd point(4 + parameters);
    point.head<4>() = row.map_offset + row.map * entries;
    for (Eigen::Index k = 0; k < parameters; ++k) point[4 + k] = x[row.columns[local + k]];
    if (point.size() == row.last_point.size() && point == row.last_point) return row.last;
    row.last = model_->rules[place.rule]->evaluate({place.at, {point[0], point[1], point[2], point[3]}},
                                                   point.tail(parameters));
    row.last_point = std::move(point);
    return row.last;
}

void GridNlp::constraints(const ConstVectorRef& x, VectorRef out) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        if (row.sample >= 0) {
            out[static_cast<Eigen::Index>(i)] =
                row.form ? 0.5 * (row.form->value(x.head(design_size())) - 1.0) : rule_value(row, x).value;
            continue;
        }
        double value = row.offset;
        for (std::size_t k = 0; k < row.columns.size(); ++k) value += row.weights[k] * x[row.columns[k]];
        out[static_cast<Eigen::Index>(i)] = value;
    }
}

void GridNlp::jacobian(const ConstVectorRef& x, std::span<double> out) const {
    auto next = out.begin();
    for (const Row& row : rows_) {
        if (row.sample < 0) {
            next = std::ranges::copy(row.weights, next).out;
            continue;
        }
        if (row.form) {
            const Eigen::VectorXd slope = row.form->slope(x.head(design_size()));
            next = std::ranges::copy(slope, next).out;
            continue;
        }
        const Eigen::VectorXd& partials = rule_value(row, x).gradient;
        const Eigen::VectorXd by_entry = row.map.transpose() * partials.head<4>();
        next = std::ranges::copy(by_entry, next).out;
        for (Eigen::Index k = 4; k < partials.size(); ++k) *next++ = partials[k];
    }
}

void GridNlp::hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                      std::span<double> out) const {
    std::ranges::fill(out, 0.0);
    auto add = hessian_slots_.into(out);
    const Eigen::VectorXd design = x.head(design_size());
    for (const RmsTerm& term : rms_) {
        const double q = x[term.variable];
        const double factor = sigma * term.weight / q;
        visit_lower(term.form.matrix, [&](int, int, double value) { add(factor * value); });
        const Eigen::VectorXd slope = term.form.slope(design);
        for (int j = 0; j < design_size(); ++j) add(-factor / q * slope[j]);
        add(factor / (q * q) * term.form.value(design));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        if (row.sample < 0) continue;
        const double multiplier = lambda[static_cast<Eigen::Index>(i)];
        if (row.form) {
            visit_lower(row.form->matrix, [&](int, int, double value) { add(multiplier * value); });
            continue;
        }
        const auto columns = static_cast<Eigen::Index>(row.columns.size());
        if (multiplier == 0.0) {  // an inactive row: nothing to evaluate
            add.skip(columns * (columns + 1) / 2);
            continue;
        }
        // (y … y''', q) as a linear map of the row's columns: B on top of the identity.
        const Eigen::Index local = row.map.cols();
        const Eigen::Index parameters = columns - local;
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(4 + parameters, local + parameters);
        full.topLeftCorner(4, local) = row.map;
        full.bottomRightCorner(parameters, parameters).setIdentity();
        const Eigen::MatrixXd curved = multiplier * full.transpose() * rule_value(row, x).hessian * full;
        for (Eigen::Index a = 0; a < curved.rows(); ++a) {
            for (Eigen::Index b = 0; b <= a; ++b) add(curved(a, b));
        }
    }
}

std::string GridNlp::variable_name(int index) const {
    return index < design_size() ? model_->design.name(index)
                                 : model_->parameters[index - design_size()].name;
}

RowOrigin GridNlp::row_origin(int index) const {
    RowOrigin origin;
    origin.limit = shape_.rows[index].limit;
    const int equalities = static_cast<int>(model_->design.equalities().size());
    if (index >= first_sample_row_) {
        const RuleSample& place = samples_[index - first_sample_row_];
        origin = model_->rules[place.rule]->origin();
        origin.at = place.at;
        origin.side = place.side;
        if (const WholeMotionRule* const whole = model_->rules[place.rule]->whole()) {
            origin.remark = whole->remark(place.setting);
            origin.fields.which = whole->which(place.setting);
        }
    } else if (index < equalities) {
        origin.rule = model_->design.equalities()[index].name;
    } else {
        origin.rule = model_->parameter_rows[index - equalities].name;
    }
    return origin;
}

}  // namespace camopt

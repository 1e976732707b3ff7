// SPDX-License-Identifier: MIT
#include "objectives/grid/cam_problem.hpp"

#include "objectives/rules/maxima/rule_maxima.hpp"

namespace camopt {

namespace {

/// Assumed degree of a rule along a spline piece for the first grid: curved ones count as high.
int degree_along(const PointRule& rule, int spline_degree) {
    return rule.linear() ? spline_degree - rule.highest_order() : spline_degree;
}

}  // namespace

CamProblem::CamProblem(CamModel model) : CamProblem(std::move(model), {}) {}

CamProblem::CamProblem(CamModel model, const std::vector<RuleSample>& samples)
    : model_(std::make_shared<CamModel>(std::move(model))),
      places_(model_->rules.size()),
      scales_(design_scales(*model_)) {
    projection_ = std::make_unique<EqualityProjection>(model_->design.equalities(), scales_);
    start_grid();
    for (const RuleSample& sample : samples)
        sample.setting.empty() ? add_sample(sample.rule, sample.at, sample.side) : add_whole_sample(sample);
    grid_ = std::make_unique<GridNlp>(model_, samples_);
    on_grid_ = samples_.size();
}

void CamProblem::start_grid() {
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) start_rule(r);
}

void CamProblem::start_rule(int index) {
    const PlacedRule& rule = model_->rules[index];
    if (const WholeMotionRule* const whole = rule->whole()) {
        for (const WholeMotionRule::Place& place : whole->first())
            add_whole_sample({index, place.where.at, place.where.side, place.setting});
        return;
    }
    if (rule->starts_without_rows()) return;
    const MotionFamily& family = model_->family_of(rule);
    const int order = rule->highest_order();
    for (const double x : rule->places()) add_sample(index, x, x < family.end() ? Side::right : Side::left);
    if (!rule->places().empty()) return;
    for (const double x : {rule.from, rule.until})
        if (x > family.begin() && x < family.end()) add_sample(index, x, Side::right);
    int last_stretch = -1;
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (!rule.holds_on(piece)) continue;
        const bool first = piece.stretch != last_stretch;
        last_stretch = piece.stretch;
        const MotionFamily::Stretch& stretch = family.stretches()[piece.stretch];
        if (stretch.kind == StretchRequest::Kind::spline) {
            const SplineSpace& space = family.run_space(stretch.run);
            const int degree = degree_along(*rule, space.degree());
            const bool jumps = order > space.continuity();
            if (degree >= 1 || jumps) {
                if (first || jumps) add_sample(index, piece.begin, Side::right);
                if (degree >= 1) add_sample(index, piece.end, Side::left);
            }
            if (degree >= 2) add_sample(index, 0.5 * (piece.begin + piece.end), Side::right);
            continue;
        }
        // If the motion is fixed, only the cam's dimensions can change the rule.
        if (rule->parameters().empty() && stretch.from.columns.empty() && stretch.to.columns.empty())
            continue;
        const bool dwell = stretch.kind == StretchRequest::Kind::dwell;
        const int parts = dwell ? 1 : 4;
        for (int k = 0; k < parts; ++k) {
            add_sample(index, piece.begin + (k + 0.5) / parts * (piece.end - piece.begin), Side::right);
        }
    }
}

bool CamProblem::add_sample(int rule, double at, Side side) {
    const PlacedRule& placed = model_->rules[rule];
    if (!placed.holds_at(at) || placed->scale_at(at) == 0.0) return false;
    const int index = model_->design.piece_of(at, side);
    const MotionFamily::Piece& piece = model_->design.pieces()[index];
    const double tolerance = same_sample * (piece.end - piece.begin);
    auto& places = places_[rule];
    const auto next = places.lower_bound({index, at - tolerance});
    if (next != places.end() && next->first.first == index && next->first.second <= at + tolerance) {
        return false;
    }
    places.emplace(std::pair{index, at}, static_cast<int>(samples_.size()));
    samples_.push_back({rule, at, side});
    return true;
}

bool CamProblem::add_whole_sample(const RuleSample& sample) {
    constexpr double same = 1e-9;
    const auto close = [](double a, double b) {
        return std::abs(a - b) <= same * std::max(1.0, std::abs(a));
    };
    for (const RuleSample& known : samples_)
        if (known.rule == sample.rule && close(known.at, sample.at) &&
            std::ranges::equal(known.setting, sample.setting, close))
            return false;
    samples_.push_back(sample);
    return true;
}

/// The row of a rule of the whole motion; the first at a setting adds its companion rows.
void CamProblem::refine_whole(const Violation& violation) {
    const WholeMotionRule& rule = *model_->rules[violation.rule]->whole();
    const RuleSample sample{violation.rule, violation.where.at, violation.where.side, violation.setting};
    if (!add_whole_sample(sample)) return;
    for (std::vector<double>& setting : rule.beside(sample.setting))
        add_whole_sample({sample.rule, sample.at, sample.side, std::move(setting)});
}

/// Adds the rows of new samples; returns their number.
int CamProblem::append_rows() {
    const std::span<const RuleSample> fresh = std::span(samples_).subspan(on_grid_);
    if (!fresh.empty()) grid_->append(fresh);
    on_grid_ = samples_.size();
    return static_cast<int>(fresh.size());
}

void CamProblem::set_weights(std::span<const double> weights) {
    for (std::size_t p = 0; p < weights.size(); ++p) model_->parameters[p].weight = weights[p];
    grid_->follow_weights();
}

void CamProblem::set_uppers(std::span<const double> uppers) {
    for (std::size_t k = 0; k < uppers.size(); ++k) {
        ParameterRow& row = model_->parameter_rows[k];
        row.upper = uppers[k];
        if (row.limit) row.scale = row.upper;
    }
    grid_->follow_uppers();
}

double CamProblem::objective(const Eigen::VectorXd& x) const {
    return grid_->cost(completed(x));
}

double CamProblem::worst_of_limits(const Eigen::VectorXd& x) const {
    const auto limits = [](const auto& rows) {
        return std::ranges::any_of(rows, [](const auto& row) { return row.limit; });
    };
    const bool any = limits(model_->parameter_rows) ||
                     std::ranges::any_of(model_->rules, [](const PlacedRule& rule) { return rule->limit(); });
    double worst = -1.0;
    if (!any) return worst;
    for (const Violation& violation : violations_of(true, x, 1.0))
        if (violation.limit) worst = std::max(worst, violation.amount);
    return worst;
}

std::vector<Violation> CamProblem::violations_of(bool limits_only, const Eigen::VectorXd& x,
                                                 double slack) const {
    std::vector<Violation> found;
    const MotionChain chain = motion(x);
    std::map<SeenMotion, MotionChain> others;  // where rules see another one
    for (const PlacedRule& rule : model_->rules)
        if (model_->sees_other(rule) && !others.contains(rule.seen))
            others.emplace(rule.seen, motion(x, rule.seen));
    const Eigen::VectorXd q = x.tail(static_cast<Eigen::Index>(model_->parameters.size()));
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) {
        const PlacedRule& rule = model_->rules[r];
        if (limits_only && !rule->limit()) continue;
        const MotionChain& own = model_->sees_other(rule) ? others.at(rule.seen) : chain;
        if (const WholeMotionRule* const whole = rule->whole()) {
            for (WholeMotionRule::Place& place : whole->maxima(own, own_parameters(r, x)))
                if (const double amount = place.where.value / rule->scale(); amount > -slack)
                    found.push_back({r, place.where, amount, rule->limit(), std::move(place.setting)});
            continue;
        }
        for (const Extremum& maximum :
             rule_maxima(rule, model_->family_of(rule), own, own_parameters(r, x))) {
            // Undefined (an arm that cannot reach) counts as an infinite violation.
            const double scale = rule->scale_at(maximum.at);
            if (scale == 0.0) continue;
            const double value = maximum.value - rule->rounding();
            const double amount = std::isfinite(value) ? value / scale : infinity;
            if (amount > -slack) found.push_back({r, maximum, amount, rule->limit()});
        }
    }
    for (int k = 0; k < static_cast<int>(model_->parameter_rows.size()); ++k) {
        const ParameterRow& row = model_->parameter_rows[k];
        double value = -row.upper;
        for (std::size_t i = 0; i < row.parameters.size(); ++i)
            value += row.weights[i] * q[row.parameters[i]];
        const int rule = static_cast<int>(model_->rules.size()) + k;
        if (value / row.scale > -slack)
            found.push_back({rule, {value, model_->design.begin()}, value / row.scale, row.limit});
    }
    std::ranges::stable_sort(found, std::greater{}, &Violation::amount);
    return found;
}

/// A row at a maximum, and one on either side of it towards the nearest samples.
void CamProblem::add_around(const Violation& violation) {
    const MotionFamily& family = model_->design;
    const double at = violation.where.at;
    const int piece = family.piece_of(at, violation.where.side);
    const auto& places = places_[violation.rule];
    double left = family.pieces()[piece].begin;
    double right = family.pieces()[piece].end;
    const auto after = places.lower_bound({piece, at});
    if (after != places.end() && after->first.first == piece) right = after->first.second;
    if (after != places.begin() && std::prev(after)->first.first == piece)
        left = std::prev(after)->first.second;
    if (!add_sample(violation.rule, at, violation.where.side)) return;
    if (at - left > 0.0) add_sample(violation.rule, at - bracket * (at - left), Side::right);
    if (right - at > 0.0) add_sample(violation.rule, at + bracket * (right - at), Side::right);
}

/// Predicted location of a maximum from the active rows around it.
struct CamProblem::Pressed {
    double at = 0.0;     ///< the mean of the rows on either side, weighted by their multipliers
    double reach = 0.0;  ///< uncertainty of the location
};

/// Of the nearest rows on either side of a maximum, including those at the ends of its piece. At the
/// continuous optimum one row is active instead of the two: it is their weighted mean up to the curvature
/// between them, which is of second order in their distance.
std::optional<CamProblem::Pressed> CamProblem::pressed_around(const Violation& violation,
                                                              const Eigen::VectorXd& row_multipliers) const {
    const double at = violation.where.at;
    const int index = model_->design.piece_of(at, violation.where.side);
    const MotionFamily::Piece& piece = model_->design.pieces()[index];
    const double width = piece.end - piece.begin;
    const auto& places = places_[violation.rule];
    const auto touches = [&](double x) {
        return x >= piece.begin - same_sample * width && x <= piece.end + same_sample * width;
    };
    const auto after = places.lower_bound({index, at});
    if (after == places.end() || after == places.begin()) return {};
    const auto before = std::prev(after);
    const double left = before->first.second, right = after->first.second;
    if (!touches(left) || !touches(right) || !(right > left)) return {};
    const auto multiplier = [&](int sample) {
        return std::max(0.0, row_multipliers[grid_->first_sample_row() + sample]);
    };
    const double of_left = multiplier(before->second), of_right = multiplier(after->second);
    const double larger = std::max(of_left, of_right), smaller = std::min(of_left, of_right);
    if (!(larger >
          idle_row * row_multipliers.tail(static_cast<Eigen::Index>(on_grid_)).lpNorm<Eigen::Infinity>()))
        return {};
    const double distance = (right - left) / width;
    const bool both = smaller > idle_row * larger;
    const double reach = both ? std::max(closest_pair, pair_reach * distance * distance) : closest_pair;
    return Pressed{(of_left * left + of_right * right) / (of_left + of_right), reach * width};
}

void CamProblem::add_pressed(const Violation& violation, const Pressed& pressed) {
    const MotionFamily& family = model_->design;
    const int index = family.piece_of(violation.where.at, violation.where.side);
    const MotionFamily::Piece& piece = family.pieces()[index];
    const double apart = too_close * (piece.end - piece.begin);
    const auto& places = places_[violation.rule];
    for (const double x : {pressed.at, pressed.at - pressed.reach, pressed.at + pressed.reach}) {
        if (x < piece.begin + apart || x > piece.end - apart) continue;
        const auto next = places.lower_bound({index, x - apart});
        const bool taken =
            next != places.end() && next->first.first == index && next->first.second <= x + apart;
        if (!taken) add_sample(violation.rule, x, Side::right);
    }
}

void CamProblem::add_samples(std::span<const Violation> worst) {
    for (const Violation& violation : worst) {
        if (violation.rule >= static_cast<int>(places_.size()))
            continue;  // rows on parameters are always present
        violation.setting.empty() ? add_around(violation) : refine_whole(violation);
    }
}

int CamProblem::refine(std::span<const Violation> worst) {
    add_samples(worst);
    return append_rows();
}

int CamProblem::refine_pressed(std::span<const Violation> worst, const Eigen::VectorXd& row_multipliers) {
    std::vector<std::optional<Pressed>> pressed(worst.size());  // before other rows are inserted
    for (std::size_t k = 0; k < worst.size(); ++k) {
        const bool of_places = worst[k].rule < static_cast<int>(places_.size()) && worst[k].setting.empty();
        if (of_places && grid_->shape().convex) pressed[k] = pressed_around(worst[k], row_multipliers);
    }
    add_samples(worst);
    for (std::size_t k = 0; k < worst.size(); ++k)
        if (pressed[k]) add_pressed(worst[k], *pressed[k]);
    return append_rows();
}

}  // namespace camopt

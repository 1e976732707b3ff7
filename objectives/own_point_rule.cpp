// SPDX-License-Identifier: MIT
#include "objectives/own_point_rule.hpp"

#include "objectives/rules/maxima/rule_maxima.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

namespace camopt {
namespace {

// A Hessian contradicts convexity if an eigenvalue is below 0 by more than this part of the largest.
constexpr double curvature_rounding = 1e-9;

bool has_values(const FormulaValue& found) {
    return found.gradient.allFinite() && found.hessian.allFinite() && std::isfinite(found.by_x);
}

std::string place_text(const MotionPoint& point) {
    const auto& at = point.derivative;
    return fmt::format("x = {:.6g}, (y, y', y'', y''') = ({:.6g}, {:.6g}, {:.6g}, {:.6g})", point.x, at[0],
                       at[1], at[2], at[3]);
}

}  // namespace

OwnPointRule::OwnPointRule(const OwnTerm& term, int parameter)
    : PointRule({term.name, term.highest_order, false, term.shape == Curvature::linear, {parameter}}),
      formula_(term.formula),
      shape_(term.shape),
      size_(term.reference) {}

OwnPointRule::OwnPointRule(const OwnLimit& limit)
    : PointRule({limit.key(), limit.highest_order, true, limit.shape == Curvature::linear}),
      formula_(limit.formula),
      shape_(limit.shape),
      level_(limit.limit),
      size_(limit.scale()) {}

void OwnPointRule::check_shape(const MotionPoint& point, const FormulaValue& found) const {
    if (shape_ == Curvature::general) return;
    const double largest = found.hessian.cwiseAbs().maxCoeff();
    if (largest == 0.0) return;
    if (shape_ == Curvature::linear)
        throw ModelError(
            fmt::format("{}: declared linear, but its Hessian is not 0 at {}", name(), place_text(point)));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(found.hessian, Eigen::EigenvaluesOnly);
    const double least = eigen.eigenvalues().minCoeff();
    if (least < -curvature_rounding * largest)
        throw ModelError(fmt::format("{}: declared convex, but its Hessian has the eigenvalue {:.6g} at {}",
                                     name(), least, place_text(point)));
}

RuleValue OwnPointRule::evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const {
    const FormulaValue found = formula_(point);
    if (std::isfinite(found.value) && !has_values(found))
        throw ModelError(fmt::format("{}: the partials have no value at {}", name(), place_text(point)));
    check_shape(point, found);
    const Eigen::Index variables = 4 + static_cast<Eigen::Index>(parameters().size());
    RuleValue result{(found.value - level_) / size_, Eigen::VectorXd::Zero(variables),
                     Eigen::MatrixXd::Zero(variables, variables), found.by_x / size_};
    result.gradient.head<4>() = found.gradient / size_;
    result.hessian.topLeftCorner<4, 4>() = found.hessian / size_;
    if (limit()) return result;
    result.value -= q[0];
    result.gradient[4] = -1.0;
    return result;
}

void add_own_rules(CamModel& model, const Scene& scene) {
    for (const OwnTerm& term : scene.own_terms) {
        const int index = static_cast<int>(model.parameters.size());
        const auto rule = std::make_shared<const OwnPointRule>(term, index);
        Parameter peak{term.name, Parameter::Kind::own, 0, term.reference, term.weight};
        peak.defined_by = rule;
        model.parameters.push_back(std::move(peak));
        model.rules.emplace_back(rule);
    }
    for (const OwnLimit& limit : scene.own_limits)
        model.rules.emplace_back(std::make_shared<const OwnPointRule>(limit));
}

Extremum largest_of_own(const OwnTerm& term, const Motion& motion) {
    const std::vector<Extremum> maxima = rule_maxima(OwnPointRule(term, 0), motion, Eigen::VectorXd::Zero(1));
    Extremum largest = largest_of(maxima);
    // Of equal peaks the first, as of those of the motion.
    const auto first = std::ranges::find_if(maxima, [&](const Extremum& one) {
        return one.value >= largest.value - same_peak * std::abs(largest.value);
    });
    if (first != maxima.end()) largest = {largest.value, first->at, first->side};  // else: undefined
    largest.value = std::max(0.0, term.reference * largest.value);
    return largest;
}

Extremum largest_of_own(const OwnLimit& limit, const Motion& motion) {
    Extremum largest = largest_of(rule_maxima(OwnPointRule(limit), motion, Eigen::VectorXd()));
    largest.value = limit.limit + limit.scale() * largest.value;
    return largest;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Completion: from any x to one whose equalities hold and whose peaks are those of its motion.
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "objectives/rules/whole_motion_rule.hpp"
#include "splines/extrema.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

bool has_kind(const CamModel& model, Parameter::Kind kind) {
    return std::ranges::any_of(model.parameters,
                               [kind](const Parameter& parameter) { return parameter.kind == kind; });
}

}  // namespace

/// The peaks of DRD and RR, whose normalised motion is the spline itself.
void CamProblem::complete_peaks(const SplineCurve& curve, Eigen::VectorXd& x) const {
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[model_->design.size() + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::peak)
            value = peak_of(curve, parameter.order).value / parameter.reference;
        if (parameter.kind == Parameter::Kind::torque)
            value = torque_peak_of(curve).value / parameter.reference;
        if (parameter.kind == Parameter::Kind::rms)
            value = mean_of(curve, parameter.order) / parameter.reference;
    }
}

/// The normalised peaks of a program: each the largest over its stretches, by the rules that define it.
void CamProblem::complete_program_peaks(const MotionChain& chain, Eigen::VectorXd& x) const {
    const Eigen::Index size = model_->design.size();
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[size + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::peak || parameter.kind == Parameter::Kind::torque) value = 0.0;
        if (parameter.kind != Parameter::Kind::rms) continue;
        const QuadraticForm form =
            model_->design.mean_square(parameter.order, model_->mean_square_weights(parameter.order));
        value = std::sqrt(std::max(0.0, form.value(design_values(x)))) / parameter.reference;
    }
    for (const PlacedRule& rule : model_->rules) {
        if (rule->limit() || rule->parameters().empty() || rule->whole()) continue;
        const auto first = static_cast<std::size_t>(rule->parameters().front());
        if (model_->parameters[first].kind == Parameter::Kind::own) continue;
        double& peak = x[size + rule->parameters().front()];
        peak = std::max(peak,
                        largest_of(rule_maxima(rule, model_->design, chain, Eigen::VectorXd::Zero(1))).value);
    }
}

/// The peaks of user-defined terms.
void CamProblem::complete_own_peaks(const MotionChain& chain, Eigen::VectorXd& x) const {
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::own) continue;
        const PlacedRule rule(parameter.defined_by);
        const Extremum largest =
            largest_of(rule_maxima(rule, model_->design, chain, Eigen::VectorXd::Zero(1)));
        x[model_->design.size() + static_cast<Eigen::Index>(p)] = std::max(0.0, largest.value);
    }
}

/// The response of the follower train to the motion.
void CamProblem::complete_responses(const MotionChain& chain, Eigen::VectorXd& x) const {
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        if (parameter.kind != Parameter::Kind::response) continue;
        double largest = 0.0;
        for (const auto& place : parameter.defined_by->whole()->maxima(chain, Eigen::VectorXd::Zero(1)))
            largest = std::max(largest, place.where.value);
        x[model_->design.size() + static_cast<Eigen::Index>(p)] = largest;
    }
}

/// Peaks and root mean squares are set to those of the motion of x; dimensions are clamped to their range.
void CamProblem::complete_parameters(Eigen::VectorXd& x) const {
    if (model_->stretch_scales.empty())
        complete_peaks(curve(x), x);
    else
        complete_program_peaks(motion(x), x);
    if (has_kind(*model_, Parameter::Kind::own)) complete_own_peaks(motion(x), x);
    if (has_kind(*model_, Parameter::Kind::response)) complete_responses(motion(x), x);
    const Eigen::Index size = model_->design.size();
    for (std::size_t p = 0; p < model_->parameters.size(); ++p) {
        const Parameter& parameter = model_->parameters[p];
        double& value = x[size + static_cast<Eigen::Index>(p)];
        if (parameter.kind == Parameter::Kind::dimension)
            value = std::clamp(value, parameter.lower, parameter.upper);
        if (parameter.kind == Parameter::Kind::magnitude) value = std::abs(x[size + parameter.order]);
    }
}

Eigen::VectorXd CamProblem::completed(const Eigen::VectorXd& x) const {
    Eigen::VectorXd full = x;
    const Eigen::Index size = model_->design.size();
    full.head(size) = projection_->project(x.head(size));
    if (full.allFinite()) complete_parameters(full);
    return full;
}

}  // namespace camopt

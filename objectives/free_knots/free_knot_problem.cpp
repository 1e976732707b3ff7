// SPDX-License-Identifier: MIT
#include "objectives/free_knots/free_knot_problem.hpp"

#include "objectives/scene_model.hpp"

namespace camopt {

namespace {

// Least distance of breakpoints, as a part of the mean. Cubic: two that coincide would make the acceleration
// jump, an infinite jerk, so a weight on the jerk separates them anyway. Quintic: three would tend to
// coincide, where the jerk may jump; but a smooth jerk is the reason for that degree, and divisions by powers
// of the distance would lose digits.
constexpr double least_part_cubic = 0.01, least_part_quintic = 0.1;
// The first grid is dense, with Chebyshev points: rows added later shift the breakpoints.
constexpr int steps_a_degree = 2;
constexpr double pi = 3.14159265358979323846;

}  // namespace

Scene with_breakpoints(Scene scene, std::vector<double> breakpoints) {
    scene.spline.breakpoints = std::move(breakpoints);
    scene.spline.segments = static_cast<int>(scene.spline.breakpoints.size()) - 1;
    scene.spline.free_knots = false;
    return scene;
}

std::vector<double> start_breakpoints(const Scene& scene) {
    return spline_request(scene, DesignKind::states).space.breakpoints();
}

FreeKnotProblem::FreeKnotProblem(Scene scene, const Peaks& reference)
    : scene_(std::move(scene)),
      reference_(reference),
      model_(std::make_shared<const CamModel>(scene_model(scene_, DesignKind::states, reference))),
      form_(std::make_shared<const FreeKnotForm>(
          spline_request(scene_, DesignKind::states),
          scene_.spline.degree == 3 ? least_part_cubic : least_part_quintic)) {
    start_grid();
    rebuild();
}

void FreeKnotProblem::start_grid() {
    for (int r = 0; r < static_cast<int>(model_->rules.size()); ++r) {
        const PointRule& rule = *model_->rules[r];
        const int order = rule.highest_order();
        const int degree = rule.linear() ? form_->degree() - order : form_->degree();
        for (const bool mirrored : {false, true}) {
            // Peaks have a rule for either sign: their mirror images are redundant.
            if (mirrored && (form_->symmetry() == Symmetry::none || !rule.limit())) continue;
            for (int i = 0; i < form_->segments(); ++i) {
                add_sample(r, i, 0.0, mirrored);
                const int steps = degree <= 1 ? degree : steps_a_degree * degree;
                for (int k = 1; k <= steps; ++k) {
                    add_sample(r, i, k == steps ? 1.0 : 0.5 * (1.0 - std::cos(pi * k / steps)), mirrored);
                }
            }
        }
    }
}

bool FreeKnotProblem::add_sample(int rule, int segment, double fraction, bool mirrored) {
    const auto next = places_.lower_bound({rule, segment, mirrored, fraction - same_sample});
    if (next != places_.end()) {
        const auto& [other_rule, other_segment, other_mirrored, other] = *next;
        const bool same_row = other_rule == rule && other_segment == segment && other_mirrored == mirrored;
        if (same_row && other <= fraction + same_sample) return false;
    }
    // If two segments join without a jump, the end of one is the begin of the next.
    const bool jumps = model_->rules[rule]->highest_order() > form_->continuity();
    if (!jumps && fraction <= same_sample && places_.contains({rule, segment - 1, mirrored, 1.0}))
        return false;
    places_.emplace(rule, segment, mirrored, fraction);
    samples_.push_back({rule, segment, fraction, mirrored});
    return true;
}

CamProblem FreeKnotProblem::fixed_problem(const Eigen::VectorXd& x) const {
    return CamProblem(scene_model(with_breakpoints(scene_, breakpoints(x)), DesignKind::states, reference_));
}

Eigen::VectorXd FreeKnotProblem::fixed_point(const CamProblem& fixed, const Eigen::VectorXd& x) const {
    const CamModel& model = fixed.model();
    const auto parameters = static_cast<Eigen::Index>(model.parameters.size());
    Eigen::VectorXd point(model.design.size() + parameters);
    const Eigen::VectorXd values = model.design.run(0).values_of(form_->curve(physical_form(x)));
    point.head(model.design.size()) = values.cwiseQuotient(design_scales(model));
    point.tail(parameters) = x.tail(parameters);
    return point;
}

Eigen::VectorXd FreeKnotProblem::free_point(const CamProblem& fixed, const Eigen::VectorXd& x) const {
    const auto parameters = static_cast<Eigen::Index>(model_->parameters.size());
    Eigen::VectorXd point(grid_->shape().variables());
    const int size = form_->size();
    point.head(size) = form_->values_of(fixed.curve(x)).cwiseQuotient(grid_->scale().head(size));
    point.tail(parameters) = x.tail(parameters);
    return point;
}

Eigen::VectorXd FreeKnotProblem::start() const {
    const CamProblem fixed(*model_);
    return free_point(fixed, fixed.start());
}

Eigen::VectorXd FreeKnotProblem::completed(const Eigen::VectorXd& x) const {
    if (!x.allFinite()) return x;
    const CamProblem fixed = fixed_problem(x);
    return free_point(fixed, fixed.completed(fixed_point(fixed, x)));
}

std::vector<Violation> FreeKnotProblem::violations(const Eigen::VectorXd& x, double slack) const {
    const CamProblem fixed = fixed_problem(x);
    const SplineSpace& space = fixed.model().design.run_space(0);
    std::vector<Violation> found = fixed.violations(fixed_point(fixed, x), slack);
    for (Violation& violation : found) {
        const double at = violation.where.at;
        const int segment = space.segment_of(at, violation.where.side);
        const double fraction = (at - space.breakpoints()[segment]) / space.width(segment);
        violation.where.at = segment + std::clamp(fraction, 0.0, 1.0);
    }
    return found;
}

int FreeKnotProblem::refine(std::span<const Violation> worst) {
    const std::size_t before = samples_.size();
    const int all = scene_.spline.breakpoints.empty()
                        ? scene_.spline.segments
                        : static_cast<int>(scene_.spline.breakpoints.size()) - 1;
    for (const Violation& violation : worst) {
        if (violation.rule >= static_cast<int>(model_->rules.size()))
            continue;  // rows that are always present
        const double at = violation.where.at;
        int segment = std::clamp(
            static_cast<int>(violation.where.side == Side::left ? std::ceil(at) - 1.0 : std::floor(at)), 0,
            all - 1);
        double fraction = at - segment;
        const bool cut = form_->symmetry() != Symmetry::none && 2 * segment + 1 == all;
        const bool mirrored = segment >= form_->segments() || (cut && fraction > 0.5);
        if (mirrored) {
            if (!model_->rules[violation.rule]->limit()) continue;
            segment = all - 1 - segment;
            fraction = 1.0 - fraction;
        }
        if (cut) fraction *= 2.0;  // only half of the middle segment is modelled
        double left = 0.0, right = 1.0;
        for (const auto& [rule, where, mirror, place] : places_) {
            if (rule != violation.rule || where != segment || mirror != mirrored) continue;
            if (place <= fraction) left = std::max(left, place);
            if (place >= fraction) right = std::min(right, place);
        }
        if (!add_sample(violation.rule, segment, fraction, mirrored)) continue;
        add_sample(violation.rule, segment, fraction - bracket * (fraction - left), mirrored);
        add_sample(violation.rule, segment, fraction + bracket * (right - fraction), mirrored);
    }
    const int added = static_cast<int>(samples_.size() - before);
    if (added > 0) rebuild();
    return added;
}

Box FreeKnotProblem::box(double, double) const {
    const Eigen::Index size = grid_->shape().variables();
    return {Eigen::VectorXd::Constant(size, -infinity), Eigen::VectorXd::Constant(size, infinity)};
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/compare/needed_base.hpp"

#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"
#include "core/numbers/interval.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace camopt {

namespace {

// Without a largest base radius: distances from the smallest cam, in prime radii or lifts, whichever is
// larger.
constexpr double nearest = 1e-6, farthest = 1e3;
constexpr int steps_a_decade = 10;
// Otherwise: parts of the range of base radii that the mechanism allows.
constexpr int bounded_steps = 400;
// A rule above this part of its scale is broken.
constexpr double rule_tolerance = 1e-11;
// The radius is found to this part of itself.
constexpr double accuracy = 1e-12;
constexpr int most_bisections = 100;
// Places between two breakpoints where the displacement is looked at.
constexpr int range_samples = 32;

class Judge {
 public:
    Judge(const Scene& scene, const DrivenMechanism& cam, const Motion& motion)
        : scene_(scene), cam_(cam), motion_(motion) {
        find_range();
    }

    /// Empty: every limit is satisfied with this base radius; else what is not.
    [[nodiscard]] std::string broken_at(double base) {
        CamVariables variables;
        variables.cam = cam_;
        variables.cam.dimensions[static_cast<std::size_t>(cam_.formulas->base_radius_index())] = base;
        std::string fault = cam_.formulas->fault(variables.cam.dimensions, least_, most_);
        if (!fault.empty()) return fault;
        variables.scale = {scene_.motion.lift, scene_.motion.unit_angle()};
        const auto rules = cam_limits(scene_, variables);
        // The rule that spoke the last time is likely to speak again.
        if (last_ < rules.size() && is_broken(*rules[last_])) return rules[last_]->name();
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (!is_broken(*rules[i])) continue;
            last_ = i;
            return rules[i]->name();
        }
        return {};
    }

 private:
    [[nodiscard]] bool is_broken(const PointRule& rule) const {
        const double largest = largest_of(rule_maxima(rule, motion_, Eigen::VectorXd())).value;
        return !(largest <= rule_tolerance * rule.scale());
    }
    void find_range() {
        const std::vector<double> points = motion_.breakpoints();
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            for (int k = 0; k <= range_samples; ++k) {
                const double x = points[i] + (points[i + 1] - points[i]) * k / range_samples;
                const double s = scene_.motion.lift * motion_.at(std::min(x, motion_.end())).derivative[0];
                least_ = std::min(least_, s);
                most_ = std::max(most_, s);
            }
        }
    }

    const Scene& scene_;
    const DrivenMechanism& cam_;
    const Motion& motion_;
    double least_ = 0.0, most_ = 0.0;
    std::size_t last_ = 0;
};

/// The base radii at which the cam can be built at rest with its other dimensions: CamMechanism::reach.
Interval allowed_radii(const DrivenMechanism& cam) {
    Interval radii(0.0, infinity);
    for (const std::vector<CamMechanism::SignedIndex>& sum : cam.formulas->reach()) {
        double sign = 0.0, others = 0.0;  // sign · base + others < 0
        for (const CamMechanism::SignedIndex& term : sum) {
            if (term.dimension == cam.formulas->base_radius_index())
                sign = term.sign;
            else
                others += term.sign * cam.dimensions[static_cast<std::size_t>(term.dimension)];
        }
        if (sign < 0.0) radii.lower = std::max(radii.lower, others);
        if (sign > 0.0) radii.upper = std::min(radii.upper, -others);
    }
    return radii;
}

std::vector<double> tried_radii(const Scene& scene, const DrivenMechanism& cam) {
    const auto [smallest, largest] = allowed_radii(cam);
    std::vector<double> radii;
    if (largest < infinity) {
        for (int k = 1; k < bounded_steps; ++k)
            radii.push_back(smallest + (largest - smallest) * k / bounded_steps);
        return radii;
    }
    const double unit = std::max(scene.motion.lift, cam.formulas->length(cam.dimensions));
    const int last = static_cast<int>(std::lround(steps_a_decade * std::log10(farthest / nearest)));
    for (int k = 0; k <= last; ++k)
        radii.push_back(smallest + unit * nearest * std::pow(10.0, static_cast<double>(k) / steps_a_decade));
    return radii;
}

}  // namespace

NeededBase needed_base(const Scene& scene, const DrivenMechanism& cam, const Motion& motion) {
    if (cam.formulas->base_radius_index() < 0)
        throw InputError("the needed base radius of a cam whose base radius is no dimension");
    Judge judge(scene, cam, motion);
    std::string broken;
    double below = 0.0;
    for (const double radius : tried_radii(scene, cam)) {
        std::string now = judge.broken_at(radius);
        if (!now.empty()) {
            broken = std::move(now);
            below = radius;
            continue;
        }
        const Border border = bisected(
            [&](double value) { return judge.broken_at(value).empty(); }, {radius, below}, most_bisections,
            [](const Border& at) { return at.with - at.without <= accuracy * at.with; });
        return {border.with, {}};
    }
    return {std::nullopt, broken};
}

}  // namespace camopt

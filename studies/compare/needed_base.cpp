// SPDX-License-Identifier: MIT
#include "studies/compare/needed_base.hpp"

#include "core/numbers/scalar_search.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "profiles/disk/disk_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace camopt {

namespace {

using enum DimensionIndex;

// Translating: distances from the smallest cam, in prime radii or lifts, whichever is larger.
constexpr double nearest = 1e-6, farthest = 1e3;
constexpr int steps_a_decade = 10;
// Oscillating: parts of the range of base radii that the mechanism allows.
constexpr int oscillating_steps = 400;
// A rule above this part of its scale is broken.
constexpr double rule_tolerance = 1e-11;
// The radius is found to this part of itself.
constexpr double accuracy = 1e-12;
constexpr int most_bisections = 100;
// Places between two breakpoints where the displacement is looked at.
constexpr int range_samples = 32;

class Judge {
 public:
    Judge(const Scene& scene, const DiskCam& cam, const Motion& motion)
        : scene_(scene), cam_(cam), motion_(motion) {
        find_range();
    }

    /// Empty: every limit is kept with this base radius; else what is not.
    [[nodiscard]] std::string broken_at(double base) {
        DiskCam cam = cam_;
        cam.dimensions[static_cast<std::size_t>(base_radius)] = base;
        if (std::string fault = geometry_fault(cam, least_, most_); !fault.empty()) return fault;
        CamVariables variables;
        variables.cam = disk_mechanism(cam);
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
    DiskCam cam_;
    const Motion& motion_;
    double least_ = 0.0, most_ = 0.0;
    std::size_t last_ = 0;
};

std::vector<double> translating_radii(const Scene& scene, const DiskCam& cam) {
    const double smallest = std::max(0.0, std::abs(cam[offset]) - cam[roller_radius]);
    const double unit = std::max(scene.motion.lift, cam[base_radius] + cam[roller_radius]);
    std::vector<double> radii;
    const int last = static_cast<int>(std::lround(steps_a_decade * std::log10(farthest / nearest)));
    for (int k = 0; k <= last; ++k)
        radii.push_back(smallest + unit * nearest * std::pow(10.0, static_cast<double>(k) / steps_a_decade));
    return radii;
}

std::vector<double> oscillating_radii(const DiskCam& cam) {
    const double a = cam[center_distance];
    const bool roller = has_roller(cam.follower);
    const double arm = cam[arm_length];
    const double low = std::max(0.0, roller ? std::abs(a - arm) - cam[roller_radius] : -a - cam[face_offset]);
    const double high = roller ? a + arm - cam[roller_radius] : a - cam[face_offset];
    std::vector<double> radii;
    for (int k = 1; k < oscillating_steps; ++k) radii.push_back(low + (high - low) * k / oscillating_steps);
    return radii;
}

}  // namespace

NeededBase needed_base(const Scene& scene, const DiskCam& cam, const Motion& motion) {
    Judge judge(scene, cam, motion);
    const std::vector<double> radii =
        is_oscillating(cam.follower) ? oscillating_radii(cam) : translating_radii(scene, cam);
    std::string broken;
    double below = 0.0;
    for (const double radius : radii) {
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

// SPDX-License-Identifier: MIT
// The root mean square of something linear along the motion, level > 0, as one convex quadratic row: as a
// limit (m / level² − 1) / 2 <= 0, m the mean square, which is (rms − level) / level near it; as a term
// sqrt(m) / level − q.
#pragma once

#include "objectives/rules/point_rule.hpp"

namespace camopt {

struct Energy {
    std::function<double(const Motion&)> rms;                        ///< sqrt(m)
    std::function<QuadraticForm(const MotionFamily&, double)> form;  ///< m / level², of the level
};

/// `term`: its parameter; −1: a limit.
[[nodiscard]] inline std::shared_ptr<const WholeMotionRule> energy_rule(std::string name, Energy energy,
                                                                        double level, int term) {
    RuleData data{.name = std::move(name), .highest_order = 2, .limit = term < 0};
    if (term >= 0) data.parameters.push_back(term);
    WholeMotionRule::Parts parts{.maxima = [rms = energy.rms, level, term](const Motion& motion, double) {
        const double share = rms(motion) / level;
        const double value = term < 0 ? 0.5 * (share * share - 1.0) : share;
        return std::vector<WholeMotionRule::Place>{{{value, motion.begin()}, {0.0}}};
    }};
    parts.is_one_row = true;
    parts.form = [form = std::move(energy.form), level](const MotionFamily& family) {
        return form(family, level);
    };
    return std::make_shared<const WholeMotionRule>(std::move(data), std::move(parts));
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The root mean square of something linear along the motion, level > 0, as one convex quadratic row: as a
// limit (m / level² − 1) / 2 <= 0, m the mean square, which is (rms − level) / level near it; as a term
// sqrt(m) / level − q.
#pragma once

#include "objectives/rules/point_rule.hpp"

namespace camopt {

class EnergyRule final : public WholeMotionRule {
 public:
    struct Energy {
        std::function<double(const Motion&)> rms;                        ///< sqrt(m)
        std::function<QuadraticForm(const MotionFamily&, double)> form;  ///< m / level², of the level
    };

    /// `term`: its parameter; −1: a limit.
    EnergyRule(std::string name, Energy energy, double level, int term)
        : WholeMotionRule({.name = std::move(name),
                           .highest_order = 2,
                           .limit = term < 0,
                           .parameters = term < 0 ? std::vector<int>{} : std::vector{term}}),
          energy_(std::move(energy)),
          level_(level) {}
    [[nodiscard]] Curvature curvature(double, double) const override { return Curvature::convex; }
    [[nodiscard]] bool is_one_row() const override { return true; }
    [[nodiscard]] std::vector<Place> maxima(const Motion& motion, const Eigen::VectorXd& q) const override {
        const double share = energy_.rms(motion) / level_;
        const double value = limit() ? 0.5 * (share * share - 1.0) : share - (q.size() > 0 ? q[0] : 0.0);
        return {{{value, motion.begin()}, {0.0}}};
    }
    [[nodiscard]] AffineRow row(const MotionFamily&, double, Side, std::span<const double>) const override {
        throw ModelError(name() + ": a quadratic rule has no linear row");
    }
    [[nodiscard]] std::optional<QuadraticForm> form(const MotionFamily& family) const override {
        return energy_.form(family, level_);
    }
    [[nodiscard]] std::vector<Place> first() const override { return {{{0.0, 0.0}, {0.0}}}; }

 private:
    Energy energy_;
    double level_;
};

}  // namespace camopt

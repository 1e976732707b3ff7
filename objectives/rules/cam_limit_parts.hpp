// SPDX-License-Identifier: MIT
// The parts of cam_limits.cpp: each adds the rules of one kind of limit. Private.
#pragma once

#include "objectives/rules/cam_rule.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camopt::cam_limit_parts {

using Rules = std::vector<std::shared_ptr<const CamRule>>;

// A violation relative to something near zero is meaningless: scales stay above this part of the whole.
inline constexpr double least_scale = 1e-3;

/// Collects the rules of one cam.
class Limits {
 public:
    Limits(const Scene& scene, const CamVariables& variables);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const CamMechanism& cam() const { return *variables_->cam.formulas; }
    [[nodiscard]] const CamVariables& variables() const { return *variables_; }
    [[nodiscard]] const std::vector<double>& dimensions() const { return variables_->cam.dimensions; }
    [[nodiscard]] MechanismSetting setting() const { return {dimensions(), active_}; }
    [[nodiscard]] const std::vector<int>& active() const { return active_; }
    /// The unit of length for dimensionless geometry, m.
    [[nodiscard]] double length() const { return cam().length(dimensions()); }
    /// Of the roller at a station, m; 0 without one.
    [[nodiscard]] double roller(int station) const;
    /// The surface is this much further from the roller's centre than its radius: half a groove's clearance.
    [[nodiscard]] double wider_by(int station) const;
    /// The shape of a quantity.
    [[nodiscard]] bool is_linear(MechanismQuantity which) const {
        return cam().shape(which, setting()) == Curvature::linear;
    }

    void add(CamFormula formula) {
        rules_.push_back(std::make_shared<CamRule>(variables_, std::move(formula)));
    }
    /// Of a rule that holds at one station of several.
    void add_at(CamFormula formula, int station);
    [[nodiscard]] Rules taken() { return std::move(rules_); }

 private:
    const Scene& scene_;
    std::shared_ptr<const CamVariables> variables_;
    std::vector<int> active_;
    Rules rules_;
};

/// regularity >= margin at one station; nothing for kinds without undercut.
void add_regularity(Limits& limits, const WrittenLimit& limit, int station);
void add_pressure(Limits& limits);
void add_forces(Limits& limits);

}  // namespace camopt::cam_limit_parts

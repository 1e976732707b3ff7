// SPDX-License-Identifier: MIT
// Limits of a cam of any kind as rules: formulas of one state of the cam, generic over the algebra.
#pragma once

#include "core/text/list_text.hpp"
#include "objectives/rules/model.hpp"
#include "scene/scene.hpp"

namespace camopt {

// One state of a cam, the argument of the formula of a limit, in one of three algebras: values with first and
// second partials, enclosures over a box, enclosures along a stretch of a motion. A formula that is generic
// over the call gives all three.
//
// SI: m, rad, s' and s'' by the cam angle.

/// Partials are by (s, s', s'', the active dimensions in their order).
struct CamCall {
    const CamMechanism& cam;
    MechanismState state;
    std::span<const int> active;
    std::size_t own;  ///< of the active ones: dimensions of the cam; numbers of its spring follow

    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, int station) const {
        MechanismValue found =
            cam.quantity(which, state, station, active.first(std::min(own, active.size())));
        if (own >= active.size()) return found;
        const auto size = static_cast<Eigen::Index>(3 + active.size());
        found.gradient.conservativeResizeLike(MechanismValue::Gradient::Zero(size));
        found.hessian.conservativeResizeLike(MechanismValue::Hessian::Zero(size, size));
        return found;
    }
    [[nodiscard]] MechanismValue displacement() const { return variable(state.output.s, 0); }
    [[nodiscard]] MechanismValue velocity() const { return variable(state.output.velocity, 1); }
    [[nodiscard]] MechanismValue acceleration() const { return variable(state.output.acceleration, 2); }
    /// The cam angle from the start of the motion, rad.
    [[nodiscard]] MechanismValue angle() const {
        MechanismValue angle = variable(state.theta, -1);
        angle.by_angle = 1.0;
        return angle;
    }
    /// One of the cam's dimensions, or a number of its spring (CamVariables::spring).
    [[nodiscard]] MechanismValue dimension(int index) const {
        const auto place = std::ranges::find(active, index) - active.begin();
        const bool moves = place < static_cast<std::ptrdiff_t>(active.size());
        return variable(state.dimensions[static_cast<std::size_t>(index)],
                        moves ? static_cast<int>(3 + place) : -1);
    }

 private:
    /// index: of its partial 1; < 0: a constant.
    [[nodiscard]] MechanismValue variable(double value, int index) const {
        const auto size = static_cast<Eigen::Index>(3 + active.size());
        MechanismValue result{value, MechanismValue::Gradient::Zero(size),
                              MechanismValue::Hessian::Zero(size, size)};
        if (index >= 0) result.gradient[index] = 1.0;
        return result;
    }
};

/// Common to CamCallOver and CamCallAlong: a quantity without an enclosure makes the whole unknown.
template <class Range>
class EnclosedCall {
 public:
    [[nodiscard]] std::optional<Range> known(const Range& found) const {
        return is_known_ ? std::optional<Range>(found) : std::nullopt;
    }

 protected:
    [[nodiscard]] Range noted(const std::optional<Range>& found) const {
        is_known_ = is_known_ && found.has_value();
        return found.value_or(Range(0.0));
    }

 private:
    mutable bool is_known_ = true;
};

struct CamCallOver : EnclosedCall<RangeOver> {
    CamCallOver(const CamMechanism& mechanism, const MechanismStateOver& box) : cam(mechanism), state(box) {}

    const CamMechanism& cam;
    const MechanismStateOver& state;

    [[nodiscard]] RangeOver quantity(MechanismQuantity which, int station) const {
        const MechanismEnclosures* const known = cam.enclosures();
        return noted(known == nullptr ? std::nullopt : known->quantity_over(which, state, station));
    }
    [[nodiscard]] const RangeOver& displacement() const { return state.s; }
    [[nodiscard]] const RangeOver& velocity() const { return state.velocity; }
    [[nodiscard]] const RangeOver& acceleration() const { return state.acceleration; }
    [[nodiscard]] RangeOver angle() const { return {state.theta}; }
    [[nodiscard]] const RangeOver& dimension(int index) const {
        return state.dimensions[static_cast<std::size_t>(index)];
    }
};

struct CamCallAlong : EnclosedCall<RangeAlong> {
    CamCallAlong(const CamMechanism& mechanism, const MechanismStateAlong& stretch)
        : cam(mechanism), state(stretch) {}

    const CamMechanism& cam;
    const MechanismStateAlong& state;

    [[nodiscard]] RangeAlong quantity(MechanismQuantity which, int station) const {
        const MechanismEnclosures* const known = cam.enclosures();
        return noted(known == nullptr ? std::nullopt : known->quantity_along(which, state, station));
    }
    [[nodiscard]] const RangeAlong& displacement() const { return state.s; }
    [[nodiscard]] const RangeAlong& velocity() const { return state.velocity; }
    [[nodiscard]] const RangeAlong& acceleration() const { return state.acceleration; }
    [[nodiscard]] const RangeAlong& angle() const { return state.theta; }
    [[nodiscard]] RangeAlong dimension(int index) const {
        return {state.dimensions[static_cast<std::size_t>(index)]};
    }
};

// A limit of a cam of any kind at one cam angle and one station: a formula of (s, s', s'', dimensions), in
// three algebras: values with partials, enclosures over boxes, enclosures along a stretch of a motion. It
// uses the cam only through its interface (scene/cam_mechanism.hpp).
//
// A formula is in SI. The rule converts it to the normalised (y, y', y'', y'''; q) of the optimizer by the
// chain rule: s^{(r)} = lift / unit_angle^r · y^{(r)}, each variable dimension = reference · q.

struct CamFormula : RuleData {
    CamFormula() { highest_order = 2; }

    MechanismQuantity figure = MechanismQuantity::pressure_numerator;  ///< what the limit is on

    /// <= 0 is satisfied; dimensionless, of order one.
    std::function<MechanismValue(const CamCall&)> value = {};
    /// The same over a box of states and dimensions, or that times a positive factor.
    std::function<std::optional<RangeOver>(const CamCallOver&)> over = {};
    /// The same along a stretch of the cam angle.
    std::function<std::optional<RangeAlong>(const CamCallAlong&)> along = {};
    /// Over all s from `least` to `most`; none: general.
    std::function<Curvature(double least, double most)> shape = {};
    bool of_loads = false;                     ///< it depends on the numbers of the spring, too
    Interval slopes = Interval::everything();  ///< of s' by the cam angle: the admissible range
};

/// All three from one formula, generic over the call.
template <class Formula>
[[nodiscard]] CamFormula cam_formula(std::string name, const Formula& formula) {
    CamFormula result;
    result.name = std::move(name);
    result.value = formula;
    result.over = [formula](const CamCallOver& call) { return call.known(formula(call)); };
    result.along = [formula](const CamCallAlong& call) { return call.known(formula(call)); };
    return result;
}

class CamRule final : public PointRule {
 public:
    /// Throws ModelError for more variable dimensions than a MechanismValue can have.
    CamRule(std::shared_ptr<const CamVariables> cam, CamFormula formula);

    /// Whether its stations are all that the limit covers; else it holds at them only.
    [[nodiscard]] bool at_every_station() const {
        return cam_->cam.formulas->limit_structure().has_all_stations(formula_.figure);
    }
    [[nodiscard]] Curvature curvature(double least, double most) const override;
    [[nodiscard]] SlopeRange slope_range() const override;
    [[nodiscard]] std::optional<RangeAlong> range_along(const Interval& x,
                                                        const std::array<Interval, 5>& derivatives,
                                                        const Eigen::VectorXd& q) const override;
    [[nodiscard]] std::optional<RangeOver> range_over(std::span<const Interval> box,
                                                      const Interval& at) const override;
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd& q) const override;

 private:
    /// m in one unit of y, y', y''.
    [[nodiscard]] std::array<double, 3> units() const;
    [[nodiscard]] RuleValue normalised(const MechanismValue& physical) const;

    std::shared_ptr<const CamVariables> cam_;
    CamFormula formula_;
    std::vector<int> active_;
};

}  // namespace camopt

namespace camopt::cam_limit_parts {

// The parts of cam_limits.cpp: each adds the rules of one kind of limit. Private.

using Rules = std::vector<std::shared_ptr<const CamRule>>;

// A violation relative to something near zero is meaningless: scales stay above this part of the whole.
inline constexpr double least_scale = 1e-3;

/// Collects the rules of one cam.
class Limits {
 public:
    Limits(const Scene& scene, const CamVariables& variables);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const CamMechanism& cam() const { return *variables_->cam.formulas; }
    [[nodiscard]] const LimitStructure& structure() const { return cam().limit_structure(); }
    [[nodiscard]] const CamVariables& variables() const { return *variables_; }
    [[nodiscard]] const std::vector<double>& dimensions() const { return variables_->cam.dimensions; }
    [[nodiscard]] MechanismSetting setting() const { return {dimensions(), active_}; }
    [[nodiscard]] const std::vector<int>& active() const { return active_; }
    /// The unit of length for dimensionless geometry, m.
    [[nodiscard]] double length() const { return cam().length(dimensions()); }
    /// Of the roller at a station, m; 0 without one.
    [[nodiscard]] double roller(int station) const;
    /// The surface is this much further from the roller's centre than its radius: half a groove's clearance.
    [[nodiscard]] double wider_by(int station) const {
        return cam().surface_offset(dimensions(), station) - roller(station);
    }
    /// The shape of a quantity.
    [[nodiscard]] bool is_linear(MechanismQuantity which) const {
        return structure().shape(which, setting()) == Curvature::linear;
    }

    void add(CamFormula formula) {
        if (!variables_->made.empty()) append_item(formula.remark, variables_->made);
        formula.fields.made = variables_->made_parts;
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

/// regularity >= margin at one station; nothing for kinds without undercut. `part`: of the limit, as
/// RowFields::part; empty: the limit itself.
void add_regularity(Limits& limits, const WrittenLimit& limit, int station, std::string part = {});
void add_pressure(Limits& limits);
void add_forces(Limits& limits);

}  // namespace camopt::cam_limit_parts

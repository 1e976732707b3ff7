// SPDX-License-Identifier: MIT
// What the limits of every cam share as rules, whatever algebra their formulas are in: a quantity of
// (s, s', s'', dimensions) in SI is brought to the normalised (y, y', y'', y'''; q) of the optimizer by the
// chain rule: s^{(r)} = lift / unit_angle^r · y^{(r)}, each variable dimension = reference · q.
#pragma once

#include "objectives/rules/point_rule.hpp"
#include "profiles/sampling.hpp"

#include <string>
#include <utility>
#include <vector>

namespace camopt {

struct LimitFrame {
    std::string name;         ///< the key of the limit, as the user wrote it
    std::string remark = {};  ///< which part of the limit it is, where there are several
    int sign = 0;             ///< ±1: which of its two sides
    int highest_order = 2;
    double scale = 1.0;               ///< a value of this is a violation of 100 %
    std::vector<double> places = {};  ///< x where alone it holds; empty: everywhere
};

class LimitRule : public PointRule {
 public:
    [[nodiscard]] std::string name() const override { return frame_.name; }
    [[nodiscard]] RowOrigin origin() const override {
        RowOrigin origin = with_sign(PointRule::origin(), frame_.sign);
        origin.remark = frame_.remark;
        return origin;
    }
    [[nodiscard]] const std::vector<int>& parameters() const override { return parameters_; }
    [[nodiscard]] int highest_order() const override { return frame_.highest_order; }
    [[nodiscard]] bool limit() const override { return true; }
    [[nodiscard]] const std::vector<double>& places() const override { return frame_.places; }
    [[nodiscard]] double scale() const override { return frame_.scale; }

 protected:
    LimitRule(LimitFrame frame, const MotionScale& scale) : frame_(std::move(frame)) {
        const double slope = scale.lift / scale.unit_angle;
        slots_ = {{0, 0, scale.lift}, {1, 1, slope}, {2, 2, slope / scale.unit_angle}};
    }

    /// The next of q_1 … q_m: the column of its partials in a quantity, which parameter it is.
    void add_variable(int column, int parameter, double reference) {
        // y''' stands between y'' and the parameters, and no quantity depends on it.
        slots_.push_back({column, static_cast<Eigen::Index>(slots_.size()) + 1, reference});
        parameters_.push_back(parameter);
    }

    /// A quantity with value, gradient and hessian.
    template <class Quantity>
    [[nodiscard]] RuleValue normalised(const Quantity& physical) const {
        const auto size = static_cast<Eigen::Index>(slots_.size()) + 1;
        RuleValue rule{physical.value, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
        for (const Slot& a : slots_) {
            rule.gradient[a.to] = a.unit * physical.gradient[a.from];
            for (const Slot& b : slots_)
                rule.hessian(a.to, b.to) = a.unit * b.unit * physical.hessian(a.from, b.from);
        }
        return rule;
    }

 private:
    /// Each variable of a quantity that moves: where its partial stands there, where in the rule's variables,
    /// and its unit.
    struct Slot {
        int from = 0;
        Eigen::Index to = 0;
        double unit = 1.0;
    };
    LimitFrame frame_;
    std::vector<int> parameters_;
    std::vector<Slot> slots_;
};

}  // namespace camopt

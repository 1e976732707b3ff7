// SPDX-License-Identifier: MIT
#include "objectives/rules/whole_motion_rule.hpp"

#include "core/errors.hpp"

namespace camopt {

RuleValue WholeMotionRule::evaluate(const MotionPoint&, const Eigen::VectorXd&) const {
    throw ModelError(name() + ": a rule of the whole motion was evaluated at a single point");
}

}  // namespace camopt

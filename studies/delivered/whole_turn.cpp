// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/units.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

namespace {

constexpr double rounded_turn = 1e-9;  // of a turn: what is left of it is rounding

}  // namespace

MotionChain Solution::whole_turn() const {
    if (!motion) throw InputError("a cam needs a motion, and this solution has none");
    const double turn = units::turn / scene.motion.unit_angle();
    if (motion->end() >= turn * (1.0 - rounded_turn)) return *motion;
    const bool returns = scene.motion.type == MotionType::rr;  // to 0, not to what rounding left of it
    const double end = returns ? 0.0 : motion->at(motion->end(), Side::left).derivative[0];
    std::vector<ChainPart> parts = motion->parts();
    parts.push_back({motion->end(), turn, nullptr, 0.0, 1.0, end, 1.0});
    return MotionChain(std::move(parts));
}

}  // namespace camopt

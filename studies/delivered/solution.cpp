// SPDX-License-Identifier: MIT
#include "studies/delivered/solution.hpp"

#include "core/errors.hpp"
#include "scene/motion/set_points.hpp"

namespace camopt {

namespace {

constexpr double rounded_turn = 1e-9;  // of a turn: what is left of it is rounding

}  // namespace

Solution::Solution() = default;
Solution::Solution(const Solution& other) = default;
Solution& Solution::operator=(const Solution& other) = default;
// NOLINTBEGIN(performance-noexcept-move-constructor): see the header
Solution::Solution(Solution&& other) = default;
Solution& Solution::operator=(Solution&& other) = default;
// NOLINTEND(performance-noexcept-move-constructor)
Solution::~Solution() = default;

MotionChain Solution::whole_turn() const {
    if (!motion) throw InputError("a cam needs a motion, and this solution has none");
    const double turn = units::turn / scene.motion.unit_angle();
    if (motion->end() >= turn * (1.0 - rounded_turn)) return *motion;
    constexpr std::array<double, 2> rest{};
    if (end_velocities(scene.motion, false) != rest || end_velocities(scene.motion, true) != rest)
        return *motion;                                        // no dwell can follow
    const bool returns = scene.motion.type == MotionType::rr;  // to 0, not to what rounding left of it
    const double end = returns ? 0.0 : motion->at(motion->end(), Side::left).derivative[0];
    std::vector<ChainPart> parts = motion->parts();
    parts.push_back({motion->end(), turn, nullptr, 0.0, 1.0, end, 1.0});
    return MotionChain(std::move(parts));
}

MotionChain Solution::master_turn() const {
    MotionChain turn = whole_turn();
    const double at_zero = scene.motion.own_place(0.0);
    if (at_zero <= turn.begin()) return turn;
    const double travel = turn.at(turn.end(), Side::left).derivative[0] - turn.at(turn.begin()).derivative[0];
    const auto moved = [](ChainPart part, double by, double down) {
        part.begin += by;
        part.end += by;
        part.x0 += by;
        part.y0 -= down;
        return part;
    };
    std::vector<ChainPart> first, second;
    for (const ChainPart& part : turn.parts()) {
        ChainPart before = part, after = part;
        before.end = std::min(part.end, at_zero);
        after.begin = std::max(part.begin, at_zero);
        if (after.begin < after.end) first.push_back(moved(after, -at_zero, travel));
        if (before.begin < before.end) second.push_back(moved(before, turn.end() - at_zero, 0.0));
    }
    if (!first.empty() && !second.empty()) second.front().begin = first.back().end;
    first.insert(first.end(), second.begin(), second.end());
    return MotionChain(std::move(first));
}

std::optional<double> delivered_dimension(const Solution& solution, DimensionIndex which) {
    if (!solution.cam) return {};
    const std::vector<CamDimension>& all = solution.scene.cam.value().dimensions;
    const auto found = std::ranges::find(all, name_of(which), &CamDimension::name);
    if (found == all.end()) return {};
    return solution.cam->cam.dimensions[static_cast<std::size_t>(found - all.begin())];
}

LoadsAt delivered_loads(const Solution& solution) {
    if (!solution.cam || !solution.cam->summary.forces) return {};
    const MotionScale scale{solution.scene.motion.lift, solution.scene.motion.unit_angle()};
    const double speed = solution.scene.motion.speed.value();
    return [&solution, scale, speed](const MotionPoint& motion, const CamPoints& cam) {
        const FollowerState state = state_of(motion, scale);
        const ForceSpec& forces = *solution.scene.forces;
        FollowerLoads loads =
            follower_loads(solution.cam->cam, forces, forces.force(speed, state, scale.unit_angle * motion.x),
                           state, [&](int station) { return cam.at(motion, station); });
        if (!solution.cam->summary.no_contact) return loads;
        loads.normal_force = infinity;
        loads.hertz_pressure.reset();
        return loads;
    };
}

}  // namespace camopt

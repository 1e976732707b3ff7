// SPDX-License-Identifier: MIT
// Two axes on one master: a pusher moves 100 mm forward and back, and a gripper must stay within 20.1 mm
// behind it. The largest speed of the machine is searched; a little above it motions are proved impossible.
#include <camopt/machine.hpp>
#include <camopt/solve.hpp>
#include <camopt/units.hpp>
#include <cstdio>
#include <numbers>
using namespace camopt;

ProgramSegment part(double degrees, std::optional<double> to = {}) {  // to: lifts; none: a dwell
    ProgramSegment one;
    one.kind = to ? SegmentKind::spline : SegmentKind::dwell;
    one.angle = degrees * units::degree;
    one.to = to;
    return one;
}
Scene slide(double lift, double move, double dwell, double acceleration) {
    Scene scene;
    scene.motion.type = MotionType::program;
    scene.motion.lift = lift;
    scene.motion.segments = {part(move, 1), part(dwell), part(move, 0), part(360 - dwell - 2 * move)};
    scene.motion.speed = 60 * units::revolution_per_minute;  // replaced by the machine's
    scene.spline.segments = 8;
    scene.objective.acceleration = 1;
    scene.limits.acceleration = metres_per_second_squared(acceleration);
    return scene;
}
int main() {
    MachineSpec machine;
    machine.least_speed = 20 * units::revolution_per_minute;
    machine.most_speed = 600 * units::revolution_per_minute;
    machine.axes = {{"pusher", {}, slide(0.1, 130, 20, 45)}, {"gripper", {}, slide(0.08, 150, 40, 30)}};
    machine.clearances = {{.axes = {0, 1}, .factors = {-1, 1}, .at_least = -0.0201}};
    const MachineSolution found = solve_machine(machine);
    std::printf("%s at %.2f rpm", name_of(found.certificate.verdict), found.speed * 30 / std::numbers::pi);
    if (found.impossible_above)
        std::printf(", impossible at %.2f rpm", *found.impossible_above * 30 / std::numbers::pi);
    for (const MachineLimit& limit : found.limited_by) std::printf("limited by %s\n", limit.key.c_str());
}

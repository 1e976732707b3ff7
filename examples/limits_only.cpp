// SPDX-License-Identifier: MIT
// A drive known only by its limits in m/s and m/s²: is there a motion within them? The objective picks the
// smoothest one. Where there is none, that is proved, and camopt says what each limit alone would have to be.
#include <camopt/solve.hpp>
#include <camopt/units.hpp>
#include <cstdio>

int main() {
    using namespace camopt;
    for (const double most : {30.0, 15.0}) {
        Scene scene;
        scene.motion.lift = 20 * units::millimetre;
        scene.motion.rise = 120 * units::degree;
        scene.motion.speed = 300 * units::revolution_per_minute;
        scene.spline.segments = 24;
        scene.limits.velocity = millimetres_per_second(550);
        scene.limits.acceleration = metres_per_second_squared(most);
        scene.objective.jerk = 1;

        const Solution solution = solve(scene);
        std::printf("%g m/s2: %s\n", most, name_of(solution.certificate.verdict));
        for (const ConstraintReport& limit : solution.constraints)
            std::printf("  %s: %.4g of %.4g %s\n", limit.name.c_str(), limit.worst, limit.limit,
                        limit.unit.c_str());
        for (const Relaxation& change : solution.relaxation)
            if (change.solved)
                std::printf("  %s = %.4g instead of %.4g\n", change.key.c_str(), *change.solved,
                            change.given);
    }
}

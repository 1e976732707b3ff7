// SPDX-License-Identifier: MIT
// Motion and cam designed together: a roller follower with a pressure angle of at most 30 degrees, on the
// smallest disk whose motion is still smooth. The base radius is a range; its weight in the objective trades
// size against jerk.
#include <camopt/disk_cam.hpp>
#include <camopt/solve.hpp>
#include <camopt/units.hpp>
#include <cstdio>

int main() {
    using namespace camopt;
    Scene scene;
    scene.motion.lift = 20 * units::millimetre;
    scene.motion.rise = 90 * units::degree;
    scene.spline.segments = 16;
    scene.objective.jerk = 0.5;
    scene.objective.dimensions[static_cast<int>(DimensionIndex::base_radius)] = 0.5;  // per lift
    scene.cam = disk_spec({.follower = FollowerType::translating_roller});
    scene.cam->set(DimensionIndex::base_radius, Dimension(15 * units::millimetre, 80 * units::millimetre));
    scene.cam->set(DimensionIndex::roller_radius, 8 * units::millimetre);
    scene.limits.pressure_angle = 30 * units::degree;

    const Solution solution = solve(scene);
    std::printf("%s\n", name_of(solution.certificate.verdict));
    if (!solution.cam) return 1;
    const CamReport& cam = *solution.cam;
    std::printf("base radius %.3f mm\n",
                *delivered_dimension(solution, DimensionIndex::base_radius) / units::millimetre);
    std::printf("largest pressure angle %.3f deg\n", cam.summary.pressure_angle.value / units::degree);
    if (cam.smallest)
        std::printf("any motion needs a prime radius above %.3f mm\n",
                    cam.smallest->prime_radius / units::millimetre);
    std::printf("least convex radius %.3f mm\n", cam.summary.convex_radius->value / units::millimetre);
}

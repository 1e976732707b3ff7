// SPDX-License-Identifier: MIT
// The best rise of 10 mm in 120 degrees between two dwells: verdict, proved bound, exact peaks and points of
// the motion.
#include <camopt/solve.hpp>
#include <camopt/units.hpp>
#include <cstdio>

int main() {
    camopt::Scene scene;  // a rise between two dwells, the defaults of a scene file
    scene.motion.lift = 10 * camopt::units::millimetre;
    scene.motion.rise = 120 * camopt::units::degree;
    scene.spline.segments = 12;
    scene.objective.velocity = 0.4;  // weights of the peaks, each divided by that of the modified sine
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;

    const camopt::Solution solution = camopt::solve(scene);
    const camopt::Certificate& proof = solution.certificate;
    std::printf("%s: objective %.6f", name_of(proof.verdict), proof.objective);
    if (proof.lower_bound) std::printf(", no cubic spline of 12 segments is below %.6f", *proof.lower_bound);
    const camopt::Peaks& peaks = solution.peaks;
    std::printf("\nV %.4f  A %.4f  J %.3f\n", peaks.velocity.value, peaks.acceleration.value,
                peaks.jerk.value);

    if (!solution.motion) return 1;
    for (int step = 0; step <= 4; ++step) {
        const double x = step / 4.0;  // cam angle by the rise
        std::printf("%5.1f deg  %8.5f mm\n", 120 * x, 10 * solution.motion->at(x).derivative[0]);
    }
}

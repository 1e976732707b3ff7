// SPDX-License-Identifier: MIT
// The trade-off between peak velocity and peak jerk: one rise with five weights, each solve started from the
// one before.
#include <camopt/solve.hpp>
#include <camopt/sweep.hpp>
#include <cstdio>
#include <vector>

int main() {
    camopt::Scene scene;
    scene.spline.segments = 16;
    const std::vector<double> weights = {0.1, 0.3, 0.5, 0.7, 0.9};
    const auto set_weight = [](camopt::Scene& one, double weight) {
        one.objective.velocity = weight;
        one.objective.jerk = 1 - weight;
    };
    std::printf("weight of V      V        J    verdict\n");
    for (const camopt::SweptScene& row : camopt::sweep(scene, weights, set_weight)) {
        const camopt::Peaks& peaks = row.solution.peaks;
        std::printf("%11.1f  %.4f  %7.3f    %s\n", row.value, peaks.velocity.value, peaks.jerk.value,
                    name_of(row.solution.certificate.verdict));
    }
}

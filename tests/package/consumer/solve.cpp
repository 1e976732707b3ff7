// SPDX-License-Identifier: MIT
#include <camopt/solve.hpp>
#include <iostream>

int main() {
    camopt::Scene scene;
    scene.spline.segments = 12;
    scene.objective.velocity = 0.4;
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    const camopt::Solution solution = camopt::solve(scene);
    std::cout.precision(9);
    std::cout << name_of(solution.certificate.verdict) << ": objective " << solution.certificate.objective
              << '\n';
}

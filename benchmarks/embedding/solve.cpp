// SPDX-License-Identifier: MIT
// A scene made in code and solved. Links camopt::studies; no reader, no output, no program around it.
#include "studies/solve/solve.hpp"

#include <cstdio>

int main() {
    camopt::Scene scene;
    scene.spline.segments = 12;
    scene.objective.velocity = 0.4;
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    const camopt::Solution solution = camopt::solve(scene);
    std::printf("%.9f %s\n", solution.certificate.objective, camopt::name_of(solution.certificate.verdict));
}

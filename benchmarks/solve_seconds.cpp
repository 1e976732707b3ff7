// SPDX-License-Identifier: MIT
// solve_seconds SCENE REPEATS: how long one scene file takes, from so many solves of it, in one line: the
// median of the processor seconds of solve(), the least wall seconds of the solve inside it, the objective.
//
// Processor time, because others on the machine do not count in it.
// Uses nothing but what camopt could do before it knew cams, so that the same file measures an older commit
// (against_commit.sh builds it there).
#include "benchmarks/parts/whole_output.hpp"
#include "input/loading/load_scene.hpp"
#include "studies/solve/solve.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <vector>

namespace {

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void print_seconds(const camopt::Scene& scene, int repeats) {
    std::vector<double> processor, wall;
    double objective = camopt::solve(scene).certificate.objective;  // not timed: it warms the caches
    for (int i = 0; i < repeats; ++i) {
        const double begin = processor_seconds();
        const camopt::Solution solution = camopt::solve(scene);
        processor.push_back(processor_seconds() - begin);
        wall.push_back(solution.seconds_solve);
        objective = solution.certificate.objective;
    }
    std::printf("%.9g %.9g %.12g\n", median(processor), *std::ranges::min_element(wall), objective);
}

}  // namespace

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    if (count != 3) {
        std::fputs("usage: solve_seconds SCENE REPEATS\n", stderr);
        return 2;
    }
    try {
        print_seconds(camopt::load_scene(words[1]), std::max(1, std::atoi(words[2])));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "solve_seconds: %s\n", error.what());
        return 1;
    }
}

// SPDX-License-Identifier: MIT
// evaluation_counts SCENES: what solving each scene file of a folder evaluates, and nothing more: how often
// cost, gradient, rows, Jacobian and Hessian, how many points of a profile, rounds and starts.
//
// CSV on the standard output, a line a scene. Ends with code 1 where a scene without a cam evaluated a point
// of a profile, or could not be solved at all.
#include "benchmarks/parts/whole_output.hpp"
#include "input/loading/load_scene.hpp"
#include "report/csv/csv_line.hpp"
#include "studies/search/planned_solve.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

namespace camopt::benchmarks {

namespace {

constexpr double most_seconds = 10.0;

bool print_row(const std::filesystem::path& file) {
    Scene scene = load_scene(file);
    scene.solver.max_seconds = std::min(scene.solver.max_seconds, most_seconds);
    const Solution solution = solve_without_explaining(scene, {});
    const EvaluationCounts& counts = solution.evaluations;
    CsvLine line;
    const bool has_cam = scene.cam.has_value();
    line.words(file.stem().string()).words(has_cam ? "yes" : "no").words(solution.solver.name);
    line.words(name_of(solution.certificate.verdict)).words(solution.solver.convex ? "yes" : "no");
    line.count(solution.solver.starts)
        .count(solution.solver.exchange_rounds)
        .count(solution.solver.iterations);
    line.count(counts.cost).count(counts.gradient).count(counts.constraints).count(counts.jacobian);
    line.count(counts.hessian).count(counts.profile_points).number(solution.seconds_solve);
    std::fputs(line.finish().c_str(), stdout);
    std::fflush(stdout);
    const bool kept = has_cam || counts.profile_points == 0;
    if (!kept) std::fprintf(stderr, "evaluation_counts: %s has no cam\n", file.c_str());
    return kept;
}

bool print_table(const std::filesystem::path& folder) {
    std::puts(
        "scene,cam,solver,verdict,convex,starts,exchange_rounds,iterations,cost,gradient,constraints,"
        "jacobian,"
        "hessian,profile_points,seconds_solve");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::ranges::sort(files);
    bool kept = !files.empty();
    for (const auto& file : files) {
        try {
            kept = print_row(file) && kept;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "evaluation_counts: %s: %s\n", file.c_str(), error.what());
            kept = false;
        }
    }
    return kept;
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    if (count != 2) {
        std::fputs("usage: evaluation_counts SCENES\n", stderr);
        return 2;
    }
    try {
        return camopt::benchmarks::print_table(words[1]) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "evaluation_counts: %s\n", error.what());
        return 1;
    }
}

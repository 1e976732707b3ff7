// SPDX-License-Identifier: MIT
// sweep_seconds FOLDER: 1,000 weights, and 200 limits of the velocity, of a DRD cubic of 32 segments in one
// process: warm-started along the sweep (studies/search/planned_solve.hpp, each chunk starts cold), each
// cold, and each cold with Ipopt.
//
// Writes FOLDER/sweep_seconds.csv (limits: sweep_limits.csv), a line a way: passes over all rows, their
// median seconds, rows that are not proved optimal, the largest difference of a row's objective from its cold
// solve (relative), ratio of seconds to the first way. FOLDER/sweep_rows.csv has every row's weights and
// objectives. Weights: the first 1,000 of the lattice of 44 divisions, no tie-break. Limits: from 1.6 to 2,
// the smoothest motions. Tolerance 1e-9, whole library solves. Ipopt runs fewer passes where they would take
// more than its share of time.
#include "benchmarks/linear/final_grid.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "benchmarks/parts/solver_variants.hpp"
#include "core/text/text_file.hpp"
#include "report/csv/csv_line.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int weights = 1000, divisions = 44, segments = 32, passes = 5;
constexpr int limits = 200;
constexpr double least_velocity = 1.6, most_velocity = 2.0;
constexpr double seconds_of_ipopt = 170.0;  // no pass begins after

struct Way {
    std::string name;
    std::string solver;
    bool warm = false;
    std::vector<double> seconds = {};     ///< of each pass
    std::vector<double> objectives = {};  ///< of the last pass
    int not_optimal = 0;
    int solved = 0;  ///< rows that needed a solve, of the last pass
};

using Scenes = std::vector<Scene>;

/// Velocity, acceleration, jerk of every row.
Scenes scenes_of_weights(const std::string& solver) {
    const SweepAxis axis = simplex_weights(divisions);
    Scenes scenes;
    for (int row = 0; row < weights; ++row) {
        Scene scene = drd_scene(3, segments);
        const auto point = axis.point(row);
        scene.objective.velocity = point[0];
        scene.objective.acceleration = point[1];
        scene.objective.jerk = point[2];
        scene.solver.name = solver;
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

Scenes scenes_of_limits(const std::string& solver) {
    Scenes scenes;
    for (int row = 0; row < limits; ++row) {
        Scene scene = drd_scene(3, segments);
        scene.limits.velocity =
            PeakLimit{least_velocity + (most_velocity - least_velocity) * row / (limits - 1)};
        scene.objective.tie_break = TieBreak::rms_jerk;
        scene.solver.name = solver;
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

void one_pass(Way& way, const Scenes& scenes) {
    way.objectives.clear();
    way.not_optimal = way.solved = 0;
    KnownSolutions known;
    const Clock::time_point begin = Clock::now();
    for (std::size_t row = 0; row < scenes.size(); ++row) {
        if (row % weight_chunk_size == 0) known = {};
        known.number = static_cast<int>(row);
        const Solution solution = solve_without_explaining(scenes[row], {}, way.warm ? &known : nullptr);
        way.objectives.push_back(solution.certificate.objective);
        if (solution.certificate.verdict != Verdict::optimal) ++way.not_optimal;
        if (!solution.solver.proved_from) ++way.solved;
    }
    way.seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    std::fprintf(stderr, "sweep_seconds: %s, %.3g s\n", way.name.c_str(), way.seconds.back());
}

double worst_difference(const Way& way, const Way& cold) {
    double worst = 0.0;
    for (std::size_t row = 0; row < cold.objectives.size(); ++row) {
        const double size = std::max(1.0, std::abs(cold.objectives[row]));
        worst = std::max(worst, std::abs(way.objectives[row] - cold.objectives[row]) / size);
    }
    return worst;
}

std::string summary(const std::vector<Way>& ways) {
    std::string text =
        "way,solver,rows,solved,passes,seconds_median,seconds_min,not_optimal,worst_difference_from_cold,"
        "ratio\n";
    for (const Way& way : ways) {
        CsvLine line;
        line.words(way.name).words(way.solver).count(static_cast<long>(way.objectives.size()));
        line.count(way.solved);
        line.count(static_cast<long>(way.seconds.size()));
        line.number(median(way.seconds)).number(*std::ranges::min_element(way.seconds));
        line.count(way.not_optimal).number(worst_difference(way, ways[1]));
        line.number(median(way.seconds) / median(ways.front().seconds));
        text += line.finish();
    }
    return text;
}

std::string row_table(const std::vector<Way>& ways) {
    const SweepAxis axis = simplex_weights(divisions);
    std::string text = "row,velocity,acceleration,jerk";
    for (const Way& way : ways) text += ",objective_" + way.solver + (way.warm ? "_warm" : "_cold");
    text += '\n';
    for (int row = 0; row < weights; ++row) {
        CsvLine line;
        line.count(row);
        for (const double weight : axis.point(row)) line.number(weight);
        for (const Way& way : ways) line.number(way.objectives[row]);
        text += line.finish();
    }
    return text;
}

std::vector<Way> measured(Scenes (*scenes_of)(const std::string& solver)) {
    std::vector<Way> ways = {{"sweep, rows proved from known optima within a chunk", "structured", true},
                             {"every row cold", "structured"}};
    if (is_available("ipopt")) ways.push_back({"every row cold", "ipopt"});
    std::vector<Scenes> scenes;
    for (const Way& way : ways) scenes.push_back(scenes_of(way.solver));
    const Clock::time_point begin = Clock::now();
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t k = 0; k < ways.size(); ++k) {
            const double spent = std::chrono::duration<double>(Clock::now() - begin).count();
            if (ways[k].solver == "ipopt" && spent > seconds_of_ipopt) continue;
            one_pass(ways[k], scenes[k]);
        }
    }
    return ways;
}

void run(const std::filesystem::path& folder) {
    write_text_file(folder / "sweep_limits.csv", summary(measured(scenes_of_limits)));
    const std::vector<Way> ways = measured(scenes_of_weights);
    write_text_file(folder / "sweep_seconds.csv", summary(ways));
    write_text_file(folder / "sweep_rows.csv", row_table(ways));
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: sweep_seconds FOLDER\n", stderr);
        return 2;
    }
    try {
        camopt::benchmarks::run(words[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sweep_seconds: %s\n", error.what());
        return 1;
    }
}

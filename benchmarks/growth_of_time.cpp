// SPDX-License-Identifier: MIT
// growth_of_time: seconds of the structured solver against the number of segments, DRD cubic over states, 256
// to 16384 segments, tolerance 1e-9.
//
// CSV on the standard output: kind (call on the final grid, exchange, whole solve), n, objective, the optimum
// computed independently (an LP solver with exchange, ten digits), its relative difference, seconds, rounds,
// iterations. `status` of a whole solve is its verdict.
#include "benchmarks/parts/backend_runs.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "report/csv/csv_line.hpp"

#include <cmath>
#include <cstdio>
#include <exception>
#include <map>

namespace camopt::benchmarks {

namespace {

constexpr int repeats = 5;
constexpr double slow_seconds = 4.0;  // slower runs are timed less often

/// Continuous optima from HiGHS with exchange, weights and references of drd_scene().
const std::map<int, double> independent_optima = {
    {128, 0.9373927539},  {256, 0.9372204408},  {512, 0.9372090807},  {1024, 0.9371969944},
    {2048, 0.9371965704}, {4096, 0.9371964916}, {16384, 0.9371963733}};

void print_line(const std::string& kind, int segments, const WayFigures& figures) {
    const RunOutcome& last = figures.last;
    const auto known = independent_optima.find(segments);
    const double optimum = known != independent_optima.end() ? known->second : std::nan("");
    CsvLine line;
    line.words(kind).count(segments).words(last.status).number(last.objective).number(optimum);
    line.number((last.objective - optimum) / optimum);
    line.number(figures.median_seconds).number(figures.least_seconds).count(figures.repeats);
    line.count(last.rounds).count(last.iterations);
    std::fputs(line.finish().c_str(), stdout);
    std::fflush(stdout);
}

void measure_kind(const std::string& kind, int segments, const std::function<RunOutcome()>& once) {
    const auto repeated = [&](int count) {
        return run_in_turns(std::vector<TimedWay>{{kind, [&] { return steadied(once); }}}, count).front();
    };
    const WayFigures first = repeated(1);
    print_line(kind, segments, first.median_seconds > slow_seconds ? first : repeated(repeats));
    std::fprintf(stderr, "growth_of_time: n = %d, %s\n", segments, kind.c_str());
}

void print_table() {
    std::puts(
        "kind,n,status,objective,independent_optimum,relative_difference,seconds_median,seconds_min,repeats,"
        "rounds,iterations");
    const BackendTask task{{"structured", "default", {}}};
    for (const int segments : {128, 256, 512, 1024, 2048, 4096, 8192, 16384}) {
        const Scene scene = drd_scene(3, segments);
        const FinalGrid grid = final_grid(scene, 1e-9);
        measure_kind("call", segments, [&] { return run_call(grid.problem, task); });
        measure_kind("exchange", segments, [&] { return run_exchange(scene, task); });
        measure_kind("solve", segments, [&] { return run_solve(scene, task); });
    }
}

}  // namespace

}  // namespace camopt::benchmarks

int main() {
    const camopt::benchmarks::WholeOutput output;
    try {
        camopt::benchmarks::print_table();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "growth_of_time: %s\n", error.what());
        return 1;
    }
}

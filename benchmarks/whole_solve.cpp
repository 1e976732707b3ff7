// SPDX-License-Identifier: MIT
// whole_solve [SEGMENTS]: what a whole solve() costs (choice of the backend, exchange, proof, tie-break,
// report, audit) against one call of the interior point on the grid that its exchange ends with, in turns in
// one run.
//
// DRD cubic scenes with 12 to 1024 segments and scenes with a cam whose rules are all linear; the scene is at
// hand, nothing is read or written. CSV on the standard output: `ratio` is whole solve over call, `target` at
// most how much is asked for; `relative_error` that of the whole solve against the optimum, exchanged at
// 1e-10 without a tie-break. The phases (Solution::phases) are those of the quickest solve.
#include "benchmarks/cam/cam_case.hpp"
#include "benchmarks/parts/backend_runs.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "report/csv/csv_line.hpp"
#include "scene/cost_table.hpp"
#include "studies/solve/solve.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <string_view>

namespace camopt::benchmarks {

namespace {

constexpr int repeats = 5;
constexpr double reference_tolerance = 1e-10;
constexpr double target_small = 3.0, target_large = 4.0, target_cam = 6.0;
constexpr int large_segments = 256;

struct WholeCase {
    std::string name;
    int segments = 0;
    double target = 0.0;
    Scene scene;
};

std::vector<WholeCase> whole_cases() {
    std::vector<WholeCase> all;
    for (const int segments : {12, 20, 32, 64, 256, 1024}) {
        Scene scene = drd_scene(3, segments);
        scene.spline.design = DesignKind::automatic;
        scene.solver.name = "auto";
        all.push_back(
            {"DRD cubic", segments, segments < large_segments ? target_small : target_large, scene});
    }
    for (const CamCase& one : cam_cases())
        if (one.name == "pressure angle 40 mm" && one.segments <= 64)
            all.push_back({one.name, one.segments, target_cam, one.scene});
    for (WholeCase& one : all) one.scene.objective.tie_break = TieBreak::rms_jerk;
    return all;
}

struct QuickestPhases {
    double seconds = infinity;  ///< of the whole solve
    PhaseSeconds phases;
};

RunOutcome run_whole(const Scene& scene, QuickestPhases& quickest) {
    const auto begin = std::chrono::steady_clock::now();
    const Solution solution = solve(scene);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (seconds < quickest.seconds) quickest = {seconds, solution.phases};
    return {name_of(solution.certificate.verdict), seconds, solution.certificate.objective,
            solution.solver.iterations, solution.solver.exchange_rounds};
}

void measure(const WholeCase& one) {
    Scene plain = one.scene;
    plain.objective.tie_break = TieBreak::none;
    const FinalGrid reference = final_grid(plain, reference_tolerance);
    const FinalGrid grid = final_grid(plain, one.scene.solver.tolerance);
    const BackendTask task{{"structured", "default", {}}, one.scene.solver.tolerance};
    QuickestPhases quickest;
    const std::vector<TimedWay> ways = {
        {"call", [&] { return steadied([&] { return run_call(grid.problem, task); }); }},
        {"solve", [&] { return steadied([&] { return run_whole(one.scene, quickest); }); }}};
    const std::vector<WayFigures> figures = run_in_turns(ways, repeats);
    const RunOutcome& call = figures[0].last;
    const RunOutcome& whole = figures[1].last;
    const double ratio = figures[1].median_seconds / figures[0].median_seconds;
    CsvLine line;
    line.words(one.name).count(one.segments).words(whole.status).number(whole.objective);
    line.number((whole.objective - reference.objective) / reference.objective);
    line.number(figures[1].median_seconds).number(figures[1].least_seconds);
    line.number(figures[0].median_seconds).number(figures[0].least_seconds).count(repeats);
    line.count(whole.iterations).count(whole.rounds).count(call.iterations);
    line.number(ratio).number(one.target);
    for (const PhaseRow& phase : phase_rows) line.number(quickest.phases.*phase.seconds);
    std::fputs(line.finish().c_str(), stdout);
    std::fflush(stdout);
}

void print_table(std::string_view only) {
    std::string titles =
        "case,n,verdict,objective,relative_error,seconds_solve_median,seconds_solve_min,seconds_call_median,"
        "seconds_call_min,repeats,iterations,rounds,iterations_call,ratio,target";
    for (const PhaseRow& phase : phase_rows) titles += std::string(",seconds_") + phase.name;
    std::puts(titles.c_str());
    for (const WholeCase& one : whole_cases())
        if (only.empty() || only == std::to_string(one.segments)) measure(one);
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    try {
        camopt::benchmarks::print_table(count > 1 ? words[1] : "");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "whole_solve: %s\n", error.what());
        return 1;
    }
}

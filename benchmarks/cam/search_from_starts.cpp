// SPDX-License-Identifier: MIT
// search_from_starts SCENES [SOLVER …]: the searches of disk cams whose rules are not convex, without the
// bound over boxes, by the structured solver and by Ipopt, from the same 8 starts, in turns in one run.
//
// The starts are the smoothest motion and random ones; the grid that one search ends with is the next one's.
// CSV on the standard output: `objective` is the best of the starts that keep the limits to 1e-8, `ratio` the
// seconds by those of the structured solver (target: at least 20), `excess` by how much the structured
// solver's best lies above that of the row, relative (target: at most 1e-7).
#include "benchmarks/parts/paired_runs.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "report/csv/csv_line.hpp"
#include "solvers/registry.hpp"
#include "studies/search/start_search.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <exception>

namespace camopt::benchmarks {

namespace {

constexpr int starts = 8, repeats = 5;
constexpr unsigned seed = 1;
constexpr double tolerance = 1e-8, most_seconds = 20.0, target_ratio = 20.0, target_excess = 1e-7;

struct SearchCase {
    std::string name;
    Scene scene;
};

/// A rise between dwells with a roller on the axis; lengths in mm, angles in degrees.
SearchCase roller_case(double lift, double rise, double base, double roller, double pressure, double radius,
                       int segments) {
    const std::string text = fmt::format(R"(
[motion]
type = "DRD"
lift_mm = {}
rise_deg = {}
[spline]
segments = {}
[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = {}
roller_radius_mm = {}
[limits]
pressure_angle_deg = {}
cam_radius_min_mm = {}
)",
                                         lift, rise, segments, base, roller, pressure, radius);
    return {fmt::format("roller {} mm in {} deg", lift, rise),
            input::read_scene(text, "roller", known_names())};
}

/// Those of docs/method.md, at three numbers of segments; a rise and return; a face on an arm.
std::vector<SearchCase> search_cases(const std::string& scenes) {
    std::vector<SearchCase> all;
    for (const int segments : {12, 24, 48}) {
        all.push_back(roller_case(15, 50, 22, 8, 34, 7, segments));
        all.push_back(roller_case(20, 60, 26, 10, 35, 13, segments));
        all.push_back(roller_case(10, 45, 20, 9, 30, 5, segments));
    }
    for (const char* name : {"cam_undercut", "cam_arm_flat"})
        all.push_back({name, input::read_scene_file(fmt::format("{}/{}.toml", scenes, name), known_names())});
    return all;
}

/// All starts, one after the other.
RunOutcome searched(const CamModel& model, const std::string& solver_name) {
    const auto solver = make_solver(solver_name);
    ExchangeOptions options;
    options.tolerance = options.backend.tolerance = tolerance;
    options.backend.max_seconds = most_seconds;
    const JudgeOptions judge{tolerance};
    const SolveControl control;
    StartSearch search(CamProblem(model), *solver, options, judge, control);
    const auto begin = std::chrono::steady_clock::now();
    search.run(0, starts, seed, {});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return {search.found() ? "feasible" : "no feasible point", seconds,
            search.found() ? search.best().found.objective : infinity, search.totals().iterations,
            search.totals().rounds};
}

void print_rows(const SearchCase& one, const std::vector<std::string>& solvers) {
    const CamModel model = scene_model(one.scene, DesignKind::states, reference_peaks(one.scene));
    std::vector<TimedWay> ways;
    for (const std::string& name : solvers)
        ways.push_back({name, [&model, name] { return searched(model, name); }});
    const std::vector<WayFigures> figures = run_in_turns(ways, repeats);
    const double own = figures.front().last.objective;
    for (std::size_t k = 0; k < ways.size(); ++k) {
        const RunOutcome& last = figures[k].last;
        CsvLine line;
        line.words(one.name).count(one.scene.spline.segments).words(ways[k].name).words(last.status);
        line.number(last.objective).number((own - last.objective) / last.objective).number(target_excess);
        line.count(last.iterations).count(last.rounds).number(figures[k].median_seconds);
        line.number(figures[k].median_seconds / figures.front().median_seconds).number(target_ratio);
        std::fputs(line.finish().c_str(), stdout);
    }
    std::fflush(stdout);
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    using namespace camopt::benchmarks;
    if (count < 2) {
        std::fputs("search_from_starts SCENES [SOLVER …]: the folder of the example scenes\n", stderr);
        return 2;
    }
    try {
        std::puts(
            "scene,segments,solver,status,objective,excess,target_excess,iterations,rounds,seconds_median,"
            "ratio,"
            "target_ratio");
        std::vector<std::string> solvers(words + 2, words + count);
        if (solvers.empty()) solvers = {"structured", "ipopt"};
        for (const SearchCase& one : search_cases(words[1])) print_rows(one, solvers);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "search_from_starts: %s\n", error.what());
        return 1;
    }
}

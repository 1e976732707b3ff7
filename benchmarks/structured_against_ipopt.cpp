// SPDX-License-Identifier: MIT
// structured_against_ipopt: how many times faster the structured solver is than Ipopt at its best, on the
// same DRD cubic scenes, to the same accuracy, in one run.
//
// Ipopt tries every variant (solver_variants.hpp) at tolerances 1e-9 and 1e-10 once on the final grid; those
// that come within 1e-8 of the optimum and are quickest run against the structured solver in turns: the call
// on the final grid, the exchange, the whole library solve (up to 256 segments). CSV on the standard output.
// `ratio`: seconds by those of the structured solver; `eligible`: error within 1e-8. Progress goes to stderr.
#include "benchmarks/parts/backend_runs.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "report/csv/csv_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

namespace camopt::benchmarks {

namespace {

constexpr double reference_tolerance = 1e-10, accuracy = 1e-8;
constexpr int repeats = 5, least_candidates = 2;
constexpr double scout_seconds = 20.0;
constexpr int most_segments_of_solve = 256;  // Ipopt would take a minute or more

struct Contest {
    Scene scene;
    FinalGrid grid;

    [[nodiscard]] double error_of(double objective) const {
        return (objective - grid.objective) / grid.objective;
    }
    [[nodiscard]] bool is_accurate(double objective) const {
        return std::abs(error_of(objective)) <= accuracy;
    }
};

void print_line(const Contest& contest, const std::string& kind, const BackendTask& task,
                const WayFigures& figures, double structured_seconds) {
    const RunOutcome& last = figures.last;
    CsvLine line;
    line.count(contest.scene.spline.segments).words(kind).words(task.variant.solver);
    line.words(task.variant.words).number(task.tolerance).words(last.status);
    line.number(last.objective).number(contest.error_of(last.objective));
    line.words(contest.is_accurate(last.objective) ? "yes" : "no");
    line.number(figures.median_seconds).number(figures.least_seconds).count(figures.repeats);
    line.count(last.iterations).count(last.rounds);
    line.number(structured_seconds > 0.0 ? figures.median_seconds / structured_seconds : std::nan(""));
    std::fputs(line.finish().c_str(), stdout);
    std::fflush(stdout);
}

/// Ipopt's variants, the quickest accurate ones first.
std::vector<BackendTask> scouted(const Contest& contest) {
    struct Scout {
        BackendTask task;
        double seconds;
    };
    std::vector<Scout> scouts;
    for (const SolverVariant& variant : solver_variants()) {
        if (variant.solver != "ipopt") continue;
        for (const double tolerance : {1e-9, 1e-10}) {
            const BackendTask task{variant, tolerance, scout_seconds};
            const RunOutcome outcome = run_call(contest.grid.problem, task);
            print_line(contest, "scout", task, {outcome, outcome.seconds, outcome.seconds, 1}, 0.0);
            if (contest.is_accurate(outcome.objective)) scouts.push_back({task, outcome.seconds});
        }
    }
    std::ranges::sort(scouts, {}, &Scout::seconds);
    std::vector<BackendTask> tasks;
    for (Scout& scout : scouts) tasks.push_back(std::move(scout.task));
    return tasks;
}

using Runner = std::function<RunOutcome(const BackendTask&)>;

/// The structured solver and the quickest of Ipopt's that stay accurate in this kind of run too.
void compare(const Contest& contest, const std::string& kind, const std::vector<BackendTask>& candidates,
             const Runner& runner) {
    std::vector<BackendTask> tasks = {{{"structured", "default", {}}, 1e-9}};
    for (const BackendTask& candidate : candidates) {
        if (static_cast<int>(tasks.size()) > least_candidates) break;
        if (contest.is_accurate(runner(candidate).objective)) tasks.push_back(candidate);
    }
    std::vector<TimedWay> ways;
    for (const BackendTask& task : tasks)
        ways.push_back({task.variant.words, [&] { return steadied([&] { return runner(task); }); }});
    const std::vector<WayFigures> figures = run_in_turns(ways, repeats);
    for (std::size_t k = 0; k < tasks.size(); ++k)
        print_line(contest, kind, tasks[k], figures[k], figures.front().median_seconds);
    std::fprintf(stderr, "structured_against_ipopt: n = %d, %s\n", contest.scene.spline.segments,
                 kind.c_str());
}

void print_table() {
    std::puts(
        "n,kind,solver,variant,tolerance,status,objective,relative_error,eligible,seconds_median,seconds_min,"
        "repeats,iterations,rounds,ratio");
    for (const int segments : {12, 64, 256, 1024}) {
        const Scene scene = drd_scene(3, segments);
        const Contest contest{scene, final_grid(scene, reference_tolerance)};
        const std::vector<BackendTask> candidates = scouted(contest);
        compare(contest, "call", candidates,
                [&](const BackendTask& task) { return run_call(contest.grid.problem, task); });
        compare(contest, "exchange", candidates,
                [&](const BackendTask& task) { return run_exchange(scene, task); });
        if (segments > most_segments_of_solve) continue;
        compare(contest, "solve", candidates,
                [&](const BackendTask& task) { return run_solve(scene, task); });
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
        std::fprintf(stderr, "structured_against_ipopt: %s\n", error.what());
        return 1;
    }
}

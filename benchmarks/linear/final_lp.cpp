// SPDX-License-Identifier: MIT
// final_lp ACTION DEGREE SEGMENTS FOLDER: the linear program on which the exchange of a DRD scene ended, for
// solvers of linear programs to be compared on.
//
// export: writes FOLDER/lp_DEGREE_SEGMENTS_DESIGN.txt (linear_program_text.hpp) over states and coefficients.
// structured, rivals: CSV rows of the structured solver; of Ipopt and Clp, on the standard output.
// judge:  for every FOLDER/x_DEGREE_SEGMENTS_DESIGN_*.txt (one number a line) one line: file, true objective
//         of its curve. linear_programs.py calls them all.
// versions: the version of Clp, nothing where this build has none.
// Timed is the call of the solver on numbers made beforehand.
#include "benchmarks/linear/clp_rival.hpp"
#include "benchmarks/linear/linear_program_text.hpp"
#include "benchmarks/parts/backend_runs.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/text/text_file.hpp"
#include "report/csv/csv_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace camopt::benchmarks {

namespace {

constexpr double exchange_tolerance = 1e-10;
// Rivals have several tolerances too; the quickest way within 1e-8 of the optimum counts.
const std::vector<double> own_tolerances = {1e-7, 1e-8, 1e-9}, ipopt_tolerances = {1e-9};
constexpr double most_seconds = 10.0, slow_seconds = 0.6;
constexpr int repeats = 5;
// Beyond, it loses its way or its Cholesky factor fills up, and it does not mind its time limit.
constexpr int most_barrier_segments = 12;
constexpr std::array designs = {DesignKind::states, DesignKind::coefficients};

struct Task {
    int degree = 3, segments = 0;
    std::filesystem::path folder;
};

struct Row {
    std::string program, method;
    DesignKind design = DesignKind::states;
};

/// Repeats a run and prints its row; a slow one is timed once.
void print_row(const Task& task, const Row& row, const NlpShape& shape,
               const std::function<RunOutcome()>& once) {
    std::vector<double> seconds;
    RunOutcome last;
    do {
        last = once();
        seconds.push_back(last.seconds);
    } while (seconds.front() < slow_seconds && static_cast<int>(seconds.size()) < repeats);
    CsvLine line;
    line.words(row.program).words(row.method).words(name_of(row.design)).count(task.degree);
    line.count(task.segments).words(last.status).number(last.objective);
    line.number(median(seconds)).number(*std::ranges::min_element(seconds));
    line.count(static_cast<long>(seconds.size())).count(last.iterations);
    line.count(shape.variables()).count(shape.constraints()).count(shape.jacobian.size());
    std::fputs(line.finish().c_str(), stdout);
    std::fflush(stdout);
}

RunOutcome clp_outcome(const CamProblem& problem, const LinearProgram& program, const std::string& method) {
    const RivalRun run = run_clp(program, method, most_seconds);
    const bool useful = run.x.size() > 0 && run.x.allFinite();
    return {run.status, run.seconds, useful ? problem.objective(run.x) : infinity, run.iterations};
}

void time_backends(const Task& task, bool structured) {
    const Scene scene = drd_scene(task.degree, task.segments);
    const FinalGrid grid = final_grid(scene, exchange_tolerance);
    for (const SolverVariant& variant : solver_variants()) {
        if ((variant.solver == "structured") != structured) continue;
        for (const double tolerance : structured ? own_tolerances : ipopt_tolerances)
            print_row(task, {variant.solver, fmt::format("{}, {:.0e}", variant.words, tolerance)},
                      grid.problem.grid().shape(), [&] {
                          return steadied([&] {
                              return run_call(grid.problem, {variant, tolerance, most_seconds});
                          });
                      });
    }
    if (structured) return;
    for (const DesignKind design : designs) {
        const CamProblem problem = rewritten(grid, scene, design);
        const LinearProgram program = linear_program(problem.grid());
        for (const std::string& method : clp_methods()) {
            if (method.starts_with("barrier") && task.segments > most_barrier_segments) continue;
            print_row(task, {"Clp", method, design}, problem.grid().shape(),
                      [&] { return steadied([&] { return clp_outcome(problem, program, method); }); });
        }
    }
}

std::string stem(const Task& task, const char* letter, DesignKind design) {
    return fmt::format("{}_{}_{}_{}", letter, task.degree, task.segments, name_of(design));
}

void export_all(const Task& task) {
    const Scene scene = drd_scene(task.degree, task.segments);
    const FinalGrid grid = final_grid(scene, exchange_tolerance);
    for (const DesignKind design : designs) {
        const CamProblem problem = rewritten(grid, scene, design);
        write_text_file(task.folder / (stem(task, "lp", design) + ".txt"),
                        linear_program_text(linear_program(problem.grid())));
    }
    fmt::print("{:.17g}\n", grid.objective);
}

Eigen::VectorXd numbers_of(const std::filesystem::path& file, Eigen::Index size) {
    std::istringstream text(read_text_file(file));
    Eigen::VectorXd x(size);
    std::string word;
    for (double& entry : x) {
        const std::optional<double> value = text >> word ? number_in(word) : std::nullopt;
        if (!value) return {};
        entry = *value;
    }
    return x;
}

void judge_all(const Task& task) {
    const Scene scene = drd_scene(task.degree, task.segments);
    const FinalGrid grid = final_grid(scene, exchange_tolerance);
    for (const DesignKind design : designs) {
        const CamProblem problem = rewritten(grid, scene, design);
        for (const auto& entry : std::filesystem::directory_iterator(task.folder)) {
            const std::string name = entry.path().filename();
            if (!name.starts_with(stem(task, "x", design) + "_")) continue;
            const Eigen::VectorXd x = numbers_of(entry.path(), problem.grid().shape().variables());
            const double objective = x.size() > 0 ? problem.objective(x) : std::nan("");
            fmt::print("{} {:.17g}\n", name, objective);
        }
    }
}

void run(const std::string& action, const Task& task) {
    if (action == "export") return export_all(task);
    if (action == "structured") return time_backends(task, true);
    if (action == "rivals") return time_backends(task, false);
    if (action == "judge") return judge_all(task);
    if (action == "versions") return fmt::print("{}\n", clp_version());
    throw InputError("allowed are export, structured, rivals, judge and versions, found " + action);
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    const camopt::benchmarks::WholeOutput output;
    if (count != 5) {
        std::fputs("usage: final_lp export|structured|rivals|judge|versions DEGREE SEGMENTS FOLDER\n",
                   stderr);
        return 2;
    }
    try {
        camopt::benchmarks::run(words[1], {std::atoi(words[2]), std::atoi(words[3]), words[4]});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "final_lp: %s\n", error.what());
        return 1;
    }
}

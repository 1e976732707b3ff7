// SPDX-License-Identifier: MIT
// camshape_table: every backend of this build on the valve cam of COPS (camshape.hpp), n = 100 … 800, from
// the straight line. CSV on the standard output, a line a backend and n: what the backend said, seconds
// (median of three, or one where it takes long), objective, how far above the proved optimum (relative),
// largest violation, iterations. What a backend does not find in its seconds stays in the table.
#include "benchmarks/outside/camshape.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "benchmarks/parts/whole_output.hpp"
#include "report/csv/csv_line.hpp"
#include "solvers/registry.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double most_seconds = 20.0, long_run = 3.0;
constexpr int repeats = 3;

void run(const SolverEntry& entry, const CamshapeOptimum& optimum) {
    const Camshape problem(optimum.radii);
    BackendOptions options;
    options.max_seconds = most_seconds;
    if (!entry.needs_derivatives) options.max_iterations = 1'000'000;
    std::vector<double> seconds;
    BackendResult result;
    for (int i = 0; i < repeats && (seconds.empty() || seconds.back() < long_run); ++i) {
        const Clock::time_point begin = Clock::now();
        result = make_solver(entry.name)->minimize(problem, problem.straight_line(), options, {});
        seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    CsvLine line;
    line.count(optimum.radii)
        .words(entry.name)
        .words(name_of(result.termination))
        .words(result.native_status);
    line.number(median(seconds));
    if (result.x.size() > 0) {
        const double cost = problem.cost(result.x);
        line.number(cost).number((cost - optimum.cost) / std::abs(optimum.cost));
        line.number(violation_of(problem, result.x));
    } else {
        line.words("").words("").words("");
    }
    fmt::print("{}", line.count(result.iterations).finish());
    std::fflush(stdout);
}

}  // namespace

}  // namespace camopt::benchmarks

int main() {
    const camopt::benchmarks::WholeOutput output;
    fmt::print(
        "n,solver,termination,native_status,seconds_median,objective,above_optimum,violation,iterations\n");
    for (const camopt::benchmarks::CamshapeOptimum& optimum : camopt::benchmarks::camshape_optima())
        for (const camopt::SolverEntry& entry : camopt::solver_entries()) {
            // The methods without derivatives or for few variables show at n = 100 what they can do.
            const bool for_many = entry.name == "structured" || entry.name == "ipopt";
            if (entry.available && !entry.needs_convex && (for_many || optimum.radii == 100))
                camopt::benchmarks::run(entry, optimum);
        }
    return 0;
}

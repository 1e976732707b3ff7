// SPDX-License-Identifier: MIT
#include "benchmarks/parts/backend_runs.hpp"

#include "benchmarks/parts/measurement.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange/exchange.hpp"
#include "solvers/registry.hpp"
#include "studies/search/planned_solve.hpp"

#include <chrono>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double steady_seconds = 0.02;
constexpr int most_steady_runs = 15;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

BackendOptions options_of(const BackendTask& task) {
    BackendOptions options;
    options.tolerance = task.tolerance;
    options.max_seconds = task.max_seconds;
    options.native = task.variant.options;
    return options;
}

double objective_at(const CamProblem& problem, const Eigen::VectorXd& x) {
    return x.size() > 0 && x.allFinite() ? problem.objective(x) : infinity;
}

}  // namespace

RunOutcome run_call(const CamProblem& problem, const BackendTask& task) {
    const auto solver = make_solver(task.variant.solver);
    const BackendOptions options = options_of(task);
    const Eigen::VectorXd start = problem.start();
    const Clock::time_point begin = Clock::now();
    const BackendResult result = solver->minimize(problem.grid(), start, options, {});
    const double seconds = seconds_since(begin);
    return {name_of(result.termination), seconds, objective_at(problem, result.x), result.iterations, 1};
}

RunOutcome run_exchange(const Scene& scene, const BackendTask& task) {
    CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
    const auto solver = make_solver(task.variant.solver);
    ExchangeOptions options;
    options.backend = options_of(task);
    options.tolerance = task.tolerance;
    const Eigen::VectorXd start = problem.start();
    const Clock::time_point begin = Clock::now();
    const ExchangeResult result = minimize_by_exchange(problem, *solver, start, options, {});
    const double seconds = seconds_since(begin);
    return {name_of(result.termination), seconds, result.best.objective, result.iterations, result.rounds};
}

RunOutcome run_solve(Scene scene, const BackendTask& task) {
    scene.solver.name = task.variant.solver;
    scene.solver.options = task.variant.options;
    scene.solver.tolerance = task.tolerance;
    scene.solver.max_seconds = task.max_seconds;
    scene.spline.design = DesignKind::states;
    const Clock::time_point begin = Clock::now();
    const Solution solution = solve_without_explaining(scene, {});
    const double seconds = seconds_since(begin);
    return {name_of(solution.certificate.verdict), seconds, solution.certificate.objective,
            solution.solver.iterations, solution.solver.exchange_rounds};
}

RunOutcome steadied(const std::function<RunOutcome()>& once) {
    RunOutcome outcome = once();
    std::vector<double> seconds = {outcome.seconds};
    double spent = outcome.seconds;
    while (spent < steady_seconds && static_cast<int>(seconds.size()) < most_steady_runs) {
        outcome = once();
        seconds.push_back(outcome.seconds);
        spent += outcome.seconds;
    }
    outcome.seconds = median(seconds);
    return outcome;
}

}  // namespace camopt::benchmarks

// SPDX-License-Identifier: MIT
#include "benchmarks/parts/measurement.hpp"

#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange/exchange.hpp"
#include "solvers/registry.hpp"
#include "studies/search/planned_solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

/// One exchange on a fresh problem; the problem is made before the watch starts.
double seconds_of_one_run(const Scene& scene) {
    CamProblem problem(scene_model(scene, scene.spline.design, reference_peaks(scene)));
    const auto solver = make_solver(scene.solver.name);
    const ExchangeOptions options = exchange_options(scene);
    const Eigen::VectorXd start = problem.start();
    const Clock::time_point begin = Clock::now();
    const ExchangeResult result = minimize_by_exchange(problem, *solver, start, options, {});
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return result.rounds > 0 ? seconds : std::nan("");
}

void take_times(Measurement& row, const Scene& scene, const TimingPlan& plan) {
    std::vector<double> seconds = {seconds_of_one_run(scene)};
    double spent = seconds.front();
    const auto enough = [&] {
        const int repeats = static_cast<int>(seconds.size());
        if (seconds.front() > plan.slow || repeats >= plan.most_repeats) return true;
        return repeats >= plan.least_repeats && spent > plan.series_seconds;
    };
    while (!enough()) {
        seconds.push_back(seconds_of_one_run(scene));
        spent += seconds.back();
    }
    row.repeats = static_cast<int>(seconds.size());
    row.seconds_median = median(seconds);
    row.seconds_min = *std::ranges::min_element(seconds);
}

}  // namespace

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Measurement not_measured(const Combination& combination, const std::string& status) {
    Measurement row;
    row.combination = combination;
    row.status = status;
    return row;
}

Measurement measure(const Combination& combination, const TimingPlan& plan) {
    Measurement row = not_measured(combination, "");
    const Scene scene = scene_of(combination, plan.most_seconds);
    const Solution solution = solve_without_explaining(scene, {});
    const Certificate& certificate = solution.certificate;
    row.status = name_of(solution.solver.termination);
    row.verdict = name_of(certificate.verdict);
    row.reason = name_of(certificate.reason);
    row.proved_gap = certificate.gap;
    if (std::isfinite(certificate.objective)) row.objective = certificate.objective;
    row.iterations = solution.solver.iterations;
    row.rounds = solution.solver.exchange_rounds;
    row.counts = solution.evaluations;
    if (certificate.verdict == Verdict::infeasible)
        return row;  // nothing to time: no curve fits the conditions
    if (row.timed_out()) {
        row.repeats = 1;
        row.seconds_median = row.seconds_min = solution.seconds_solve;
        return row;
    }
    take_times(row, scene, plan);
    return row;
}

}  // namespace camopt::benchmarks

// SPDX-License-Identifier: MIT
#include "benchmarks/cam/cam_measurement.hpp"

#include "studies/search/planned_solve.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::benchmarks {

namespace {

void take_times(CamMeasurement& row, const Scene& scene, const TimingPlan& plan, double first) {
    std::vector<double> seconds = {first};
    double spent = first;
    const auto enough = [&] {
        const int repeats = static_cast<int>(seconds.size());
        if (first > plan.slow || repeats >= plan.most_repeats) return true;
        return repeats >= plan.least_repeats && spent > plan.series_seconds;
    };
    while (!enough()) {
        seconds.push_back(solve_without_explaining(scene, {}).seconds_solve);
        spent += seconds.back();
    }
    row.repeats = static_cast<int>(seconds.size());
    row.seconds_median = median(seconds);
    row.seconds_min = *std::ranges::min_element(seconds);
}

void take_outcome(CamMeasurement& row, const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    row.termination = name_of(solution.solver.termination);
    row.verdict = name_of(certificate.verdict);
    row.reason = name_of(certificate.reason);
    row.convex = solution.solver.convex;
    row.proved_gap = certificate.gap;
    if (std::isfinite(certificate.objective)) row.objective = certificate.objective;
    if (std::isfinite(certificate.worst_violation)) row.worst_violation = certificate.worst_violation;
    row.iterations = solution.solver.iterations;
    row.rounds = solution.solver.exchange_rounds;
    row.starts = solution.solver.starts;
    row.counts = solution.evaluations;
}

}  // namespace

CamMeasurement not_measured(const CamCase& one, const CamBackend& backend, const std::string& termination) {
    CamMeasurement row;
    row.scene = one.name;
    row.segments = one.segments;
    row.backend = backend;
    row.termination = termination;
    return row;
}

CamMeasurement measure(const CamCase& one, const CamBackend& backend, const TimingPlan& plan) {
    CamMeasurement row = not_measured(one, backend, "");
    Scene scene = one.scene;
    scene.solver.name = backend.solver;
    scene.solver.options = backend.options;
    scene.solver.max_seconds = plan.most_seconds;
    const Solution solution = solve_without_explaining(scene, {});
    take_outcome(row, solution);
    take_times(row, scene, plan, solution.seconds_solve);
    return row;
}

}  // namespace camopt::benchmarks

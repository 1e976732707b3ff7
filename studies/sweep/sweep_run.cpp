// SPDX-License-Identifier: MIT
#include "studies/sweep/sweep_run.hpp"

#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace camopt {

namespace {

std::optional<double> finite(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? value : std::nullopt;
}

void set_figures(SweepRow& row, const Peaks& peaks) {
    for (const CostTerm& term : cost_terms())
        row.figures[static_cast<std::size_t>(term.figure)] = finite(term.measured.of(peaks));
}

void set_train(SweepRow& row, const TrainReport& train) {
    if (train.residual) row.train.residual = finite(train.residual->value);
    if (train.acceleration) row.train.dynamic_acceleration = finite(train.acceleration->value);
    if (train.least_force) row.train.contact_force = finite(train.least_force->value);
}

void set_cam(SweepRow& row, const CamSummary& cam) {
    row.cam.pressure_angle = finite(cam.pressure_angle.value);
    if (cam.convex_radius) row.cam.convex_radius = finite(cam.convex_radius->value);
    if (cam.concave_radius) row.cam.concave_radius = finite(cam.concave_radius->value);
}

void set_dimensions(SweepRow& row, const Solution& solution) {
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        const Dimension* const own = solution.scene.cam->find(index);
        if (own != nullptr && own->is_variable())
            row.dimensions[static_cast<std::size_t>(i)] =
                finite(delivered_dimension(solution, index).value());
    }
}

}  // namespace

SweepRow sweep_row(int number, std::span<const double> settings, const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    SweepRow row;
    row.number = number;
    row.settings.assign(settings.begin(), settings.end());
    row.verdict = certificate.verdict;
    row.reason = name_of(certificate.reason);
    row.lower_bound = finite(certificate.lower_bound);
    row.gap = finite(certificate.gap);
    if (solution.any_curve_limit) row.any_curve_limit = finite(solution.any_curve_limit->objective);
    if (solution.motion && row.is_feasible()) {
        row.objective = finite(certificate.objective);
        set_figures(row, solution.peaks);
        if (solution.cam) {
            set_dimensions(row, solution);
            set_cam(row, solution.cam->summary);
        }
        if (solution.train) set_train(row, *solution.train);
        for (const ConstraintReport& limit : solution.constraints)
            if (limit.active) row.active_limits.push_back(limit.key);
    }
    row.proved_from = solution.solver.proved_from;
    row.iterations = solution.solver.iterations;
    row.exchange_rounds = solution.solver.exchange_rounds;
    row.evaluations = solution.evaluations;
    row.seconds_solve = solution.seconds_solve;
    row.seconds_total = solution.seconds_total;
    return row;
}

SweepRow failed_row(int number, std::span<const double> settings, std::string_view reason) {
    SweepRow row;
    row.number = number;
    row.settings.assign(settings.begin(), settings.end());
    row.reason = reason;
    return row;
}

int chunk_size_for(SweepScenes& scenes) {
    constexpr int segments_of_a_chunk = 16'000;
    const SweepPlan& plan = scenes.plan();
    int most = default_chunk_size;
    if (plan.rows() > least_chunks * most && is_weight_key(plan.keys.back())) {
        const Scene& first = scenes.scene(0);
        const int segments = std::max(1, segments_of(first.spline));
        if (camopt::plan(first).convex)
            most = std::clamp(segments_of_a_chunk / segments, default_chunk_size, weight_chunk_size);
    }
    return std::clamp((plan.rows() + least_chunks - 1) / least_chunks, 1, most);
}

std::vector<SweepRow> solve_chunk(SweepScenes& scenes, RowRange rows, const SolveControl& control,
                                  const std::function<void(const SweepRow&)>& row_done,
                                  const std::function<void(int row, const Solution&)>& found) {
    std::vector<SweepRow> solved;
    KnownSolutions known;
    for (int number = rows.begin; number < rows.end && !control.stopped(); ++number) {
        const std::span<const double> settings = scenes.plan().row(number);
        known.number = number;
        try {
            const Solution solution = solve_without_explaining(scenes.scene(number), control, &known);
            solved.push_back(sweep_row(number, settings, solution));
            if (found && !control.stopped()) found(number, solution);
        } catch (const std::exception& error) {
            solved.push_back(failed_row(number, settings, fmt::format("error: {}", error.what())));
            known = {};
        }
        if (row_done) row_done(solved.back());
    }
    return solved;
}

std::vector<SweptScene> sweep(const Scene& scene, std::span<const double> values, const SceneSetter& set,
                              const SolveControl& control,
                              const std::function<void(const SweptScene&)>& solved) {
    std::vector<SweptScene> rows;
    KnownSolutions known;
    for (const double value : values) {
        if (control.ending()) break;
        known.number = static_cast<int>(rows.size());
        Scene one = scene;
        set(one, value);
        SweptScene row{value, solve_without_explaining(one, control, &known)};
        if (control.stopped()) break;  // perhaps stopped halfway
        rows.push_back(std::move(row));
        if (solved) solved(rows.back());
    }
    return rows;
}

}  // namespace camopt

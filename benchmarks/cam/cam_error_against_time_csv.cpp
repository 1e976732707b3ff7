// SPDX-License-Identifier: MIT
#include "benchmarks/cam/cam_error_against_time_csv.hpp"

#include "report/csv/csv_line.hpp"

namespace camopt::benchmarks {

namespace {

constexpr int count_cells = 11;

void add_counts(CsvLine& line, const CamMeasurement& row) {
    if (row.verdict.empty()) {
        line.blank(count_cells);
        return;
    }
    line.words(row.convex ? "yes" : "no").count(row.repeats).count(row.iterations).count(row.rounds);
    line.count(row.starts).count(row.counts.cost).count(row.counts.gradient).count(row.counts.constraints);
    line.count(row.counts.jacobian).count(row.counts.hessian).count(row.counts.profile_points);
}

}  // namespace

std::string cam_measurements_csv(std::span<const CamMeasurement> rows) {
    std::string text =
        "scene,n,backend,hessian,verdict,termination,reason,objective,reference,reference_source,"
        "relative_error,proved_gap,worst_violation,seconds_median,seconds_min,convex,repeats,iterations,"
        "exchange_rounds,starts,cost,gradient,constraints,jacobian,hessian_evaluations,profile_points\n";
    for (const CamMeasurement& row : rows) {
        CsvLine line;
        line.words(row.scene).count(row.segments).words(row.backend.solver).words(row.backend.hessian);
        line.words(row.verdict).words(row.termination).words(row.reason);
        line.number(row.objective).number(row.reference).words(row.reference_source);
        line.number(row.relative_error).number(row.proved_gap).number(row.worst_violation);
        line.number(row.seconds_median).number(row.seconds_min);
        add_counts(line, row);
        text += line.finish();
    }
    return text;
}

}  // namespace camopt::benchmarks

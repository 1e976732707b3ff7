// SPDX-License-Identifier: MIT
#include "benchmarks/error_against_time_csv.hpp"

#include "report/csv/csv_line.hpp"

namespace camopt::benchmarks {

namespace {

void add_counts(CsvLine& line, const Measurement& row) {
    if (row.verdict.empty()) {
        line.blank(8);
        return;
    }
    line.count(row.repeats).count(row.iterations).count(row.rounds);
    line.count(row.counts.cost).count(row.counts.gradient).count(row.counts.constraints);
    line.count(row.counts.jacobian).count(row.counts.hessian);
}

}  // namespace

std::string measurements_csv(std::span<const Measurement> rows) {
    std::string text =
        "backend,degree,design,motion,n,tolerance,status,verdict,reason,proved_gap,objective,reference,"
        "reference_"
        "source,"
        "relative_error,seconds_median,seconds_min,repeats,iterations,exchange_rounds,cost,gradient,"
        "constraints,"
        "jacobian,hessian\n";
    for (const Measurement& row : rows) {
        CsvLine line;
        const Combination& combination = row.combination;
        line.words(combination.backend).count(combination.degree).words(name_of(combination.design));
        line.words(motion_name(combination.motion)).count(combination.segments);
        line.number(combination.tolerance);
        line.words(row.status).words(row.verdict).words(row.reason).number(row.proved_gap);
        line.number(row.objective).number(row.reference).words(row.reference_source);
        line.number(row.relative_error).number(row.seconds_median).number(row.seconds_min);
        add_counts(line, row);
        text += line.finish();
    }
    return text;
}

}  // namespace camopt::benchmarks

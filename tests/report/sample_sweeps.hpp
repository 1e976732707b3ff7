// SPDX-License-Identifier: MIT
// Tables of sweeps made by hand, for pictures of them.
#pragma once

#include "report/chart/sweep/sweep_svg.hpp"

#include <string>
#include <utility>
#include <vector>

namespace camopt::test {

/// Optimal, with an objective of `size`; rows of odd numbers are off the front.
inline SweepRow sweep_row(int number, std::vector<double> settings, double size) {
    SweepRow made;
    made.number = number;
    made.settings = std::move(settings);
    made.verdict = Verdict::optimal;
    made.objective = size;
    made.gap = 1e-9;
    made.any_curve_limit = 0.9 * size;
    made.figures = {1.5 + 0.1 * size, 6.0 - 0.2 * size, 50.0 + size, 8.0, 4.0, 30.0};
    made.on_front = number % 2 == 0;
    return made;
}

/// What is left of a row without a result.
inline void empty_row(SweepRow& row, Verdict verdict) {
    SweepRow empty;
    empty.number = row.number;
    empty.settings = row.settings;
    empty.verdict = verdict;
    row = empty;
}

/// Six base radii of a cam; row 0 is infeasible, row 3 failed.
inline SweepTable key_table() {
    SweepTable table;
    table.columns.keys = {"cam.base_radius_mm"};
    table.columns.dimensions = {DimensionIndex::base_radius};
    for (int i = 0; i < 6; ++i) {
        table.rows.push_back(sweep_row(i, {20.0 + i}, 2.0 - 0.1 * i));
        table.rows.back().dimensions[0] = 0.02;
        table.rows.back().cam = {0.5 - 0.02 * i, 0.0127 * i, {}};
    }
    empty_row(table.rows[0], Verdict::infeasible);
    empty_row(table.rows[3], Verdict::failed);
    table.rows[3].reason = "worker died: signal 11 <&>";
    return table;
}

/// The same over two keys, two values by three.
inline SweepTable map_table() {
    SweepTable table = key_table();
    table.columns.keys = {"cam.base_radius_mm", "limits.pressure_angle_deg"};
    for (SweepRow& row : table.rows) row.settings = {20.0 + row.number / 3, 25.0 + row.number % 3};
    return table;
}

inline SweepTable weight_table() {
    SweepTable table;
    table.columns.keys = {"objective.velocity", "objective.acceleration", "objective.jerk"};
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; i + j <= 4; ++j)
            table.rows.push_back(sweep_row(static_cast<int>(table.rows.size()),
                                           {i / 4.0, j / 4.0, (4 - i - j) / 4.0}, 1.0 + i * 0.1 + j * 0.2));
    return table;
}

/// Two laws, one of them on the front within 4 %.
inline LawLosses some_losses() {
    LawLosses losses;
    losses.reference = {1.76, 5.53, 69.0};
    losses.laws.push_back({"near",
                           "Near <law>",
                           {1.7, 5.6, 55.0},
                           true,
                           4.0,
                           ClosestApproach{{0.2, 0.3, 0.5}, 2.5, true},
                           {1.6, 5.5, 40.0}});
    losses.laws.push_back({"far", "Far law", {1.6, 6.0, 500.0}, false, std::nullopt, std::nullopt, {}});
    losses.complete = true;
    return losses;
}

}  // namespace camopt::test

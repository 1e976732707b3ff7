// SPDX-License-Identifier: MIT
// The figures of a sweep's rows that are drawn and tabulated. Private to output/.
#pragma once

#include "output/chart/plot_frame.hpp"
#include "output/chart/value_range.hpp"
#include "studies/sweep/sweep_row.hpp"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace camopt {

struct SweepQuantity {
    std::string title;   ///< "velocity V", "base radius (mm)"
    std::string symbol;  ///< "V"
    std::function<std::optional<double>(const SweepRow&)> value;
};

[[nodiscard]] SweepQuantity objective_quantity();
/// V, A, J.
[[nodiscard]] std::array<SweepQuantity, 3> peak_quantities();
/// The objective, V, A, J, every other figure with a weight, and the variable dimensions.
[[nodiscard]] std::vector<SweepQuantity> drawn_quantities(const SweepTable& table);

/// Over the feasible rows.
[[nodiscard]] ValueRange range_of(std::span<const SweepRow> rows, const SweepQuantity& quantity);

/// An axis over a range with some room, logarithmic where the range spans a large factor: one extreme row
/// must not flatten the rest.
[[nodiscard]] PlotAxis axis_over(const ValueRange& range, double begin, double end);
[[nodiscard]] bool spans_factors(const ValueRange& range);

/// Axis ticks with their labels.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted);

}  // namespace camopt

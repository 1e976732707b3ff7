// SPDX-License-Identifier: MIT
// sweep.svg: the picture of a finished sweep.
//
// Weights of V, A, J alone: the objective and each peak over the triangle of weights, the trade-off in the
// planes V–A, A–J, V–J (front rows coloured by the third peak), and where the classical laws lie above it.
// One other key: lines over it. Two that form a grid: maps. Anything else: the three planes and the rows in
// order. Infeasible rows are shaded, failed ones are marked; a row that is drawn carries the class "rN", N
// its number.
#pragma once

#include "report/chart/chart.hpp"
#include "studies/compare/law_losses.hpp"
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

struct SweepPicture {
    const SweepTable& table;
    const Scene& scene;                 ///< without the settings of the rows
    const LawLosses* losses = nullptr;  ///< null: no laws are drawn
};

[[nodiscard]] Chart sweep_chart(const SweepPicture& picture);
[[nodiscard]] inline std::string sweep_svg(const SweepPicture& picture) {
    return chart_svg(sweep_chart(picture));
}

/// The table of rows that a picture belongs to has no more than one motion's own weights: V, A and J.
[[nodiscard]] bool is_weight_sweep(const SweepTable& table);

// The figures of rows that are drawn and tabulated. Private to report/.

struct SweepQuantity {
    std::string title;   ///< "velocity V", "base radius (mm)"
    std::string symbol;  ///< "V"
    std::function<std::optional<double>(const SweepRow&)> value;
};

/// The objective, V, A, J, every other figure with a weight, the variable dimensions, and the properties of
/// the cam that some row has.
[[nodiscard]] std::vector<SweepQuantity> drawn_quantities(const SweepTable& table);

}  // namespace camopt

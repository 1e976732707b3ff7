// SPDX-License-Identifier: MIT
// sweep.csv, pareto.csv and surface.csv: one line a row of the study, by number.
//
// Columns: row, the varied keys as written, verdict, reason, pareto_front (1 or 0), objective, lower_bound,
// gap, any_curve_limit, the figures (normalised), the variable dimensions in mm, properties of the cam
// (SweepColumns::cam) and of the motor, the chosen spring, places on a front, active_limits (keys, joined by
// "; "), proof, counts, seconds_solve, seconds_total. Numbers read back as the same double; what does not
// exist is an empty cell. docs/sweep.md explains each.
#pragma once

#include "report/view/shown_units.hpp"
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

/// A figure of a part of a row: a column of sweep.csv, and a panel of sweep.svg.
template <class Part>
struct SweepPartColumn {
    const char* name;   ///< in files, with their unit: "pressure_angle_deg"
    const char* title;  ///< for people: "largest pressure angle"
    std::optional<double> Part::*value;
    const ShownUnit* file_unit;
};
using SweepCamColumn = SweepPartColumn<SweepCam>;
using SweepDriveColumn = SweepPartColumn<SweepDrive>;
[[nodiscard]] std::span<const SweepCamColumn> sweep_cam_columns();
[[nodiscard]] std::span<const SweepDriveColumn> sweep_drive_columns();

/// The first line.
[[nodiscard]] std::vector<std::string> sweep_csv_columns(const SweepColumns& columns);

[[nodiscard]] std::string sweep_csv(const SweepTable& table);

/// The table of such a text; SweepColumns::criteria does not stand in it and is left empty. Throws InputError
/// "NAME:LINE: …" for anything that sweep_csv would not have written.
[[nodiscard]] SweepTable read_sweep_csv(std::string_view text, std::string_view name);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Columns of tables along the motion, with their units: motion.csv, profile.csv, guide.csv, table.csv and the
// physical peaks of result.json choose from them. A new column is one row of columns.cpp.
#pragma once

#include "objectives/drive_rules.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// What a column may need beside a motion, bit by bit.
struct ColumnNeed {
    static constexpr unsigned speed = 1, plane_cam = 2, forces = 4, length = 8, angle = 16,
                              contact_width = 32, drive = 64, travel = 128, output = 256;
};

/// "needs motion.speed_rpm"; empty: nothing.
[[nodiscard]] std::string words_of_need(unsigned need);

/// What the values of one row are computed from.
struct TableRow {
    double theta_deg = 0.0;
    MotionPoint motion;  ///< normalised
    const MechanismPoint* cam = nullptr;
    FollowerLoads loads = {};                ///< where the cam has forces
    DrivePoint drive = {};                   ///< where there is a motor
    std::optional<MotionPoint> output = {};  ///< where it is prescribed, and `motion` is the cam's
};

struct TableColumn {
    std::string key;      ///< "v_mm_s"
    std::string meaning;  ///< "velocity in mm/s"
    unsigned need = 0;
    std::size_t order = 0;  ///< of a derivative of the motion in physical units; 0: none
    std::function<double(const MotionSpec& motion, const TableRow& row)> value = {};
};

[[nodiscard]] const std::vector<TableColumn>& table_columns();

using Columns = std::vector<const TableColumn*>;

/// Throws std::out_of_range for a key that is no column.
[[nodiscard]] Columns columns_of(const std::vector<std::string>& keys);

/// Whether the solution has what the column needs.
[[nodiscard]] bool has_column(const Solution& solution, const TableColumn& column);

/// Of motion.csv.
[[nodiscard]] Columns motion_columns(const Scene& scene);

/// Of profile.csv: of the motion, the cam and its loads.
[[nodiscard]] Columns profile_columns(const Solution& solution);

/// Of table.csv unless columns are given: in the units of the report.
[[nodiscard]] Columns default_columns(const Solution& solution);

/// A plane cam with an outline; of one with two sides the first.
[[nodiscard]] bool has_plane_cam(const Solution& solution);

}  // namespace camopt

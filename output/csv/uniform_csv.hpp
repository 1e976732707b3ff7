// SPDX-License-Identifier: MIT
// table.csv: the motion, and where there is a plane cam the cam, at evenly spaced cam angles with the columns
// one asks for.
//
// The angle of row i is i times the step (end · i / (rows − 1) for a number of rows): no sum, so it does not
// drift, and the last row stands at the end exactly. The table goes over the whole turn where the motion
// closes (RR with its dwell, a closed program), else to the end of the motion. At a breakpoint a value is
// that of the side after it, at the end that before. A value that is not finite stays empty.
//
// Columns: table_columns(). What each needs and its unit stand in its row there; docs/results.md lists them.
#pragma once

#include "studies/delivered/follower_loads.hpp"
#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// What a column may need beside a motion, bit by bit.
struct ColumnNeed {
    static constexpr unsigned speed = 1, plane_cam = 2, forces = 4, length = 8, angle = 16,
                              contact_width = 32;
};

struct TableColumn {
    std::string key;      ///< "v_mm_s"
    std::string meaning;  ///< "velocity in mm/s"
    unsigned need = 0;
};

/// "needs motion.speed_rpm"; empty: nothing.
[[nodiscard]] std::string words_of_need(unsigned need);

/// Of a plane cam and its loads: profile.csv has them too.
struct CamColumn {
    const char* key;
    const char* meaning;
    unsigned need;
    double (*value)(const MechanismPoint& cam, const FollowerLoads& loads);
};
/// Throws std::out_of_range without such a column.
[[nodiscard]] const CamColumn& cam_column(std::string_view key);

[[nodiscard]] const std::vector<TableColumn>& table_columns();

struct UniformTableOptions {
    std::optional<int> rows = {};         ///< both ends included; none: 361, or by the step
    std::optional<double> step_deg = {};  ///< never together with rows
    std::vector<std::string> columns =
        {};                          ///< empty: angle, displacement, velocity, acceleration, jerk in the
                                     ///< units of the report, and the pressure angle of a plane cam
    std::optional<int> digits = {};  ///< significant, 1 … 17; none: as many as read back to the same number
};

struct UniformTable {
    std::string text;
    int rows = 0;
    double end_deg = 0.0;
    bool whole_turn = false;
    double last_step_deg = 0.0;  ///< less than the step where that does not divide the angle

    /// "361 rows over the whole turn, 0 to 360 deg"
    [[nodiscard]] std::string words() const;
};

/// Throws InputError for a column that does not exist or that this solution does not have, naming those it
/// has; for a step that is not in (0, end], and where there is no motion.
[[nodiscard]] UniformTable uniform_table(const Solution& solution, const UniformTableOptions& options);

/// "theta_deg,s_mm": the names between commas. Throws InputError for an empty one.
[[nodiscard]] std::vector<std::string> column_names(std::string_view list);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The motion and its cam as tables; columns and units: report/view/columns.hpp, docs/results.md. A value that
// is infinite or does not exist stays empty.
//
//   motion.csv   361 uniform cam angles over the motion, every breakpoint, and the peaks. Where the jerk
//                jumps the angle stands in two rows: as seen from the left, then from the right
//   profile.csv  one side of a cam, one row a point. Radii are signed, > 0 convex. Of the loads the force
//                along the normal and the Hertz pressure are empty where the follower cannot touch the cam
//                as designed (studies/delivered/driven_mechanism.hpp). Cam frame of
//                report/drawing/profile_shape.hpp
//   guide.csv    both walls of a guide in the frame of the body (origin: its pivot; x axis: through the
//                roller where the body stands at angle 0): theta_deg, s_mm (the feeder's), middle_x_mm,
//                middle_y_mm (the roller's centre), left_x_mm, left_y_mm, right_x_mm, right_y_mm (the
//                walls, seen outwards), pressure_angle_deg, middle_radius_mm (> 0: bent to the left),
//                regularity_left, regularity_right
//   table.csv    motion and plane cam at evenly spaced cam angles with the columns one asks for
#pragma once

#include "report/view/view.hpp"

namespace camopt {

/// Throws InputError where the solution has no motion.
[[nodiscard]] std::string motion_csv(const View& view);

/// rows: profile_rows of studies/delivered/delivered.hpp.
[[nodiscard]] std::string profile_csv(const View& view, const std::vector<DeliveredRow>& rows);

/// Both walls at the same cam angles.
[[nodiscard]] std::string guide_csv(const View& view, const std::vector<DeliveredRow>& left,
                                    const std::vector<DeliveredRow>& right);

struct UniformTableOptions {
    std::optional<int> rows = {};         ///< both ends included; none: 361, or by the step
    std::optional<double> step_deg = {};  ///< never together with rows
    std::vector<std::string> columns =
        {};                          ///< empty: angle, displacement, velocity, acceleration, jerk in
                                     ///< the units of the report, and the pressure angle of a plane cam
    std::optional<int> digits = {};  ///< significant, 1 … 17; none: as many as read back to the same number
};

struct UniformTable {
    std::string text;
    int rows = 0;
    double end_deg = 0.0;
    bool whole_turn = false;
    double phase_deg = 0.0;      ///< of the master, where the motion begins: rows are by its angle
    double last_step_deg = 0.0;  ///< less than the step where that does not divide the angle

    /// "361 rows over one revolution, 0 to 360 deg"
    [[nodiscard]] std::string words() const;
};

/// table.csv. The angle of row i is i times the step (end · i / (rows − 1) for a number of rows): no sum, so
/// it does not drift, and the last row stands at the end exactly. The table goes over one revolution where
/// the motion closes (RR with its dwell, a closed program), else to the end of the motion. At a breakpoint a
/// value is that of the side after it, at the end that before. Throws InputError for a column that does not
/// exist or that this solution does not have, naming those it has; for a step that is not in (0, end], and
/// where there is no motion.
[[nodiscard]] UniformTable uniform_table(const View& view, const UniformTableOptions& options);

/// "theta_deg,s_mm": the names between commas. Throws InputError for an empty one.
[[nodiscard]] std::vector<std::string> column_names(std::string_view list);

}  // namespace camopt

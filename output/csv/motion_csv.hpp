// SPDX-License-Identifier: MIT
// motion.csv: the motion as a table. Columns and units: docs/results.md.
//
// Rows: 361 uniform cam angles over the motion, every breakpoint, and the peaks. Where the jerk jumps the
// angle stands in two rows: first as seen from the left, then from the right. A value that is infinite stays
// empty.
#pragma once

#include "core/motion.hpp"
#include "core/peaks.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace camopt {

/// One row of the table: an angle, and the side it is seen from.
struct MotionRow {
    double x = 0.0;
    Side side = Side::right;
};

/// Ascending, without repetitions.
[[nodiscard]] std::vector<MotionRow> motion_rows(const Motion& motion, const Peaks& peaks);

[[nodiscard]] std::string motion_csv(const Motion& motion, const Peaks& peaks, const MotionSpec& spec);

}  // namespace camopt

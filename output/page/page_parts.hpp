// SPDX-License-Identifier: MIT
// Private to output/page: the parts of page_data.hpp.
#pragma once

#include "output/csv/motion_csv.hpp"
#include "output/json/json_text.hpp"
#include "output/page/page_data.hpp"
#include "output/words/shown_units.hpp"
#include "output/words/tables/text_table.hpp"
#include "profiles/sampling.hpp"
#include "splines/motion_chain.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// To so many significant digits: eight are as many as a page can show. null for what is not finite.
[[nodiscard]] Json rounded_json(double value, int digits = 8);

/// Where all curves and poses are taken: the rows of motion.csv, then the dwell that closes the cam.
struct PageRows {
    std::optional<MotionChain>
        whole;                    ///< the motion of the whole cam; none: without a cam, the motion itself
    std::vector<MotionRow> rows;  ///< ascending
    std::size_t own = 0;          ///< rows of the motion itself; what follows is the dwell
};
[[nodiscard]] PageRows page_rows(const Solution& solution);
/// The motion at a row.
[[nodiscard]] MotionPoint page_motion_at(const Solution& solution, const PageRows& rows, std::size_t index);

/// A derivative of any motion at the rows; null outside of it.
[[nodiscard]] Json values_along(const Motion& motion, const PageRows& rows, const MotionUnit& unit);
/// Displacement to jerk.
[[nodiscard]] Json motion_curves(const Solution& solution, const PageRows& rows);
/// Pressure angle, curvature, forces: what this cam has. Empty without a cam.
[[nodiscard]] Json cam_curves(const Solution& solution, const PageRows& rows);

/// null where there is no plane cam.
[[nodiscard]] Json plane_drawing(const Solution& solution, const PageRows& rows);
/// null where there is no three-dimensional cam.
[[nodiscard]] Json solid_drawing(const Solution& solution, const PageRows& rows);

[[nodiscard]] Json verdict_part(const Solution& solution);
/// Of a picture before its proof.
[[nodiscard]] Json open_verdict_part(const Solution& solution);
[[nodiscard]] Json figures_part(const Solution& solution);
/// null without a law to compare with.
[[nodiscard]] Json reference_part(const Solution& solution, PageReference wish);
[[nodiscard]] Json tables_part(const Solution& solution);
[[nodiscard]] Json appendix_part(const Solution& solution, const RunOrigin& origin);
[[nodiscard]] Json table_json(std::string_view key, std::string_view title, const TextTable& table,
                              std::string_view note = {});

}  // namespace camopt

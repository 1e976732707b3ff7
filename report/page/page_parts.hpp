// SPDX-License-Identifier: MIT
// Private to report/page: the parts of page_html.hpp.
#pragma once

#include "report/document/document.hpp"
#include "report/document/run_origin.hpp"
#include "report/json/json_text.hpp"
#include "report/view/view.hpp"

namespace camopt {

/// To so many significant digits: eight are as many as a page can show. null for what is not finite.
[[nodiscard]] Json rounded_json(double value, int digits = 8);

/// null where there is no plane cam.
[[nodiscard]] Json plane_drawing(const View& view);

/// To a ten-thousandth of the unit; ten thousand steps a unit keep the text short: 12.3,
/// not 12.299999999999999.
void append(Json& list, const ShownUnit& unit, const Eigen::Ref<const Eigen::VectorXd>& point);

/// A table whose rows are motions; scenes of its rows where the origin has a text.
[[nodiscard]] Json motions_json(const Table& table, const RunOrigin& origin);

// Private to report/page: the files under assets/ and vendor/, compiled in.

/// "assets/page.css". Throws ModelError for a name that is not there.
[[nodiscard]] std::string_view page_asset(std::string_view name);

}  // namespace camopt

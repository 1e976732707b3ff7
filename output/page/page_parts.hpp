// SPDX-License-Identifier: MIT
// Private to output/page: the parts of page_data.hpp.
#pragma once

#include "output/json/json_text.hpp"
#include "output/page/page_data.hpp"
#include "output/view/text_table.hpp"
#include "output/view/view.hpp"

#include <string>
#include <string_view>

namespace camopt {

/// To so many significant digits: eight are as many as a page can show. null for what is not finite.
[[nodiscard]] Json rounded_json(double value, int digits = 8);

/// null where there is no plane cam.
[[nodiscard]] Json plane_drawing(const View& view);
/// null where there is no three-dimensional cam.
[[nodiscard]] Json solid_drawing(const View& view);

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

// SPDX-License-Identifier: MIT
// A sweep as people see it: its rows by verdict, the front, the best row, and a page on which any column is
// drawn over any other and every row hands out its scene. Its rows are in sweep.csv.
#pragma once

#include "report/chart/sweep/sweep_svg.hpp"
#include "report/document/document.hpp"
#include "report/json/sweep_json.hpp"

namespace camopt {

/// In a few sentences. scene: that of any row, to name the peaks of the best row in time where it has a
/// speed; null: they are not named.
[[nodiscard]] Document sweep_summary(const SweepTable& table, const Scene* scene = nullptr,
                                     const std::string& title = "Sweep");

/// The same with picture and rows. The scene of a row is that of the sweep with the row's settings; more
/// rows than `most_scenes_of_page` have none, nor has a machine.
[[nodiscard]] Document sweep_document(const SweepPicture& picture, const SweepIdentity& identity);
inline constexpr int most_scenes_of_page = 5000;

}  // namespace camopt

// SPDX-License-Identifier: MIT
// sweep.html and pareto.html: each a table of motions (page_html.hpp).
#pragma once

#include "output/chart/studies/pareto_svg.hpp"
#include "output/chart/sweep/sweep_svg.hpp"
#include "output/json/result_json.hpp"
#include "output/json/sweep_json.hpp"

namespace camopt {

/// The scene of a row is that of the sweep with the row's settings. More rows than `most_scenes_of_page` have
/// none.
[[nodiscard]] std::string sweep_html(const SweepPicture& picture, const SweepIdentity& identity);
inline constexpr int most_scenes_of_page = 5000;

/// The scene of a point minimizes what its solve did, with its cap as a limit.
[[nodiscard]] std::string pareto_html(const ParetoPicture& picture, const RunOrigin& origin = {});

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Pages of many motions: comparison.html, sweep.html, pareto.html. A pointer on a mark or a curve names what
// it is and says its numbers; a click, or Enter, hands out its scene as TOML.
//
// Their data, beside what every page has (page_html.hpp: page = "study", camopt, title, verdict, scene):
//   kind       "Comparison", "Sweep", "Front"
//   items      names[], numbers[] (the class "rN" of its marks in the picture), tones[] ("", "good", "bad")
//   columns[]  key, title, left, values[]: numbers, texts or null, by item
//   axes       x, y: keys of the columns that are drawn first
//   picture    null, or an SVG as text
//   overlay    null, or angle { unit, values[] } and curves[]: key, title, symbol, unit, lines[] (by item
//   values[]
//              or null)
//   scenes     null, or base (a scene in TOML), edits[] by item: null (none), or pairs of a line of base,
//   from 0,
//              and the text in its place; names[]: of the files
#pragma once

#include "output/chart/studies/study_svg.hpp"
#include "output/chart/sweep/sweep_svg.hpp"
#include "output/json/result_json.hpp"
#include "output/json/sweep_json.hpp"

namespace camopt {

/// The scene of a law is that of the comparison with this law as its reference.
[[nodiscard]] std::string comparison_html(const Comparison& comparison, const RunOrigin& origin = {});

/// The scene of a row is that of the sweep with the row's settings. More rows than `most_scenes_of_page` have
/// none.
[[nodiscard]] std::string sweep_html(const SweepPicture& picture, const SweepIdentity& identity);
inline constexpr int most_scenes_of_page = 5000;

/// The scene of a point minimizes what its solve did, with its cap as a limit.
[[nodiscard]] std::string pareto_html(const ParetoPicture& picture, const RunOrigin& origin = {});

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/report/report_sections.hpp"

#include "core/text/printable.hpp"
#include "input/keys/written_keys.hpp"
#include "output/report/cam_files.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/cam_remarks.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/infeasible_words.hpp"
#include "output/words/key_words.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "output/words/tables/segment_table.hpp"
#include "profiles/scene_cam.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::string list_of(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += fmt::format("- {}\n", sentence);
    return text;
}

std::string pictures_of(const Solution& solution) {
    std::string text;
    for (const CamFile& file : cam_file_list(solution))
        if (!file.title.empty())
            text += fmt::format("{}![{}]({})\n", text.empty() ? "" : "\n", file.title, file.name);
    if (!text.empty()) return text;
    return "`camopt export` writes its flanks as points, surfaces and a solid, and the NC program.\n";
}

}  // namespace

std::string cam_section(const Solution& solution) {
    if (!solution.cam) return {};
    const TextTable table = cam_table(solution, {{"", true}, {""}, {"at (deg)"}});
    return fmt::format("\n## The cam\n\n{}: {}.\n\n{}\n{}\n{}", cam_text(cam_of(solution.scene).value()),
                       dimensions_text(solution), markdown_text(table), list_of(cam_remarks(solution)),
                       pictures_of(solution));
}

TextTable peak_rows(const Solution& solution, const std::string& first_title,
                    const std::vector<std::string>& titles,
                    const std::function<std::vector<std::string>(const PeakRow&)>& cells) {
    const bool in_time = shown_units(solution.scene).in_time;
    TextTable table;
    table.columns = {{"", true}, {first_title}};
    if (in_time) table.columns.push_back({"by the cam angle"});
    for (const std::string& title : titles) table.columns.push_back({title});
    table.columns.push_back({"peak of the other sign"});
    for (const PeakRow& row : peak_comparison(solution, reference_motion(solution.scene))) {
        std::vector<std::string> all = {fmt::format("{} {}", row.name, row.symbol), row.first_text()};
        if (in_time) all.push_back(row.beside_text());
        const std::vector<std::string> further = cells(row);
        all.insert(all.end(), further.begin(), further.end());
        all.emplace_back();
        if (const auto& opposite = row.sides.opposite)
            all.back() = fmt::format("{} at {} deg", row.opposite_text(), degrees_at(solution, opposite->at));
        table.rows.push_back(std::move(all));
    }
    return table;
}

std::string program_peak_section(const Solution& solution) {
    const TextTable table =
        peak_rows(solution, "whole motion",
                  {"at (deg)", "spline segments", "at (deg)",
                   reference_title(reference_motion(solution.scene)), "change"},
                  [&](const PeakRow& row) -> std::vector<std::string> {
                      return {row.shown ? degrees_at(solution, row.motion.at) : std::string{},
                              short_text(row.optimum.value), degrees_at(solution, row.optimum.at),
                              short_text(row.reference), row.change()};
                  });
    return "\n## Peaks\n\n" + markdown_text(table) +
           "\nPeaks are exact, not sampled. Those of the spline segments are normalised, each by its "
           "segment's "
           "own angle and displacement; those of the whole motion include the law segments.\n";
}

namespace {

std::string code(const std::string& text) {
    return text.find('`') == std::string::npos ? fmt::format("`{}`", text) : text;
}

}  // namespace

std::string scene_section(const RunOrigin& origin) {
    if (origin.scene_text.empty()) return {};
    TextTable table;
    table.columns = {{"key", true}, {"value", true}, {"unit", true}, {"meaning", true}};
    for (const input::WrittenKey& row : input::keys_written_in(origin.scene_text, origin.scene_file))
        table.rows.push_back({code(printable(row.key)), code(row.value), row.unit, row.meaning});
    std::string fence = "```";
    while (origin.scene_text.find(fence) != std::string::npos) fence += '`';
    const bool ends = origin.scene_text.ends_with('\n');
    return fmt::format(
        "\n## The scene, key by key\n\nWhat is not listed has its default (`camopt list keys`).\n\n{}\n"
        "## The scene file\n\nIn a file of its own it repeats this report: `camopt solve FILE --out DIR`.\n\n"
        "{}toml\n{}{}{}\n",
        markdown_text(table), fence, printable_lines(origin.scene_text), ends ? "" : "\n", fence);
}

std::string segment_section(const Solution& solution) {
    if (solution.segments.empty()) return {};
    return fmt::format("\n## Segments\n\n{}\n{}\n", markdown_text(segment_table(solution)),
                       segment_table_note());
}

namespace {

/// No more than is known: of every motion, of this spline, or only that none was found.
std::string title_of_infeasible(const Solution& solution) {
    constexpr const char* change = "and what would have to change";
    if (solution.certificate.verdict != Verdict::infeasible)
        return fmt::format("No motion was found, {}", change);
    const bool any = solution.explanation && !solution.explanation->any_motion.empty();
    return any ? fmt::format("Why no motion exists, {}", change)
               : fmt::format("Why this spline has no motion, {}", change);
}

}  // namespace

std::string infeasible_section(const Solution& solution) {
    const std::vector<std::string> remarks = infeasible_remarks(solution);
    if (remarks.empty()) return {};
    std::string text = fmt::format("\n## {}\n\n{}", title_of_infeasible(solution), list_of(remarks));
    if (solution.relaxation.empty()) return text;
    TextTable table = relaxation_table(solution);
    for (std::vector<std::string>& row : table.rows) row[0] = fmt::format("`{}`", row[0]);
    return text + "\n" + markdown_text(table) +
           "\nEach number is rounded to the side that does and was put into the scene: a solve found a "
           "motion "
           "with it. The edge itself stands in result.json.\n";
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/text/printable.hpp"
#include "core/version.hpp"
#include "input/scene_document.hpp"
#include "output/report/cam_files.hpp"
#include "output/report/result_folder.hpp"
#include "output/view/cam_words.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/view/tables.hpp"
#include "output/words/solution_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Sections of report.md that not every result has. Empty where they have nothing to say.

std::string list_of(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += fmt::format("- {}\n", markdown_words(sentence));
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

std::string section_text(const ViewTable& one) {
    return markdown_text(one.table) + (one.note.empty() ? "" : "\n" + one.note + "\n");
}

/// Remarks and pictures.
std::string cam_section(const Solution& solution) {
    return fmt::format("\n{}\n{}", list_of(cam_remarks(solution)), pictures_of(solution));
}

/// "The scene, key by key" and the scene file itself: the report alone repeats the run. Empty where the
/// origin has no text.
std::string scene_section(const RunOrigin& origin) {
    if (origin.scene_text.empty()) return {};
    TextTable table;
    table.columns = {{"key", true, true}, {"value", true, true}, {"unit", true}, {"meaning", true}};
    for (const input::WrittenKey& row : input::keys_written_in(origin.scene_text, origin.scene_file))
        table.rows.push_back({row.key, row.value, row.unit, row.meaning});
    std::string fence = "```";
    while (origin.scene_text.find(fence) != std::string::npos) fence += '`';
    const bool ends = origin.scene_text.ends_with('\n');
    return fmt::format(
        "\n## The scene, key by key\n\nWhat is not listed has its default (`camopt list keys`).\n\n{}\n"
        "## The scene file\n\nSaved as a file it repeats this report: `camopt solve FILE --out DIR`.\n\n"
        "{}toml\n{}{}{}\n",
        markdown_text(table), fence, printable_lines(origin.scene_text), ends ? "" : "\n", fence);
}

/// No more than is known: of every motion, of this spline, or only that none was found.
std::string title_of_infeasible(const Solution& solution) {
    constexpr const char* change = "and what would have to change";
    if (solution.certificate.verdict != Verdict::infeasible)
        return fmt::format("No motion was found, {}", change);
    if (solution.scene.motion.prescribed())
        return fmt::format("Why the prescribed motion violates a limit, {}", change);
    const bool any = solution.explanation && !solution.explanation->any_motion.empty();
    return any ? fmt::format("Why no motion exists, {}", change)
               : fmt::format("Why this spline has no motion, {}", change);
}

/// "Why this spline has no motion, and what would have to change", in words; "no motion exists" where that is
/// known.
std::string infeasible_section(const Solution& solution, const std::vector<ViewTable>& tables) {
    const std::vector<std::string> remarks = infeasible_remarks(solution);
    if (remarks.empty()) return {};
    std::string text = fmt::format("\n## {}\n\n{}", title_of_infeasible(solution), list_of(remarks));
    const auto changes = std::ranges::find(tables, "changes", &ViewTable::key);
    return changes == tables.end() ? text : text + "\n" + section_text(*changes);
}

std::string asked(const Scene& scene) {
    return "## The problem\n\n" + list_of(scene_lines(scene));
}

std::string verdict_section(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    std::string text = fmt::format("\n## Verdict\n\n**{}**\n\n", verdict_sentence(solution));
    const auto line = [&](std::string_view name, double value, int digits) {
        text += fmt::format("- {}: {}\n", name, short_text(value, digits));
    };
    if (solution.motion) line("Objective", certificate.objective, 10);
    const bool searched = !solution.solver.convex && solution.solver.starts > 0;
    if (certificate.lower_bound)
        line(certificate.proof_kind == ProofKind::any_curve_limit ? "Lower bound for curves of any kind"
             : searched && certificate.proof_kind != ProofKind::boxes
                 ? "Lower bound in this spline space (convex relaxation)"
                 : "Proved lower bound",
             *certificate.lower_bound, 10);
    if (certificate.gap) line("Relative gap between them", *certificate.gap, 3);
    if (solution.any_curve_limit)
        line("Least objective of any curve, spline or not" + left_out_of_any_curve(solution.scene),
             solution.any_curve_limit->objective, 10);
    if (certificate.stationarity) line("Stationarity residual", *certificate.stationarity, 3);
    return text;
}

std::string dynamics_section(const Solution& solution) {
    const std::vector<std::string> train = train_sentences(solution), motor = drive_sentences(solution);
    std::string text;
    if (!train.empty()) text += "## Dynamics\n\n" + list_of(train) + "\n";
    if (motor.empty()) return text;
    return text + "\n## The motor\n\n" + list_of(motor) +
           "\n![Torque and speed of the motor, torque over speed](drive.svg)\n";
}

std::string own_terms_section(const Solution& solution) {
    if (solution.own_terms.empty()) return {};
    std::vector<std::string> sentences;
    for (const OwnTermReport& term : solution.own_terms) sentences.push_back(own_term_sentence(term));
    return "\n## Terms of the program\n\n" + list_of(sentences);
}

std::string design_section(const DesignReport& design) {
    if (design.names.empty()) return {};
    constexpr std::size_t most = 40;  // longer lists stand in result.json
    std::string text = fmt::format("\n## Design vector ({})\n\n", name_of(design.kind));
    if (design.names.size() > most)
        return text + fmt::format("{} values: see `design` in result.json.\n", design.names.size());
    text += "| name | value |\n|---|--:|\n";
    for (std::size_t i = 0; i < design.names.size(); ++i)
        text += fmt::format("| {} | {} |\n", design.names[i],
                            round_trip_text(design.values[static_cast<Eigen::Index>(i)]));
    return text;
}

std::string solver_section(const Solution& solution, const RunOrigin& origin) {
    std::string text = "\n## How it was found\n\n" + list_of(solver_sentences(solution));
    if (!origin.command.empty()) text += fmt::format("- Command: {}\n", markdown_code(origin.command));
    return text + fmt::format("- camopt {}\n", version());
}

std::string notes_section(const std::vector<std::string>& notes) {
    if (notes.empty()) return {};
    return "\n## Notes\n\n" + list_of(notes);
}

}  // namespace

std::string report_markdown(const Solution& solution, const RunOrigin& origin) {
    const std::vector<ViewTable> tables = result_tables(solution);
    const auto section = [&](std::string_view key) {
        const auto found = std::ranges::find(tables, key, &ViewTable::key);
        return found == tables.end() ? "" : fmt::format("\n## {}\n\n{}", found->title, section_text(*found));
    };
    std::string text = fmt::format(
        "# {}\n\n", solution.scene.title.empty() ? "Motion" : markdown_words(solution.scene.title));
    text += asked(solution.scene) + verdict_section(solution) + infeasible_section(solution, tables);
    text += section("peaks") + section("valve") + section("valve_figures") + section("segments");
    for (const std::string& sentence : excursion_sentences(solution)) text += "\n" + sentence + "\n";
    text += own_terms_section(solution) + dynamics_section(solution);
    if (solution.motion && solution.constraints.empty()) text += "\n## Limits\n\nNone was set.\n";
    text += section("limits") + section("set_points");
    text += section("surge");
    if (solution.surge) text += "\n![Harmonics of the lift](surge.svg)\n";
    text += section("measured");
    if (solution.motion) text += "\n![Displacement, velocity, acceleration and jerk](motion.svg)\n";
    if (solution.cam) text += section("dimensions") + section("cam") + cam_section(solution);
    text += section("title_block");
    return text + design_section(solution.design) + solver_section(solution, origin) +
           notes_section(solution.notes) + scene_section(origin);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/report/report.hpp"

#include "core/text/printable.hpp"
#include "core/version.hpp"
#include "input/scene_document.hpp"
#include "output/report/cam_files.hpp"
#include "output/words/cam_remarks.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/dynamics_text.hpp"
#include "output/words/infeasible_words.hpp"
#include "output/words/key_words.hpp"
#include "output/words/number_text.hpp"
#include "output/words/peak_comparison.hpp"
#include "output/words/scene_words.hpp"
#include "output/words/segment_table.hpp"
#include "output/words/shown_units.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace camopt {

namespace {

// Sections of report.md that not every result has. Empty where they have nothing to say.

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

/// "The cam": dimensions, figures, remarks, pictures.
std::string cam_section(const Solution& solution) {
    if (!solution.cam) return {};
    const TextTable table = cam_table(solution, {{"", true}, {""}, {"at (deg)"}});
    return fmt::format("\n## The cam\n\n{}: {}.\n\n{}\n{}\n{}", cam_text(solution.scene.cam.value()),
                       dimensions_text(solution), markdown_text(table), list_of(cam_remarks(solution)),
                       pictures_of(solution));
}

/// The peaks of a scene's motion, one a row, with further columns behind: their titles, and their cells.
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

/// "Peaks" of a program: normalised ones of the spline segments, physical ones of the whole motion.
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

std::string code(const std::string& text) {
    return text.find('`') == std::string::npos ? fmt::format("`{}`", text) : text;
}

/// "The scene, key by key" and the scene file itself: the report alone repeats the run. Empty where the
/// origin has no text.
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
        "## The scene file\n\nSaved as a file it repeats this report: `camopt solve FILE --out DIR`.\n\n"
        "{}toml\n{}{}{}\n",
        markdown_text(table), fence, printable_lines(origin.scene_text), ends ? "" : "\n", fence);
}

/// "Segments": the table of a program.
std::string segment_section(const Solution& solution) {
    if (solution.segments.empty()) return {};
    return fmt::format("\n## Segments\n\n{}\n{}\n", markdown_text(segment_table(solution)),
                       segment_table_note());
}

/// No more than is known: of every motion, of this spline, or only that none was found.
std::string title_of_infeasible(const Solution& solution) {
    constexpr const char* change = "and what would have to change";
    if (solution.certificate.verdict != Verdict::infeasible)
        return fmt::format("No motion was found, {}", change);
    const bool any = solution.explanation && !solution.explanation->any_motion.empty();
    return any ? fmt::format("Why no motion exists, {}", change)
               : fmt::format("Why this spline has no motion, {}", change);
}

/// "Why this spline has no motion, and what would have to change", in words; "no motion exists" where that is
/// known.
std::string infeasible_section(const Solution& solution) {
    const std::vector<std::string> remarks = infeasible_remarks(solution);
    if (remarks.empty()) return {};
    std::string text = fmt::format("\n## {}\n\n{}", title_of_infeasible(solution), list_of(remarks));
    if (solution.relaxation.empty()) return text;
    TextTable table = relaxation_table(solution);
    for (std::vector<std::string>& row : table.rows) row[0] = fmt::format("`{}`", row[0]);
    return text + "\n" + markdown_text(table) +
           "\nEach number is rounded to the feasible side and was tried in the scene: a solve found a "
           "motion "
           "with it. The exact limit is in result.json.\n";
}

std::string asked(const Scene& scene) {
    std::string text = "## The problem\n\n";
    for (const std::string& line : scene_lines(scene)) text += fmt::format("- {}\n", line);
    return text;
}

std::string any_curve_line(const Scene& scene) {
    const std::string left_out = left_out_of_any_curve(scene);
    return "Least objective of any curve, spline or not" +
           (left_out.empty() ? "" : fmt::format(" ({} left out)", left_out));
}

/// What stands in the last column of the peaks; empty where there is none.
std::string any_curve_note(const Solution& solution) {
    if (!solution.any_curve_limit) return {};
    const std::string left_out = left_out_of_any_curve(solution.scene);
    return fmt::format(
        "\nLast column: the peaks of the curve of least objective, spline or not{}. They are its peaks and "
        "no "
        "bound of a single peak: another curve may have one of them smaller.\n",
        left_out.empty() ? "" : fmt::format(" ({} left out)", left_out));
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
        line(any_curve_line(solution.scene), solution.any_curve_limit->objective, 10);
    if (certificate.stationarity) line("Stationarity residual", *certificate.stationarity, 3);
    return text;
}

std::string peak_table(const Solution& solution) {
    const TextTable table =
        peak_rows(solution, "peak",
                  {"normalised", "at (deg)", reference_title(reference_motion(solution.scene)), "change",
                   "curve of least objective"},
                  [&](const PeakRow& row) -> std::vector<std::string> {
                      return {short_text(row.optimum.value), degrees_at(solution, row.optimum.at),
                              short_text(row.reference), row.change(), short_text(row.any_curve)};
                  });
    return "\n## Peaks\n\n" + markdown_text(table) +
           "\nPeaks are exact, not sampled. Without a unit: normalised by lift and rise angle.\n" +
           any_curve_note(solution);
}

std::string dynamics_section(const Solution& solution) {
    const std::vector<std::string> sentences = train_sentences(solution);
    if (sentences.empty()) return {};
    std::string text = "## Dynamics\n\n";
    for (const std::string& sentence : sentences) text += fmt::format("- {}\n", sentence);
    return text + "\n";
}

std::string own_terms_section(const Solution& solution) {
    if (solution.own_terms.empty()) return {};
    std::string text = "\n## Terms of the program\n\n";
    for (const OwnTermReport& term : solution.own_terms)
        text += fmt::format("- {}\n", own_term_sentence(term));
    return text;
}

/// What "verified" says, and what is not.
std::string verification_words(const std::vector<ConstraintReport>& limits) {
    const auto verified = [](const ConstraintReport& row) { return row.verified; };
    std::string text;
    if (std::ranges::any_of(limits, verified))
        text +=
            "\nVerified: along all of the motion, enclosed by interval arithmetic where no exact formula "
            "gives the largest value; the limits hold between samples too.\n";
    if (!std::ranges::all_of(limits, verified))
        text += "\nLimits that are not verified were sampled at closely spaced angles.\n";
    return text;
}

std::string limits_section(const Solution& solution) {
    if (!solution.motion) return {};  // nothing was reached; the relaxation names the limits
    if (solution.constraints.empty()) return "\n## Limits\n\nNone was set.\n";
    std::string text = "\n## Limits\n\n| limit | allowed | reached | at (deg) | |\n|---|--:|--:|--:|---|\n";
    for (const ConstraintReport& row : solution.constraints)
        text += fmt::format(
            "| `{}` | {} | {} | {} | {} |\n", row.key, limit_text(row), reached_text(row),
            reached_degrees(solution, row),
            std::string(row.active ? "active" : "not active") + (row.verified ? "; verified" : ""));
    return text + verification_words(solution.constraints);
}

std::string set_point_section(const Solution& solution) {
    const TextTable table = set_point_table(solution);
    return table.rows.empty() ? std::string() : "\n## Set points\n\n" + markdown_text(table);
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
    std::string text = "\n## How it was found\n\n";
    for (const std::string& sentence : solver_sentences(solution)) text += fmt::format("- {}\n", sentence);
    if (!origin.command.empty()) text += fmt::format("- Command: `{}`\n", printable(origin.command));
    return text + fmt::format("- camopt {}\n", version());
}

std::string notes_section(const std::vector<std::string>& notes) {
    if (notes.empty()) return {};
    std::string text = "\n## Notes\n\n";
    for (const std::string& note : notes) text += fmt::format("- {}\n", note);
    return text;
}

}  // namespace

std::string report_markdown(const Solution& solution, const RunOrigin& origin) {
    std::string text =
        fmt::format("# {}\n\n", solution.scene.title.empty() ? "Motion" : printable(solution.scene.title));
    text += asked(solution.scene) + verdict_section(solution) + infeasible_section(solution);
    if (solution.motion)
        text += solution.segments.empty() ? peak_table(solution)
                                          : program_peak_section(solution) + segment_section(solution);
    for (const std::string& sentence : excursion_sentences(solution)) text += "\n" + sentence + "\n";
    text += own_terms_section(solution);
    text += dynamics_section(solution);
    text += limits_section(solution) + set_point_section(solution);
    if (solution.measured) text += fmt::format("\n## Measured motion\n\n{}.\n", measured_sentence(solution));
    if (solution.motion) text += "\n![Displacement, velocity, acceleration and jerk](motion.svg)\n";
    text += cam_section(solution);
    return text + design_section(solution.design) + solver_section(solution, origin) +
           notes_section(solution.notes) + scene_section(origin);
}

}  // namespace camopt

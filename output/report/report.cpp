// SPDX-License-Identifier: MIT
#include "output/report/report.hpp"

#include "core/text/printable.hpp"
#include "core/version.hpp"
#include "output/report/report_sections.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/infeasible_words.hpp"
#include "output/words/motion_extremes.hpp"
#include "output/words/number_text.hpp"
#include "output/words/scene_words.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/tables/dynamics_text.hpp"
#include "output/words/tables/peak_comparison.hpp"
#include "output/words/tables/set_point_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

std::string asked(const Scene& scene) {
    std::string text = "## What was asked\n\n";
    for (const std::string& line : scene_lines(scene)) text += fmt::format("- {}\n", line);
    return text;
}

std::string any_curve_line(const Scene& scene) {
    const std::string left_out = left_out_of_any_curve(scene);
    return "Least objective of any curve whatever, spline or not" +
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
        line(certificate.proof_kind == ProofKind::any_curve_limit ? "No curve of any kind is better than this"
             : searched && certificate.proof_kind != ProofKind::boxes
                 ? "No curve of this spline space is better than this (bound of the convex relaxation)"
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
            "gives the largest value; nothing is passed between places either.\n";
    if (!std::ranges::all_of(limits, verified))
        text += "\nLimits that are not verified were looked at in closely spaced places.\n";
    return text;
}

std::string limits_section(const Solution& solution) {
    if (!solution.motion) return {};  // nothing was reached; the relaxation names the limits
    if (solution.constraints.empty()) return "\n## Limits\n\nNone was set.\n";
    std::string text = "\n## Limits\n\n| limit | allowed | reached | at (deg) | |\n|---|--:|--:|--:|---|\n";
    for (const ConstraintReport& row : solution.constraints)
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.key, limit_text(row), reached_text(row),
                            reached_degrees(solution, row),
                            std::string(row.active ? "active: it shapes the motion" : "not active") +
                                (row.verified ? "; verified" : ""));
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

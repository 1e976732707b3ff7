// SPDX-License-Identifier: MIT
#include "output/words/solution_text.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "output/view/cam_words.hpp"
#include "output/view/key_words.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/view/valve_tables.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/search/plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int solution_line_width = 110;
// Of a peak in its unit, and by the cam angle beside it: "−123456 mm/rad³", "(−0.00287425 deg/deg³)".
constexpr int width_of_first = 17, width_of_beside = 22;
constexpr int figures = 9;  // of objective and bound: enough to see a gap of 1e-7

/// No backend ran, since laws and dwells fix the motion.
bool is_fixed(const Solution& solution) {
    return solution.scene.motion.prescribed() && solution.solver.termination == Termination::not_run;
}

std::string indented(const std::string& lines) {
    std::string text = "  ";
    for (const char letter : lines) {
        text += letter;
        if (letter == '\n') text += "  ";
    }
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

std::string peak_line(const PeakRow& row, const std::string& reference_name, bool in_time) {
    std::string line =
        fmt::format("  {:<14} {} = {:<8}", row.name, row.symbol, short_text(row.optimum.value));
    const std::string beside = row.beside_text();
    line += fmt::format("  {:<{}}", row.first_text(), width_of_first);
    if (in_time)
        line += fmt::format("  {:<{}}", beside.empty() ? "" : fmt::format("({})", beside), width_of_beside);
    if (row.reference)
        line += fmt::format("  {} {} ({})", reference_name, short_text(*row.reference),
                            change_text(row.optimum.value, *row.reference));
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

std::string peak_lines(const Solution& solution) {
    const ReferenceMotion reference = reference_motion(solution.scene);
    std::string text;
    for (const PeakRow& row : peak_comparison(solution, reference))
        text += peak_line(row, reference_title(reference), solution.scene.motion.speed.has_value());
    return text;
}

std::string segment_lines(const Solution& solution) {
    if (solution.segments.empty()) return {};
    return indented(aligned_text(segment_table(solution))) + fmt::format("  {}\n", segment_table_note());
}

std::string valve_lines(const Solution& solution) {
    std::string text;
    for (const ViewTable& one : valve_tables(solution)) text += indented(aligned_text(one.table));
    return text;
}

std::string set_point_lines(const Solution& solution) {
    const TextTable table = set_point_table(solution);
    std::string text = table.rows.empty() ? std::string() : indented(aligned_text(table));
    if (solution.measured)
        text += wrapped_text("measured: " + measured_sentence(solution), "  ", solution_line_width);
    return text;
}

std::string cam_lines(const Solution& solution) {
    if (!solution.cam) return {};
    const CamSpec& cam = solution.scene.cam.value();
    const TextTable table = cam_table(solution, {{"The cam", true}, {"", true}, {"at deg"}});
    const std::string dimensions = "dimensions: " + dimensions_text(solution);
    std::string text = fmt::format("  cam: {}\n", cam_text(cam));
    text += wrapped_text(dimensions, "  ", solution_line_width);
    text += indented(aligned_text(table));
    for (const std::string& remark : cam_remarks(solution))
        text += wrapped_text(remark, "  ", solution_line_width);
    return text;
}

std::string relaxation_lines(const Solution& solution) {
    std::string text;
    for (const std::string& remark : infeasible_remarks(solution))
        text += wrapped_text(remark, "  ", solution_line_width);
    return text;
}

}  // namespace

std::string objective_line(const Solution& solution, std::string_view separator) {
    const Certificate& certificate = solution.certificate;
    std::string line;
    const auto add = [&](std::string_view name, double value, int digits) {
        append_item(line, fmt::format("{} {}", name, short_text(value, digits)), separator);
    };
    if (std::isfinite(certificate.objective)) add("objective", certificate.objective, figures);
    if (certificate.lower_bound)
        add(certificate.proof_kind == ProofKind::any_curve_limit ? "bound for all curves"
            : searched_from_starts(solution) && certificate.proof_kind != ProofKind::boxes
                ? "bound of the convex relaxation"
                : "proved bound",
            *certificate.lower_bound, figures);
    if (certificate.gap) add("gap", *certificate.gap, 2);
    if (solution.any_curve_limit)
        add(any_curve_title(solution.scene), solution.any_curve_limit->objective, figures);
    return line;
}

std::string constraint_sentence(const Solution& solution, const ConstraintReport& row) {
    if (row.no_contact)
        return fmt::format("{} = {}: {} does not exist: {}", row.key, short_text(row.limit), row.name,
                           no_contact_words);
    if (is_nowhere(row))
        return fmt::format("{} = {}: the cam is {} (not active)", row.key, short_text(row.limit),
                           reached_text(row));
    return fmt::format("{} = {}: {} reaches {} ({})", row.key, short_text(row.limit), row.name,
                       reached_text(row), standing_words(solution, row));
}

std::string own_term_sentence(const OwnTermReport& term) {
    return fmt::format("{} reaches {}, {} in the objective (weight {}, reference {})", term.name,
                       short_text(term.value, figures),
                       short_text(term.weight * term.value / term.reference, figures),
                       short_text(term.weight), short_text(term.reference));
}

std::string relaxation_sentence(const Relaxation& row) {
    if (!row.needed)
        return fmt::format("{} = {}: {} alone helps", row.key, short_text(row.given),
                           row.ruled_out ? "no change of this limit" : "no value tried of it");
    return fmt::format("{} = {}: {}", row.key, short_text(row.given), change_words(row));
}

std::string no_solver_words(const std::string& named) {
    return "the motion is prescribed" + (named == "auto" ? "" : "; " + named + " is not used");
}

std::string solver_words(const Solution& solution) {
    const std::string& used = solution.solver.name;
    if (is_fixed(solution)) return "none, " + no_solver_words(solution.scene.solver.name);
    if (!solution.plan || solution.plan->solver == used || solution.plan->next_solver == used) return used;
    return fmt::format("{}; {} was not needed, the problem without the limits that are not convex decides it",
                       used, solution.plan->solver);
}

std::vector<std::string> solver_sentences(const Solution& solution) {
    const SolverReport& solver = solution.solver;
    std::vector<std::string> all;
    if (!solver.name.empty())
        all.push_back(
            fmt::format("Solver: {}{}{}; {} s in all.", solver_words(solution),
                        solver.choice.empty() ? "" : " (" + solver.choice + ")",
                        is_fixed(solution) ? ""
                        : solver.termination == Termination::not_run
                            ? "; not run: the search for a first point decided the scene"
                            : fmt::format("; it stopped as \"{}\" (iterations: {}, exchange rounds: {})",
                                          words_of(name_of(solver.termination)), solver.iterations,
                                          solver.exchange_rounds),
                        short_text(solution.seconds_total, 3)));
    if (searched_from_starts(solution))
        all.push_back(
            fmt::format("The scene is not convex; searches from different starts: {}.", solver.starts));
    if (!solver.proof_source.empty())
        all.push_back(fmt::format("The proof's multipliers: {}.", solver.proof_source));
    if (solution.certificate.proof)
        all.emplace_back(
            "To check the proof without camopt: certificate.json holds the rows, the multipliers, the box "
            "and the bound; its entry how_to_check describes the check, one sum.");
    return all;
}

std::string summary_text(const Solution& solution, std::span<const std::filesystem::path> written) {
    std::string text;
    if (!solution.scene.title.empty()) text += printable(solution.scene.title) + "\n";
    text += verdict_sentence(solution) + "\n";
    const std::string objective = objective_line(solution);
    if (!objective.empty()) text += "  " + objective + "\n";
    if (solution.motion) text += peak_lines(solution) + valve_lines(solution) + segment_lines(solution);
    for (const std::string& sentence : excursion_sentences(solution)) text += fmt::format("  {}\n", sentence);
    for (const OwnTermReport& term : solution.own_terms)
        text += fmt::format("  term: {}\n", own_term_sentence(term));
    for (const std::string& sentence : train_sentences(solution)) text += fmt::format("  {}\n", sentence);
    for (const std::string& sentence : drive_sentences(solution)) text += fmt::format("  {}\n", sentence);
    if (solution.surge)
        text += wrapped_text("spring surge: " + surge_sentence(solution), "  ", solution_line_width);
    if (solution.motion)
        for (const ConstraintReport& row : solution.constraints)
            text += fmt::format("  limit: {}\n", constraint_sentence(solution, row));
    text += set_point_lines(solution) + cam_lines(solution) + relaxation_lines(solution);
    for (const std::string& note : solution.notes) text += fmt::format("  note: {}\n", note);
    const SolverReport& solver = solution.solver;
    if (!solver.name.empty()) {
        text += "  solver: " + solver_words(solution);
        if (!is_fixed(solution))
            text +=
                fmt::format(", iterations {}, exchange rounds {}", solver.iterations, solver.exchange_rounds);
        text += fmt::format(", {} s\n", short_text(solution.seconds_total, 3));
    }
    for (const auto& path : written) text += fmt::format("  wrote {}\n", path.string());
    return text;
}

}  // namespace camopt

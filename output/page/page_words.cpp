// SPDX-License-Identifier: MIT
// What a page says in words and tables: for the engineer first, how it was found last.
#include "core/version.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/page/page_parts.hpp"
#include "output/view/cam_words.hpp"
#include "output/view/key_words.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/words/comparison_words.hpp"
#include "output/words/solution_text.hpp"
#include "scene/limit_table.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr int value_digits = 6;   // of headline and tables: one number, one text
constexpr double noticed = 0.05;  // per cent: a smaller change is none

std::string active_sentence(const Solution& solution) {
    std::vector<std::string> active;
    for (const ConstraintReport& row : solution.constraints)
        if (row.active)
            active.push_back(fmt::format("{} ({} at {} deg)", key_words(row.key).words, limit_text(row),
                                         degrees_at(solution, row.at)));
    if (solution.constraints.empty()) return "The scene sets no limits.";
    if (active.empty()) return "Every limit is satisfied with a margin: none is active.";
    return fmt::format("Active: {}. Relaxing these limits would improve the motion.",
                       fmt::join(active, "; "));
}

bool has_motion(const Solution& solution) {
    return solution.motion && solution.certificate.verdict != Verdict::infeasible;
}

/// "its peak acceleration is 12.3 % higher"
std::string peak_changes(const Solution& solution, const ComparisonRow& law) {
    std::vector<std::string> parts;
    const auto add = [&](const std::string& name, const Extremum& own, const Extremum& other) {
        if (!(own.value > 0.0)) return;
        if (std::isinf(other.value)) {
            parts.push_back(fmt::format("infinite {}", name));
            return;
        }
        const double change = 100.0 * (other.value / own.value - 1.0);
        if (std::abs(change) < noticed) return;
        parts.push_back(fmt::format("{} {} % {}", name, short_text(std::abs(change), 3),
                                    change > 0.0 ? "higher" : "lower"));
    };
    for (std::size_t order = 1;
         Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk})
        add(peak_words(order++), solution.peaks.*peak, law.peaks.*peak);
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Json table_json(std::string_view key, std::string_view title, const TextTable& table, std::string_view note) {
    Json columns = Json::array();
    for (const TextTable::Column& column : table.columns)
        columns.push_back({{"title", column.title}, {"left", column.left}});
    Json json = {{"key", key},
                 {"title", title},
                 {"columns", std::move(columns)},
                 {"rows", table.rows},
                 {"note", note}};
    if (!table.folders.empty()) json["folders"] = table.folders;
    return json;
}

Json verdict_part(const Solution& solution) {
    const Verdict verdict = solution.certificate.verdict;
    const VerdictWords plain = verdict_words(solution);
    Json sentences = Json::array({plain.meaning});
    if (has_motion(solution))
        sentences.push_back(active_sentence(solution));
    else if (solution.motion)
        sentences.push_back(
            solution.scene.motion.prescribed()
                ? "The curves show it, red where it violates a limit."
                : "The curves show the motion that violates the limits least, red where it does.");
    for (const std::string& sentence : excursion_sentences(solution)) sentences.push_back(sentence);
    if (!has_motion(solution))
        for (const std::string& remark : infeasible_remarks(solution)) sentences.push_back(remark);
    return {{"key", name_of(verdict)},
            {"tone", plain.tone},
            {"headline", plain.headline},
            {"sentences", std::move(sentences)}};
}

Json open_verdict_part(const Solution& solution) {
    const bool found = has_motion(solution);
    return {
        {"key", "open"},
        {"tone", "open"},
        {"headline", found ? "Not proved yet" : "No motion found yet"},
        {"sentences",
         Json::array({fmt::format("Solved to {} for the picture; the proof follows when the sliders stop.",
                                  short_text(solution.scene.solver.tolerance, 1))})}};
}

Json figures_part(const Solution& solution) {
    Json all = Json::array();
    if (!solution.motion) return all;
    const ShownUnits units = shown_units(solution.scene);
    const auto add = [&](const std::string& name, const std::string& value, double x) {
        all.push_back({{"name", name}, {"value", value}, {"at", degrees_at(solution, x) + " deg"}});
    };
    for (int order = 1; order <= 3; ++order) {
        const ShownDerivative& shown = units.motion[order];
        const Extremum peak = signed_peaks(solution, order).largest;
        add(peak_words(order), shown.first.normalised_text(peak.value, value_digits), peak.at);
    }
    if (!solution.cam) return all;
    const CamSummary& cam = solution.cam->summary;
    if (cam.pressure_angle.value > 0.0)
        add(figure_words::pressure_angle, units.angle.text(cam.pressure_angle.value, value_digits),
            cam.pressure_angle.at);
    if (const std::optional<CamExtreme> radius = convex_radius(cam))
        add("least convex radius", units.length.text(radius->value, value_digits), radius->at);
    if (cam.forces && cam.forces->hertz_pressure)
        add(figure_words::hertz_pressure,
            units.pressure.text(cam.forces->hertz_pressure->value, value_digits),
            cam.forces->hertz_pressure->at);
    return all;
}

Json reference_part(const Solution& solution, PageReference wish) {
    if (!has_motion(solution) || solution.scene.objective.reference.numeric) return nullptr;
    const std::string& key = solution.scene.objective.reference.law;
    const std::string name = words_of(key);
    Json sentences = Json::array();
    if (wish == PageReference::later) {
        sentences.push_back("Being compared …");
        return {{"title", name}, {"sentences", std::move(sentences)}};
    }
    const ComparisonRow law = compare_law(solution, key);
    if (!law.misfit.empty()) {
        sentences.push_back(fmt::format("The {} law does not fit this motion: {}.", name, law.misfit));
        return {{"title", name}, {"sentences", std::move(sentences)}};
    }
    // Of an axis of a machine the total is the least, not its own objective: a law is neither better nor
    // worse.
    if (!solution.machine.empty())
        sentences.push_back("Its objective is not compared: clearances to other axes hold, too.");
    else if (law.loss_percent)
        sentences.push_back(*law.loss_percent >= noticed
                                ? fmt::format("The {} law would be {} % worse in the objective.", name,
                                              short_text(*law.loss_percent, 3))
                                : fmt::format("The {} law would be no worse in the objective.", name));
    else if (std::isinf(law.objective))
        sentences.push_back(fmt::format("The {} law has no finite objective here.", name));
    if (const std::string changes = peak_changes(solution, law); !changes.empty())
        sentences.push_back(fmt::format("Its peaks compared with this motion: {}.", changes));
    const std::vector<std::string> broken = broken_limits(law);
    if (!broken.empty()) sentences.push_back(fmt::format("It would violate: {}.", fmt::join(broken, "; ")));
    return {{"title", name}, {"sentences", std::move(sentences)}};
}

Json tables_part(const Solution& solution) {
    Json all = Json::array();
    for (const ViewTable& one : result_tables(solution))
        all.push_back(table_json(one.key, one.title, one.table, one.note));
    return all;
}

Json appendix_part(const Solution& solution, const RunOrigin& origin) {
    Json sentences = Json::array({verdict_sentence(solution)});
    if (const std::string line = objective_line(solution, "; "); !line.empty())
        sentences.push_back(line + ".");
    for (const std::string& sentence : solver_sentences(solution)) sentences.push_back(sentence);
    for (const OwnTermReport& term : solution.own_terms) sentences.push_back(own_term_sentence(term));
    for (const std::string& sentence : train_sentences(solution)) sentences.push_back(sentence);
    for (const std::string& sentence : drive_sentences(solution)) sentences.push_back(sentence);
    return {{"sentences", std::move(sentences)}, {"command", origin.command}};
}

}  // namespace camopt

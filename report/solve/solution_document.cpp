// SPDX-License-Identifier: MIT
#include "report/solve/solution_document.hpp"

#include "input/scene_text.hpp"
#include "report/cam/cam_files.hpp"
#include "report/solve/cam_remarks.hpp"
#include "report/solve/infeasible_words.hpp"
#include "report/solve/least_words.hpp"
#include "report/solve/motion_remarks.hpp"
#include "report/solve/solution_tables.hpp"
#include "report/solve/tolerance_words.hpp"
#include "report/valves/valve_tables.hpp"
#include "report/view/broken_limits.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/peak_comparison.hpp"
#include "report/view/verdict_words.hpp"
#include "scene/limit_table.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;
using Sentences = std::vector<std::string>;

constexpr double noticed = 0.05;  // per cent: a smaller change is none

bool has_motion(const Solution& solution) {
    return solution.motion && solution.certificate.verdict != Verdict::infeasible;
}

/// What stands first on a page: the largest of the motion and the cam.
void add_first_figures(Section& section, const Solution& solution) {
    if (!solution.motion) return;
    const ShownUnits units = shown_units(solution.scene);
    const auto add = [&](const std::string& name, Cell cell, double x) {
        section.figures.push_back({{.key = name, .title = name, .where = Where::page},
                                   std::move(cell),
                                   {},
                                   degrees_shown,
                                   degrees_at(solution, x) + " deg"});
    };
    for (int order = 1; order <= 3; ++order) {
        const Extremum peak = signed_peaks(solution, order).largest;
        add(peak_words(order), motion_cell(units.motion[order].first, peak.value), peak.at);
    }
    if (!solution.cam) return;
    const CamSummary& cam = solution.cam->summary;
    if (cam.pressure_angle.value > 0.0)
        add(figure_words::pressure_angle, {cam.pressure_angle.value, units.angle}, cam.pressure_angle.at);
    if (const std::optional<CamExtreme> radius = convex_radius(cam))
        add("least convex radius", {radius->value, units.length}, radius->at);
    if (cam.forces && cam.forces->hertz_pressure)
        add(figure_words::hertz_pressure, {cam.forces->hertz_pressure->value, units.pressure},
            cam.forces->hertz_pressure->at);
}

Section open_section(const Solution& solution) {
    Section section;
    section.say(Kind::headline, "verdict", {has_motion(solution) ? "Not proved yet" : "No motion found yet"});
    section.say(Kind::verdict, "meaning",
                {fmt::format("Solved to {} for the picture; the proof follows when the sliders stop.",
                             short_text(solution.scene.solver.tolerance, 1))});
    add_first_figures(section, solution);
    return section;
}

Section verdict_section(const Solution& solution) {
    const VerdictWords plain = verdict_words(solution);
    Section section;
    section.say(Kind::headline, "verdict", {plain.headline}, Where::page);
    section.say(Kind::headline, "verdict", {verdict_sentence(solution)}, Where::texts);
    section.say(Kind::verdict, "meaning", {plain.meaning}, Where::page);
    if (std::string least = least_sentence(solution); !least.empty())
        section.say(Kind::verdict, "least", {std::move(least)});
    if (has_motion(solution))
        section.say(Kind::verdict, "active", {active_sentence(solution)},
                    solution.constraints.empty() ? Where::everywhere : Where::page);
    else if (solution.motion)
        section.say(Kind::verdict, "curves",
                    {solution.scene.motion.prescribed()
                         ? "The curves show it, red where it violates a limit."
                         : "The curves show the motion that violates the limits least, red where it does."},
                    Where::page);
    section.say(Kind::warning, "excursion", excursion_sentences(solution));
    section.say(Kind::remark, "changes", infeasible_remarks(solution),
                has_motion(solution) ? Where::texts : Where::everywhere);
    section.say(Kind::note, "note", solution.notes, Where::console | Where::page);
    for (const BoundFigure& one : bound_figures(solution))
        section.figures.push_back(
            {{.key = one.key, .title = one.title, .where = Where::texts}, {one.value, one.digits}});
    if (solution.certificate.stationarity)
        section.figures.push_back({{"stationarity", "stationarity residual", {}, false, {}, Where::markdown},
                                   {solution.certificate.stationarity, 3}});
    add_first_figures(section, solution);
    section.tables = {change_table(solution)};
    return section;
}

/// "its peak acceleration is 12.3 % higher"
std::string peak_changes(const Solution& solution, const ComparisonRow& law) {
    Sentences parts;
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

Sentences reference_sentences(const Solution& solution, PageReference wish) {
    const std::string& key = solution.scene.objective.reference.law;
    const std::string name = words_of(key);
    if (wish == PageReference::later) return {"Being compared …"};
    const ComparisonRow law = compare_law(solution, key);
    if (!law.misfit.empty())
        return {fmt::format("The {} law does not fit this motion: {}.", name, law.misfit)};
    Sentences sentences;
    // Of an axis of a machine the total is the least, not its own objective: a law is neither better nor
    // worse.
    if (!solution.machine.empty())
        sentences.emplace_back("Its objective is not compared: clearances to other axes hold, too.");
    else if (law.loss_percent)
        sentences.push_back(*law.loss_percent >= noticed
                                ? fmt::format("The {} law would be {} % worse in the objective.", name,
                                              short_text(*law.loss_percent, 3))
                                : fmt::format("The {} law would be no worse in the objective.", name));
    else if (std::isinf(law.objective))
        sentences.push_back(fmt::format("The {} law has no finite objective here.", name));
    if (const std::string changes = peak_changes(solution, law); !changes.empty())
        sentences.push_back(fmt::format("Its peaks compared with this motion: {}.", changes));
    if (solution.output) {  // the limits of a cam that it does not have
        sentences.emplace_back(
            "No cam makes the output move so: where a law's jerk jumps, the cam would need an impulse.");
        return sentences;
    }
    const Sentences broken = broken_limits(law);
    if (!broken.empty()) sentences.push_back(fmt::format("It would violate: {}.", fmt::join(broken, "; ")));
    return sentences;
}

Section motion_section(const Solution& solution) {
    Section section{.key = "motion"};
    section.tables = {measured_table(solution)};
    if (solution.measured)
        section.say(Kind::remark, "measured", {"measured: " + measured_sentence(solution)}, Where::console);
    if (!solution.motion) return section;
    if (solution.surge)
        section.say(Kind::remark, "surge", {"spring surge: " + surge_sentence(solution)}, Where::console);
    const auto add = [&](Table table) { section.tables.push_back(std::move(table)); };
    add(peak_table(solution));
    for (Table& table : valve_tables(solution)) add(std::move(table));
    add(segment_table(solution));
    add(limit_table(solution));
    add(set_point_table(solution));
    add(surge_table(solution));
    section.pictures = {{"motion", "Displacement, velocity, acceleration and jerk"}};
    if (solution.surge) section.pictures.push_back({"surge", "Harmonics of the lift"});
    return section;
}

Section drive_section(const Solution& solution) {
    Section section = listing("motor", "The motor", drive_sentences(solution));
    if (solution.drive) section.pictures = {{"drive", "Torque and speed of the motor, torque over speed"}};
    return section;
}

Section terms_section(const Solution& solution) {
    Sentences sentences;
    for (const OwnTermReport& term : solution.own_terms) sentences.push_back(own_term_sentence(term));
    return listing("terms", "Terms of the program", std::move(sentences));
}

void add_cam(std::vector<Section>& sections, const Solution& solution) {
    if (!solution.cam) return;
    sections.push_back({.key = "cam", .tables = cam_tables(solution)});
    Section remarks = listing("remarks", "On the cam", cam_remarks(solution));
    for (const CamFile& file : cam_file_list(solution))
        if (!file.title.empty())
            remarks.pictures.push_back({file.name.substr(0, file.name.rfind('.')), file.title});
    if (!has_cam_table(solution))
        remarks.say(Kind::remark, "export",
                    {"camopt export writes its flanks as points, surfaces and a solid, and the NC program."},
                    Where::markdown);
    sections.push_back(std::move(remarks));
}

Section design_section(const DesignReport& design) {
    constexpr std::size_t most = 40;  // longer lists stand in result.json
    Section section{.key = "design", .title = fmt::format("Design vector ({})", name_of(design.kind))};
    section.where = Where::markdown;
    if (design.names.size() > most)
        section.say(Kind::effort, "design",
                    {fmt::format("{} values: see design in result.json.", design.names.size())});
    else
        section.tables = {design_table(design)};
    return section;
}

Section effort_section(const Solution& solution) {
    Section section{.key = "found", .title = "How it was found"};
    section.say(Kind::effort, "verdict", {verdict_sentence(solution)}, Where::page);
    if (const std::string line = objective_line(solution, "; "); !line.empty())
        section.say(Kind::effort, "objective", {line + "."}, Where::page);
    unsigned where = Where::everywhere;
    for (std::string& sentence : solver_sentences(solution)) {
        section.say(Kind::effort, "solver", {std::move(sentence)}, where);
        where = Where::reports;  // one line is enough for a console
    }
    return section;
}

/// Every key with its meaning, and the text itself: the report alone repeats the run. Pages have the text,
/// and without one the keys.
Section key_section(const Scene& scene, const RunOrigin& origin) {
    Section section{.key = "keys", .code = origin.scene_text};
    section.where = Where::reports;
    Table& table = section.tables.emplace_back(
        Table{"keys",
              "The scene, key by key",
              {{.key = "key", .left = true, .code = true},
               {.key = "value", .left = true, .code = true},
               {.key = "unit", .left = true},
               {.key = "meaning", .left = true, .where = Where::markdown}},
              {},
              std::string("What is not listed has its default (`camopt list keys`).") +
                  (origin.scene_text.empty() ? ""
                                             : " Saved as a file, the text below repeats this report: "
                                               "`camopt solve FILE --out DIR`.")});
    for (const input::WrittenKey& row : origin.scene_text.empty()
                                            ? input::keys_of(scene)
                                            : input::keys_written_in(origin.scene_text, origin.scene_file))
        table.rows.push_back({row.key, row.value, row.unit, row.meaning});
    return section;
}

/// Number, revision and date of the title block behind the title.
std::string foot_words(const Scene& scene, std::string text) {
    for (const auto& [label, words] : title_block_words(scene))
        if (label == "number" || label == "revision" || label == "date")
            text += fmt::format(" · {}{}", label == "number" ? "" : label + " ", words);
    return text;
}

}  // namespace

Document solution_document(const Solution& solution, const RunOrigin& origin, const SolutionWishes& wishes) {
    const Scene& scene = solution.scene;
    Document document{scene.title.empty() ? "Motion" : scene.title};
    document.foot = foot_words(scene, document.title);
    document.tone = wishes.proof ? verdict_words(solution).tone : "open";
    document.verdict = wishes.proof ? name_of(solution.certificate.verdict) : document.tone;
    std::vector<Section>& all = document.sections;
    if (!wishes.proof) {
        all = {open_section(solution)};
        return document;
    }
    all = {verdict_section(solution)};
    const bool page = (wishes.where & Where::page) != 0;
    if (page && has_motion(solution) && !scene.objective.reference.numeric)
        all.push_back(listing("reference", "Against " + words_of(scene.objective.reference.law),
                              reference_sentences(solution, wishes.reference), Where::page));
    all.push_back(motion_section(solution));
    all.push_back(terms_section(solution));
    all.push_back(listing("dynamics", "Dynamics", train_sentences(solution)));
    all.push_back(drive_section(solution));
    add_cam(all, solution);
    all.push_back(listing("tolerance", "Tolerances", tolerance_sentences(solution)));
    all.push_back(design_section(solution.design));
    all.push_back(effort_section(solution));
    all.push_back(listing("notes", "Notes", solution.notes, Where::markdown));
    const unsigned for_keys = origin.scene_text.empty() ? Where::reports : Where::markdown;
    if ((wishes.where & for_keys) != 0) all.push_back(key_section(scene, origin));
    return document;
}

std::string summary_text(const Solution& solution) {
    return console_text(solution_document(solution, {}, {.where = Where::console}));
}

std::string report_markdown(const Solution& solution, const RunOrigin& origin) {
    return document_markdown(solution_document(solution, origin, {.where = Where::markdown}), origin);
}

std::vector<FolderFile> solution_texts(const Solution& solution, const RunOrigin& origin) {
    return text_files(solution_document(solution, origin, {.where = Where::markdown}), origin);
}

}  // namespace camopt

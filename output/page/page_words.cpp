// SPDX-License-Identifier: MIT
// What a page says in words and tables: for the engineer first, how it was found last.
#include "core/units.hpp"
#include "core/version.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/chart/reference_motion.hpp"
#include "output/page/page_parts.hpp"
#include "output/words/angle_words.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/comparison_words.hpp"
#include "output/words/infeasible_words.hpp"
#include "output/words/key_words.hpp"
#include "output/words/number_text.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/tables/dynamics_text.hpp"
#include "output/words/tables/peak_comparison.hpp"
#include "output/words/tables/segment_table.hpp"
#include "profiles/scene_cam.hpp"
#include "studies/compare/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr int value_digits = 6, headline_digits = 5;  // fewer would make 22637 a power of ten
constexpr double noticed = 0.05;                      // per cent: a smaller change is none

struct PlainVerdict {
    const char* tone;
    const char* headline;
    const char* meaning;
};

/// For who never heard of a bound.
PlainVerdict plain_verdict(Verdict verdict) {
    switch (verdict) {
        case Verdict::optimal:
            return {"good", "The best motion, and proved to be it",
                    "It keeps every limit, and no motion of this spline does better by the weights of the "
                    "scene."};
        case Verdict::local:
            return {"good", "A good motion: no small change makes it better",
                    "It keeps every limit. That quite another motion is better still is not ruled out."};
        case Verdict::feasible:
            return {"fair", "A motion that keeps every limit",
                    "Whether it is the best one is not known: the search ended before."};
        case Verdict::infeasible:
            return {"bad", "No motion keeps all of these limits",
                    "This is proved, not only tried: something in the scene has to give way."};
        case Verdict::failed:
            break;
    }
    return {"bad", "No motion was found",
            "And no proof that there is none either; see the notes and the appendix."};
}

std::string active_sentence(const Solution& solution) {
    std::vector<std::string> active;
    for (const ConstraintReport& row : solution.constraints)
        if (row.active)
            active.push_back(fmt::format("{} ({} {} at {} deg)", key_words(row.key).words,
                                         short_text(row.limit), row.unit, degrees_at(solution, row.at)));
    if (solution.constraints.empty()) return "The scene sets no limits.";
    if (active.empty()) return "Every limit is kept with room to spare: none of them shapes the motion.";
    return fmt::format("What shapes it: {}. More room there would make the motion better.",
                       fmt::join(active, "; "));
}

bool has_motion(const Solution& solution) {
    return solution.motion && solution.certificate.verdict != Verdict::infeasible;
}

}  // namespace

Json table_json(std::string_view key, std::string_view title, const TextTable& table, std::string_view note) {
    Json columns = Json::array();
    for (const TextTable::Column& column : table.columns)
        columns.push_back({{"title", column.title}, {"left", column.left}});
    return {{"key", key},
            {"title", title},
            {"columns", std::move(columns)},
            {"rows", table.rows},
            {"note", note}};
}

Json verdict_part(const Solution& solution) {
    const Verdict verdict = solution.certificate.verdict;
    const PlainVerdict plain = plain_verdict(verdict);
    Json sentences = Json::array({plain.meaning});
    if (has_motion(solution))
        sentences.push_back(active_sentence(solution));
    else
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
         Json::array({fmt::format("Solved to {} for the picture; the proof follows once the sliders rest.",
                                  short_text(solution.scene.solver.tolerance, 1))})}};
}

Json figures_part(const Solution& solution) {
    Json all = Json::array();
    if (!solution.motion) return all;
    const ShownUnits units = shown_units(solution.scene);
    const auto add = [&](const std::string& name, const std::string& value, double x) {
        all.push_back({{"name", name}, {"value", value}, {"at", degrees_at(solution, x) + " deg"}});
    };
    const std::array<const Extremum*, 3> peaks = {
        &solution.motion_peaks.velocity, &solution.motion_peaks.acceleration, &solution.motion_peaks.jerk};
    for (std::size_t i = 0; i < peaks.size(); ++i)
        add("peak " + units.motion[i + 1].name,
            units.motion[i + 1].first.normalised_text(peaks[i]->value, headline_digits), peaks[i]->at);
    if (!solution.cam) return all;
    const CamSummary& cam = solution.cam->summary;
    add("largest pressure angle", units.angle.text(cam.pressure_angle.value, headline_digits),
        cam.pressure_angle.at);
    if (const std::optional<CamExtreme> radius = convex_radius(cam))
        add("least convex radius", units.length.text(radius->value, headline_digits), radius->at);
    if (cam.forces && cam.forces->hertz_pressure)
        add("largest Hertz pressure", units.pressure.text(cam.forces->hertz_pressure->value, headline_digits),
            cam.forces->hertz_pressure->at);
    return all;
}

namespace {

/// "its peak acceleration is 12.3 % higher"
std::string peak_changes(const Solution& solution, const ComparisonRow& law) {
    std::vector<std::string> parts;
    const auto add = [&](const char* name, const Extremum& own, const Extremum& other) {
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
    add("peak velocity", solution.peaks.velocity, law.peaks.velocity);
    add("peak acceleration", solution.peaks.acceleration, law.peaks.acceleration);
    add("peak jerk", solution.peaks.jerk, law.peaks.jerk);
    return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

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
    if (law.loss_percent)
        sentences.push_back(
            *law.loss_percent >= noticed
                ? fmt::format("In its place the {} law would lose {} % of the objective.", name,
                              short_text(*law.loss_percent, 3))
                : fmt::format("By the weights of the scene the {} law would be no worse.", name));
    else
        sentences.push_back(fmt::format("The {} law has no finite objective here.", name));
    if (const std::string changes = peak_changes(solution, law); !changes.empty())
        sentences.push_back(fmt::format("Its peaks against this motion: {}.", changes));
    const std::vector<std::string> broken = broken_limits(law);
    if (!broken.empty()) sentences.push_back(fmt::format("It would break: {}.", fmt::join(broken, "; ")));
    return {{"title", name}, {"sentences", std::move(sentences)}};
}

namespace {

std::string optional_words(const std::optional<double>& value) {
    return value ? short_text(*value) : "–";
}

TextTable peak_rows(const Solution& solution) {
    const ReferenceMotion reference = reference_motion(solution.scene);
    const ShownUnits units = shown_units(solution.scene);
    TextTable table;
    const bool beside = units.motion[1].beside.has_value();
    table.columns = {{"", true}, {"peak"}, {"at (deg)"}};
    if (beside) table.columns.push_back({"by cam angle"});
    for (const std::string& title :
         {std::string("normalised"), reference_title(reference), std::string("change")})
        table.columns.push_back({title});
    const std::vector<PeakRow> rows = peak_comparison(solution, reference);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const PeakRow& row = rows[i];
        const bool derivative = i + 1 < units.motion.size();
        std::vector<std::string> cells = {row.name};
        cells.push_back(derivative ? units.motion[i + 1].first.normalised_text(row.motion.value, value_digits)
                                   : "–");
        cells.push_back(degrees_at(solution, row.motion.at));
        if (beside)
            cells.push_back(derivative
                                ? units.motion[i + 1].beside->normalised_text(row.motion.value, value_digits)
                                : "–");
        cells.push_back(fmt::format("{} = {}", row.symbol, short_text(row.optimum.value)));
        cells.push_back(optional_words(row.reference));
        cells.push_back(row.reference ? change_text(row.optimum.value, *row.reference) : "–");
        table.rows.push_back(std::move(cells));
    }
    return table;
}

TextTable limit_rows_of(const Solution& solution) {
    TextTable table;
    table.columns = {{"limit", true}, {"allowed"}, {"reached"}, {"at (deg)"}, {"", true}};
    for (const ConstraintReport& row : solution.constraints)
        table.rows.push_back(
            {key_words(row.key).words, fmt::format("{} {}", short_text(row.limit), row.unit),
             row.no_contact
                 ? std::string(no_contact_words)
                 : fmt::format("{} {}{}", short_text(row.worst, value_digits), row.unit, on_side(row)),
             degrees_at(solution, row.at),
             std::string(row.active ? "shapes the motion" : "kept") + (row.verified ? ", verified" : "")});
    return table;
}

TextTable dimension_rows(const Solution& solution) {
    TextTable table;
    table.columns = {{"dimension", true}, {"value"}, {"", true}};
    const MechanismSpec spec = cam_of(solution.scene).value();
    const ShownUnits shown = shown_units(solution.scene);
    const auto value_text = [&](const DimensionValue& dimension) {
        if (!dimension.shown) return std::string("free");
        return dimension.is_angle ? shown.angle.text(*dimension.shown * units::degree)
                                  : shown.length.text(*dimension.shown * units::millimetre);
    };
    for (const DimensionValue& dimension : cam_dimensions(solution)) {
        const auto found = std::ranges::find(spec.dimensions, dimension.name, &MechanismDimension::name);
        const bool given = found != spec.dimensions.end();
        table.rows.push_back({words_of(dimension.name), value_text(dimension),
                              !given                       ? "follows"
                              : found->value.is_variable() ? "chosen by the optimiser"
                                                           : "given"});
    }
    return table;
}

TextTable figure_rows(const Solution& solution) {
    TextTable table;
    table.columns = {{"", true}, {"value"}, {"at (deg)"}};
    for (const CamFigure& figure : cam_figures(solution))
        table.rows.push_back({figure.name, figure.value, figure.degrees});
    return table;
}

TextTable relaxation_rows(const Solution& solution) {
    TextTable table;
    table.columns = {{"limit or dimension", true}, {"given"}, {"needed, if nothing else changes"}};
    for (const Relaxation& row : solution.relaxation)
        table.rows.push_back({row.key, short_text(row.given),
                              row.needed      ? needed_number(row) + also_words(row)
                              : row.ruled_out ? "no change helps"
                                              : "no value tried helps"});
    return table;
}

}  // namespace

Json tables_part(const Solution& solution) {
    Json all = Json::array();
    if (!solution.relaxation.empty())
        all.push_back(table_json("changes", "What would have to change", relaxation_rows(solution)));
    if (!solution.motion) return all;
    all.push_back(
        table_json("peaks", "Peaks of the motion", peak_rows(solution),
                   "Exact, not sampled. Normalised: by lift and rise angle, of a program by each spline "
                   "segment's own."));
    if (!solution.segments.empty())
        all.push_back(table_json("segments", "Segments", segment_table(solution), segment_table_note()));
    if (!solution.constraints.empty()) all.push_back(table_json("limits", "Limits", limit_rows_of(solution)));
    if (!solution.cam) return all;
    all.push_back(table_json("dimensions", "Dimensions", dimension_rows(solution),
                             cam_text(cam_of(solution.scene).value()) + "."));
    all.push_back(table_json("cam", "Figures of the cam", figure_rows(solution)));
    return all;
}

Json appendix_part(const Solution& solution, const RunOrigin& origin) {
    Json sentences = Json::array({verdict_sentence(solution)});
    if (const std::string line = objective_line(solution, "; "); !line.empty())
        sentences.push_back(line + ".");
    const SolverReport& solver = solution.solver;
    if (!solver.name.empty())
        sentences.push_back(fmt::format("Solver: {}{}; {} iterations, {} exchange rounds, {} s in all.",
                                        solver.name, solver.choice.empty() ? "" : " (" + solver.choice + ")",
                                        solver.iterations, solver.exchange_rounds,
                                        short_text(solution.seconds_total, 3)));
    if (!solver.convex && solver.starts > 0)
        sentences.push_back(
            fmt::format("The scene is not convex; searches from different starts: {}.", solver.starts));
    if (!solver.proof_source.empty())
        sentences.push_back(fmt::format("The proof's multipliers: {}.", solver.proof_source));
    if (solution.certificate.proof)
        sentences.push_back(
            "certificate.json beside this page holds the proof with a recipe to check it without camopt: one "
            "sum.");
    for (const OwnTermReport& term : solution.own_terms) sentences.push_back(own_term_sentence(term));
    for (const std::string& sentence : train_sentences(solution)) sentences.push_back(sentence);
    return {{"sentences", std::move(sentences)}, {"command", origin.command}};
}

}  // namespace camopt

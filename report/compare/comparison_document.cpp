// SPDX-License-Identifier: MIT
#include "report/compare/comparison_document.hpp"

#include "report/document/common_figures.hpp"
#include "report/view/broken_limits.hpp"
#include "report/view/verdict_words.hpp"
#include "scene/cost_table.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;
using Row = ComparisonRow;

constexpr int peak_figures_shown = 4;  // of peaks, in sentences too
constexpr int objective_decimals = 6, peak_decimals = 4;
constexpr int base_decimals = 3, base_decimals_of_inches = 4;  // a micrometre, a ten-thousandth of an inch
constexpr int overlay_steps = 180;

const ShownUnit loss_unit("%", 1.0, "_percent");

std::string loss_words(const Row& row) {
    if (row.is_optimum()) return "0 %";
    const double rounded = std::round(100.0 * *row.loss_percent) / 100.0;
    if (rounded == 0.0) return "±0.00 %";
    return fmt::format("{}{:.2f} %", rounded > 0.0 ? "+" : "−", std::abs(rounded));
}

/// The best law that satisfies every limit; null where none does.
const Row* best_law(const Comparison& comparison) {
    for (const Row& row : comparison.rows)
        if (row.is_law() && row.feasible && std::isfinite(row.objective)) return &row;
    return nullptr;
}

/// Empty where the scene limits no cam.
std::string base_words(const Comparison& comparison, const Row& row) {
    if (!row.base) return {};
    if (!row.base->radius) return "none";
    const Scene& scene = comparison.optimum.scene;
    return fixed_text(shown_units(scene).length.of(*row.base->radius),
                      scene.length_unit == LengthUnit::inch ? base_decimals_of_inches : base_decimals);
}

/// What the laws lose at least, or that none satisfies every limit.
std::string best_sentence(const Comparison& comparison) {
    const Row* best = best_law(comparison);
    if (!best) return "No law of the catalogue satisfies every limit with a finite objective";
    const bool differs = std::ranges::any_of(comparison.rows, [&](const Row& row) {
        return row.misfit.empty() && row.objective != best->objective;
    });
    if (!differs && best->base && best->base->radius)
        return fmt::format("The law that satisfies every limit with the smallest base radius: {}, {} {}",
                           best->title, base_words(comparison, *best),
                           shown_units(comparison.optimum.scene).length.name);
    if (!differs) return "The laws do not differ in the objective";
    if (!best->loss_percent)
        return fmt::format("The best law that satisfies every limit: {}, objective {}", best->title,
                           short_text(best->objective));
    std::string sentence =
        fmt::format("The best law that satisfies every limit: {}, {} compared with the optimum", best->title,
                    loss_words(*best));
    if (*best->loss_percent >= 0.0) return sentence;
    // Of a proved optimum only the spline can be to blame; a search may have missed a better one.
    return sentence + (comparison.optimum.certificate.verdict == Verdict::optimal
                           ? ": the spline is coarse; more segments would improve on that law"
                           : ": the optimum is not proved; more starts or segments may improve on that law");
}

/// "0.4 V/1.76 + 0.4 A/5.528 + 0.2 J/69.47".
std::string objective_words(const Solution& solution) {
    const ObjectiveSpec& objective = solution.scene.objective;
    std::vector<std::string> terms;
    const auto add = [&](double weight, const std::string& symbol, double divisor) {
        if (weight != 0.0)
            terms.push_back(
                fmt::format("{} {}/{}", short_text(weight), symbol, short_text(divisor, peak_figures_shown)));
    };
    for (const CostTerm& term : cost_terms())
        add(term.weight_in(objective), term.symbol, term.measured.of(solution.reference_peaks));
    for (const OwnTermReport& term : solution.own_terms)
        add(term.weight, term.of_scene ? words_of(term.name) : term.name, term.reference);
    if (solution.train)
        for (const ResponseTermReport& term : solution.train->terms)
            add(term.weight, words_of(term.name), term.reference);
    if (std::ranges::any_of(objective.dimensions, [](double weight) { return weight > 0.0; }))
        terms.emplace_back("dimensions of the cam");
    return terms.empty() ? "none" : fmt::format("{}", fmt::join(terms, " + "));
}

std::vector<Sentence> sentences_of(const Comparison& comparison) {
    const Solution& solution = comparison.optimum;
    std::vector<Sentence> all = {{Kind::headline, "best_law", best_sentence(comparison)},
                                 {Kind::verdict, "verdict", verdict_sentence(solution)}};
    if (!solution.motion)
        all.push_back({Kind::remark, "changes", "For the suggested changes run camopt solve."});
    all.push_back({Kind::remark, "objective", fmt::format("Objective: {}.", objective_words(solution))});
    for (const std::string& note : solution.notes) all.push_back({Kind::note, "", note});
    return all;
}

std::vector<Figure> figures_of(const Comparison& comparison, const RunOrigin& origin) {
    std::vector<Figure> all = {
        {{"study"}, "compare"}, {{"scene"}, origin.scene_file}, {{"command"}, origin.command}};
    std::ranges::move(verdict_figures(comparison.optimum.certificate), std::back_inserter(all));
    const std::optional<CamSpec>& spec = comparison.optimum.scene.cam;
    if (!comparison.cam || !spec) all.push_back({{"dimensions"}, Cell()});
    for (std::size_t i = 0; comparison.cam && spec && i < spec->dimensions.size(); ++i) {
        const CamDimension& dimension = spec->dimensions[i];
        if (dimension.value.key.empty()) continue;  // this variant has no such dimension
        all.push_back(
            {{"dimensions." + dimension.name, {}, dimension.is_angle ? degrees_shown : millimetres_shown},
             Cell(comparison.cam->dimensions[i])});
    }
    const Row* const best = best_law(comparison);
    all.push_back({{"best_law"}, best ? Cell(best->key) : Cell()});
    return all;
}

std::string limits_words(const Comparison& comparison, const Row& row) {
    if (!row.misfit.empty()) return "left out: " + row.misfit;
    const std::vector<std::string> broken = broken_limits(row);
    if (!broken.empty()) return fmt::format("{}", fmt::join(broken, "; "));
    if (row.limits.empty()) return "";
    if (row.is_optimum() && !row.feasible)
        return fmt::format("the solve is {}", name_of(comparison.optimum.certificate.verdict));
    return "kept";
}

Cell limits_cell(const Comparison& comparison, const Row& row) {
    const double degrees_per_x = file_units(comparison.optimum.scene).degrees_per_x;
    std::vector<std::vector<Figure>> all;
    for (const LimitOutcome& outcome : row.limits) {
        const ConstraintReport& reached = outcome.reached;
        all.push_back({{{"name"}, reached.name},
                       {{"limit"}, Cell(reached.limit)},
                       {{"worst"}, Cell(reached.worst)},
                       {{"unit"}, reached.unit},
                       {{"at_deg"}, is_nowhere(reached) ? Cell() : Cell(reached.at * degrees_per_x)},
                       {{"kept"}, flag(outcome.kept)},
                       {{"no_contact"}, flag(reached.no_contact)},
                       {{"excess"}, Cell(outcome.excess)},
                       {{"key"}, reached.key}});
    }
    Cell cell(limits_words(comparison, row));
    cell.list = std::make_shared<const std::vector<std::vector<Figure>>>(std::move(all));
    return cell;
}

std::optional<double> number_of(const Row& row, double value) {
    return row.misfit.empty() ? std::optional(value) : std::nullopt;
}

struct MotorColumn {
    const char *key, *symbol;
    ShownUnit unit;
    std::function<std::optional<double>(const Row&)> value;
};

/// None without a motor.
std::vector<MotorColumn> motor_columns(const Scene& scene, const ShownUnits& units) {
    if (!scene.drive) return {};
    const auto of = [](const auto& figure) {
        return [figure](const Row& row) {
            return row.drive ? std::optional<double>(figure(*row.drive)) : std::nullopt;
        };
    };
    return {{"motor_torque", "τ", units.torque, of([](const DriveFigures& one) { return one.torque.value; })},
            {"motor_torque_rms", "rms τ", units.torque,
             of([](const DriveFigures& one) { return one.rms_torque; })},
            {"motor_speed", "n", rpm_shown, of([](const DriveFigures& one) { return one.speed.value; })}};
}

/// Peaks as a person reads them where the scene has a speed, and what the motor has to give: four figures of
/// the largest.
void add_physical_peaks(Table& table, const Comparison& comparison) {
    const ShownUnits shown = shown_units(comparison.optimum.scene);
    if (!shown.in_time) return;
    const auto add = [&](const char* key, const std::string& symbol, const ShownUnit& unit,
                         const std::function<std::optional<double>(const Row&)>& value) {
        double largest = 0.0;
        for (const Row& row : comparison.rows)
            if (const double one = unit.of(value(row).value_or(0.0)); std::isfinite(one))
                largest = std::max(largest, one);
        Field field{key, symbol + " " + unit.name, unit};
        field.decimals =
            largest > 0.0
                ? std::max(0, peak_figures_shown - 1 - static_cast<int>(std::floor(std::log10(largest))))
                : 0;
        table.add_column(std::move(field), comparison.rows, value);
    };
    std::size_t order = 1;
    for (const auto& [key, peak] : {std::pair("v", &Peaks::velocity), std::pair("a", &Peaks::acceleration),
                                    std::pair("j", &Peaks::jerk)}) {
        const MotionUnit& unit = shown.motion[order++].first;
        add(key, unit.symbol, unit, [&unit, peak = peak](const Row& row) {
            return number_of(row, unit.size * unit.per_normalised * (row.motion_peaks.*peak).value);
        });
    }
    for (const MotorColumn& column : motor_columns(comparison.optimum.scene, shown))
        add(column.key, column.symbol, column.unit, column.value);
}

/// V, A, J, and the others for files.
void add_peaks(Table& table, const Comparison& comparison) {
    for (const PeakFigure& figure : peak_figures) {
        const std::string key = fmt::format("peaks.{}", figure.name);
        Field field{figure.extremum != nullptr ? key + ".value" : key};
        const auto term = std::ranges::find_if(cost_terms(), [&](const CostTerm& one) {
            return one.kind == CostTerm::Kind::peak && one.measured.name == figure.name;
        });
        if (term == cost_terms().end())
            field.where = Where::files;
        else
            field.title = term->symbol;
        field.decimals = peak_decimals;
        table.add_column(std::move(field), comparison.rows,
                         [&](const Row& row) { return number_of(row, figure.of(row.peaks)); });
        if (figure.extremum == nullptr) continue;
        table.add_column({.key = key + ".at", .where = Where::files}, comparison.rows,
                         [&](const Row& row) { return number_of(row, (row.peaks.*figure.extremum).at); });
    }
}

/// The motions of all laws by the cam angle.
void add_overlays(Table& table, const Comparison& comparison) {
    const auto longest =
        std::ranges::find_if(comparison.rows, [](const Row& row) { return row.motion != nullptr; });
    if (longest == comparison.rows.end()) return;
    const ShownUnits units = shown_units(comparison.optimum.scene);
    const double begin = longest->motion->begin(), end = longest->motion->end();
    const auto place = [&](int i) { return begin + (end - begin) * i / overlay_steps; };
    for (int i = 0; i <= overlay_steps; ++i) table.overlay_angles.push_back(units.degrees_per_x * place(i));
    for (std::size_t order = 0; order < units.motion.size(); ++order) {
        const MotionUnit& unit = units.motion[order].first;
        Overlay& overlay = table.overlays.emplace_back(
            Overlay{units.motion[order].name, unit.symbol, static_cast<const ShownUnit&>(unit)});
        for (const Row& row : comparison.rows) {
            std::vector<double>& line = overlay.lines.emplace_back();
            for (int i = 0; row.motion && i <= overlay_steps; ++i) {
                const Side side = i < overlay_steps ? Side::right : Side::left;
                line.push_back(unit.per_normalised * row.motion->at(place(i), side).derivative[order]);
            }
        }
    }
}

Table law_table(const Comparison& comparison) {
    const std::vector<Row>& rows = comparison.rows;
    const Scene& scene = comparison.optimum.scene;
    Table table{"rows", "Laws"};
    const auto add = [&](Field field, const auto& cell_of) {
        table.add_column(std::move(field), rows, cell_of);
    };
    add({.key = "law", .where = Where::files}, [](const Row& row) { return row.key; });
    add({.key = "title", .title = "law", .left = true}, [](const Row& row) { return row.title; });
    add({.key = "fits", .where = Where::files}, [](const Row& row) { return flag(row.misfit.empty()); });
    add({.key = "misfit", .where = Where::files}, [](const Row& row) { return row.misfit; });
    add({.key = "feasible", .where = Where::files}, [](const Row& row) { return flag(row.feasible); });
    add({.key = "objective", .decimals = objective_decimals},
        [](const Row& row) { return number_of(row, row.objective); });
    add({"loss", "loss", loss_unit}, [](const Row& row) {
        return row.loss_percent ? Cell(row.loss_percent).in_words(loss_words(row)) : Cell();
    });
    add_physical_peaks(table, comparison);
    add_peaks(table, comparison);
    const ShownUnit length = shown_units(scene).length;
    const std::string base_title = "base " + length.name;
    add({"base_radius.needed", base_title, millimetres_shown}, [&](const Row& row) {
        if (!row.base) return Cell();
        return Cell(row.base->radius.value_or(std::nan(""))).in_words(base_words(comparison, row));
    });
    add({.key = "base_radius.stays_broken", .where = Where::files},
        [](const Row& row) { return row.base ? row.base->broken : std::string(); });
    if (scene.drive)
        add({.key = "drive", .where = Where::files}, [&](const Row& row) {
            Cell cell;
            if (row.drive)
                cell.object = std::make_shared<const std::vector<Figure>>(drive_figures(scene, *row.drive));
            return cell;
        });
    add({.key = "limits", .left = true}, [&](const Row& row) { return limits_cell(comparison, row); });
    if (std::ranges::any_of(rows, [](const Row& row) { return row.base.has_value(); }))
        table.note = base_title +
                     ": the smallest base radius at which the motion satisfies every limit, the cam's other "
                     "dimensions unchanged; none: no radius tried satisfies them.";
    for (const Row& row : rows) {
        // A law that does not satisfy the limits, or has an infinite peak that weighs, is nothing to measure
        // by: its scene is the one it was tried on.
        const bool measures = !row.is_optimum() && row.feasible && std::isfinite(row.objective);
        RowMotion motion{row.title, row.is_optimum() ? "good" : row.feasible ? "" : "bad"};
        motion.number = static_cast<int>(table.motions.size());
        motion.settings.emplace();
        if (measures) motion.settings->push_back(fmt::format("objective.reference=\"{}\"", row.key));
        table.motions.push_back(std::move(motion));
    }
    table.axes = {"peaks.acceleration.value", "peaks.velocity.value"};
    add_overlays(table, comparison);
    return table;
}

/// The same numbers for programs, a value a limit, in the unit of its key.
Table csv_table(const Comparison& comparison) {
    const std::vector<Row>& rows = comparison.rows;
    Table table{.key = "comparison", .file = "comparison.csv"};
    const auto add = [&](Field field, const auto& cell_of) {
        table.add_column(std::move(field), rows, cell_of);
    };
    add({"law"}, [](const Row& row) { return row.key; });
    add({"title"}, [](const Row& row) { return row.title; });
    add({"fits"}, [](const Row& row) { return row.misfit.empty() ? 1.0 : 0.0; });
    add({"feasible"}, [](const Row& row) { return row.feasible ? 1.0 : 0.0; });
    add({"objective"}, [](const Row& row) { return number_of(row, row.objective); });
    add({"loss", {}, loss_unit}, [](const Row& row) { return row.loss_percent; });
    for (const CostTerm& term : cost_terms())
        add({term.name()}, [&](const Row& row) { return number_of(row, term.measured.of(row.peaks)); });
    const Scene& scene = comparison.optimum.scene;
    for (const MotorColumn& column : motor_columns(scene, file_units(scene)))
        add({column.key, {}, column.unit}, column.value);
    const auto judged = std::ranges::find_if(rows, [](const Row& row) { return row.misfit.empty(); });
    for (std::size_t i = 0; judged != rows.end() && i < judged->limits.size(); ++i)
        add({judged->limits[i].reached.key}, [i](const Row& row) -> std::optional<double> {
            if (!row.misfit.empty() || row.limits[i].reached.no_contact) return {};
            return row.limits[i].reached.worst;
        });
    add({"base_radius_needed", {}, millimetres_shown},
        [](const Row& row) { return row.base ? row.base->radius : std::nullopt; });
    add({"broken"}, [](const Row& row) { return fmt::format("{}", fmt::join(broken_limits(row), "; ")); });
    add({"note"}, [](const Row& row) {
        return row.base && !row.base->radius ? "no base radius tried suffices: " + row.base->broken
                                             : row.misfit;
    });
    return table;
}

// A bar ends here at the latest, in units of the least finite objective: one bad law must not flatten the
// rest.
constexpr double longest_bar = 3.0;
constexpr std::size_t most_letters = 52;  // of a remark
constexpr double law_row_height = 24;     // px

std::string shortened(const std::string& words) {
    if (words.size() <= most_letters) return words;
    std::size_t end = words.rfind(' ', most_letters - 1);
    if (end == std::string::npos) end = most_letters - 1;
    return words.substr(0, end) + " …";
}

std::string remark_of(const Row& row) {
    if (!row.misfit.empty()) return "left out: " + row.misfit;
    const std::vector<std::string> broken = broken_limits(row);
    if (broken.empty()) return {};
    const std::string more = broken.size() > 1 ? fmt::format("; {} more", broken.size() - 1) : "";
    return shortened(broken.front()) + more;
}

/// One bar a row that has a finite objective.
ChartPanel bar_panel(const Comparison& comparison) {
    const bool limits =
        std::ranges::any_of(comparison.rows, [](const Row& row) { return !row.limits.empty(); });
    ChartSeries optimum{Look::bar, "optimum-bar", {}, 0.0, "optimum"},
        laws{Look::bar, "law-bar", {}, 0.0, limits ? "law, satisfies every limit" : "law"},
        broken{Look::bar, "broken-bar", {}, 0.0, limits ? "law, violates a limit (the worst is named)" : ""};
    ChartSeries line{Look::line, "optimum-line"};
    ChartSeries words{Look::label, "", {}, 0.0, "", "remark", LabelSide::beside};
    ChartPanel panel{.place = ChartPanel::Place::right, .width = 330, .row_height = law_row_height};
    panel.frame.horizontal_title = "objective";
    double least = infinity, most = 0.0, last = 0.0;
    for (const Row& row : comparison.rows) {
        const double y = -0.5 - panel.rows++;
        if (!row.misfit.empty() || !std::isfinite(row.objective)) {
            if (row.misfit.empty()) words.points.push_back({0.0, y, "", "∞"});
            continue;
        }
        (!row.feasible ? broken : row.is_optimum() ? optimum : laws).points.push_back({row.objective, y});
        if (row.is_optimum()) line.points.push_back({row.objective, y + 0.5});
        least = std::min(least, row.objective);
        most = std::max(most, row.objective);
        last = y - 0.5;
    }
    if (!line.points.empty()) line.points.push_back({line.points.front().x, last});
    if (!(most > 0.0)) most = 1.0;
    panel.frame.horizontal = {0.0, 1.04 * (least > 0.0 ? std::min(most, longest_bar * least) : most)};
    panel.series = {std::move(optimum), std::move(laws), std::move(broken), std::move(line),
                    std::move(words)};
    return panel;
}

/// Bars between the names and the other columns of the table; what is broken right of them.
Chart bar_chart(const Comparison& comparison, const Table& laws, const std::string& title) {
    std::array<ChartPanel, 2> tables;
    const auto cell = [&](std::size_t row, std::string words) {
        const Row& law = comparison.rows[row];
        return ChartCell{std::move(words), law.is_optimum() ? "value best"
                                           : law.feasible   ? "value"
                                                            : "value faint"};
    };
    const TextTable shown = text_table(laws);
    for (std::size_t i = 0; i < shown.columns.size(); ++i) {
        if (shown.columns[i].left && i > 0) continue;
        ChartColumn& column = tables[i > 0 ? 1 : 0].columns.emplace_back();
        if (i > 0) column.head = shown.columns[i].title;
        for (std::size_t row = 0; row < shown.rows.size(); ++row)
            column.cells.push_back(
                cell(row, i > 0 && !comparison.rows[row].misfit.empty() ? "" : shown.rows[row][i]));
    }
    ChartColumn remarks{"", TextSide::start};
    for (const Row& row : comparison.rows) remarks.cells.push_back({remark_of(row), "remark"});
    tables[1].columns.push_back(std::move(remarks));
    tables[1].place = ChartPanel::Place::right;
    for (ChartPanel& table : tables) table.row_height = law_row_height;
    return {title,
            {verdict_sentence(comparison.optimum), best_sentence(comparison) + ".",
             "Objective = " + objective_words(comparison.optimum)},
            {std::move(tables[0]), bar_panel(comparison), std::move(tables[1])}};
}

}  // namespace

Document comparison_document(const Comparison& comparison, const RunOrigin& origin) {
    const Solution& solution = comparison.optimum;
    Document document{solution.scene.title.empty() ? "Comparison of laws" : solution.scene.title,
                      tone_of(solution.certificate.verdict)};
    document.kind = "Comparison";
    Section& section = document.sections.emplace_back();
    section.sentences = sentences_of(comparison);
    section.figures = figures_of(comparison, origin);
    section.tables = {law_table(comparison), csv_table(comparison)};
    section.pictures = {{"comparison", "Objective, peaks and violated limits of every law",
                         bar_chart(comparison, section.tables.front(), document.title), Where::texts}};
    return document;
}

}  // namespace camopt

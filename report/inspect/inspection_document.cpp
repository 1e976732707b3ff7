// SPDX-License-Identifier: MIT
#include "report/inspect/inspection_document.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

struct Units {
    ShownUnit deviation, follower, given;
    std::array<ShownUnit, 2> derivatives;  ///< of the follower's error

    explicit Units(const Inspection& found) {
        follower = found.is_angle ? unit_named<"mdeg"> : unit_named<"um">;
        deviation = found.points ? unit_named<"um"> : follower;
        given = found.is_angle && !found.points ? unit_named<"deg"> : unit_named<"mm">;
        if (found.is_angle)
            derivatives = {unit_named<"mdeg/deg">, unit_named<"mdeg/deg^2">};
        else
            derivatives = {unit_named<"um/deg">, unit_named<"um/deg^2">};
    }
};

constexpr int table_digits = 5, sentence_digits = 4;

constexpr std::array derivative_names = {"slope", "acceleration"};

/// ± of the tolerance.
const ShownUnit& judged_unit(const Inspection& found, const Units& units) {
    return found.of_follower ? units.follower : units.deviation;
}

/// Those rows of the table that `chosen` takes.
Table row_table(const Units& units, const std::vector<InspectedRow>& rows,
                const std::function<bool(const InspectedRow&)>& chosen) {
    Table table{{},
                {},
                {{"line"},
                 {"theta", {}, degrees_shown},
                 {"measured", {}, units.given},
                 {"nominal", {}, units.given},
                 {"raw", {}, units.deviation},
                 {"aligned", {}, units.deviation},
                 {"neighbours", {}, units.deviation},
                 {"follower", {}, units.follower}}};
    for (const InspectedRow& row : rows)
        if (chosen(row)) {
            table.rows.push_back({Cell(row.line)});
            for (const double value :
                 {row.angle, row.measured, row.nominal, row.raw, row.aligned, row.around, row.follower})
                table.rows.back().emplace_back(value, table_digits);
        }
    return table;
}

Table named(Table table, std::string key, std::string title, std::string file = {}) {
    table.key = std::move(key);
    table.title = std::move(title);
    table.file = std::move(file);
    return table;
}

Table alignment_table(const Inspection& found, const ShownUnit& unit) {
    Table table{"alignment",
                "Alignment",
                {{.key = "alignment", .left = true}, {"value"}, {"standard_error"}},
                {},
                found.points ? "Angle offset: how far the cam is turned on the table, counter-clockwise."
                             : "Angle offset: the angle of the table at angle 0 of the nominal cam."};
    const std::array<Field, 4> parameters = {{{"radial_offset", {}, unit},
                                              {"angle_offset", {}, degrees_shown},
                                              {"eccentricity_x", {}, unit},
                                              {"eccentricity_y", {}, unit}}};
    for (int k = 0; k < found.fitted; ++k) {
        const Field& field = parameters[k];
        table.rows.push_back({Cell(field.shown_title()),
                              Cell(field.unit.of(found.alignment[k]), table_digits),
                              Cell(field.unit.of(found.error[k]), table_digits)});
        table.rows.back().front().key = field.file_key();
    }
    return table;
}

Table deviation_table(const Inspection& found, const ShownUnit& unit) {
    Table table{"deviations",
                "Deviations, measured − nominal",
                {{.key = "deviations", .left = true},
                 {"rows"},
                 {"largest", {}, unit},
                 {"largest_at", {}, degrees_shown},
                 {"least", {}, unit},
                 {"least_at", {}, degrees_shown},
                 {"peak_to_valley", {}, unit},
                 {"rms", {}, unit}}};
    for (const auto& [name, figures] : {std::pair("before alignment", &found.raw),
                                        {"aligned", &found.all},
                                        {"base circle", &found.base},
                                        {"lobe", &found.lobe}}) {
        if (figures->rows == 0) continue;
        table.rows.push_back({Cell(name), Cell(figures->rows)});
        for (const double value : {figures->most, figures->most_at, figures->least, figures->least_at,
                                   figures->most - figures->least, figures->rms})
            table.rows.back().emplace_back(value, table_digits);
    }
    return table;
}

Table outside_table(std::string key, std::string title, const std::vector<std::array<double, 3>>& out,
                    const ShownUnit& unit) {
    Table table{std::move(key),
                std::move(title),
                {{"from", {}, degrees_shown}, {"to", {}, degrees_shown}, {"worst", {}, unit}}};
    for (const auto& [from, to, worst] : out)
        table.rows.push_back({{from, table_digits}, {to, table_digits}, {worst, table_digits}});
    return table;
}

std::vector<Table> outside_tables(const Inspection& found, const Units& units) {
    std::vector<Table> all = {
        outside_table("out_of_tolerance", "Out of tolerance", found.out, judged_unit(found, units))};
    for (const ErrorDerivative& one : found.derivatives) {
        const auto k = static_cast<std::size_t>(one.order - 1);
        all.push_back(
            outside_table(fmt::format("{}_out_of_tolerance", derivative_names[k]),
                          fmt::format("Out of tolerance: {} of the follower's error", derivative_names[k]),
                          one.out, units.derivatives[k]));
    }
    return all;
}

/// Every row, with the derivatives of the follower's error that have a tolerance.
Table all_rows(const Inspection& found, const Units& units) {
    Table table = row_table(units, found.rows, [](const InspectedRow&) { return true; });
    for (const ErrorDerivative& one : found.derivatives) {
        const auto k = static_cast<std::size_t>(one.order - 1);
        table.columns.push_back({derivative_names[k], {}, units.derivatives[k]});
        for (std::size_t i = 0; i < found.rows.size(); ++i)
            table.rows[i].push_back(std::isnan(one.values[i]) ? Cell() : Cell(one.values[i], table_digits));
    }
    return named(std::move(table), "rows", {}, "inspection.csv");
}

void add_derivative_sentences(Section& section, const Inspection& found, const Units& units) {
    for (const ErrorDerivative& one : found.derivatives) {
        const auto k = static_cast<std::size_t>(one.order - 1);
        const ShownUnit& unit = units.derivatives[k];
        section.sentences.push_back(
            {Kind::verdict, derivative_names[k],
             fmt::format("{} of the follower's error: {} ± {}; largest {} at {} (standard error {}).",
                         k == 0 ? "Slope" : "Second derivative",
                         one.out.empty() ? "in tolerance," : "OUT OF TOLERANCE,",
                         unit.text(one.tolerance, sentence_digits), unit.text(one.worst, sentence_digits),
                         degrees_shown.text(one.worst_at, sentence_digits), unit.text(one.worst_error, 2))});
        section.figures.push_back(
            {{fmt::format("{}_tolerance", derivative_names[k]), {}, unit}, Cell(one.tolerance)});
        section.figures.push_back(
            {{fmt::format("{}_worst", derivative_names[k]), {}, unit}, Cell(one.worst)});
    }
}

Curves deviation_curves(const Inspection& found, const ShownUnit& unit) {
    Curves curves;
    curves.key = "inspection";
    curves.caption = "Deviation over the cam angle";
    curves.angle_title = "cam angle";
    curves.line_title = "aligned";
    curves.table = false;  // inspection.csv has the rows
    Curve curve{"deviation", "cam", "Deviation, measured − nominal", "d", unit};
    curve.reference = ComparedCurve{"before alignment", {}};
    bool on_base = false;
    for (const InspectedRow& row : found.rows) {
        curves.angles.push_back(degrees_shown.of(row.angle));
        curve.values.push_back(unit.of(row.aligned));
        curve.reference->values.push_back(unit.of(row.raw));
        if (row.base && !on_base) curves.segments.push_back({curves.angles.back(), 0.0, "base circle"});
        if (row.base) curves.segments.back().to = curves.angles.back();
        on_base = row.base;
    }
    for (const int side : {-1, 1})
        if (found.tolerance && (!found.of_follower || !found.points))
            curve.limits.push_back({curves.angles.front(), curves.angles.back(),
                                    side * unit.of(*found.tolerance), side, "tolerance"});
    curves.curves = {std::move(curve)};
    return curves;
}

}  // namespace

Document inspection_document(const Inspection& found, const std::string& title) {
    const Units units(found);
    const ShownUnit& unit = units.deviation;
    const bool in_tolerance = found.in_tolerance();
    Document document{title, in_tolerance ? "good" : "bad"};
    Section& section = document.sections.emplace_back();
    section.sentences = {
        {Kind::headline, "deviations",
         fmt::format("Deviations after alignment: {} to {}, rms {}",
                     unit.text(found.all.least, sentence_digits), unit.text(found.all.most, sentence_digits),
                     unit.text(found.all.rms, sentence_digits))}};
    if (found.tolerance)
        section.sentences.push_back(
            {Kind::verdict, "tolerance",
             fmt::format("{} ± {}{}.", found.out.empty() ? "In tolerance:" : "OUT OF TOLERANCE:",
                         judged_unit(found, units).text(*found.tolerance, sentence_digits),
                         found.of_follower && found.points ? " of the follower's displacement" : "")});
    section.figures = {
        {{"points"}, flag(found.points)},
        {{"tolerance", {}, judged_unit(found, units)}, Cell(found.tolerance)},
        {{"in_tolerance"},
         flag(found.tolerance || !found.derivatives.empty() ? std::optional(in_tolerance) : std::nullopt)},
        {{"noise", {}, unit}, Cell(found.noise)}};
    add_derivative_sentences(section, found, units);
    section.curves = deviation_curves(found, unit);
    const auto all = [](const InspectedRow&) { return true; };
    section.tables = {alignment_table(found, unit), deviation_table(found, unit),
                      named(row_table(units, found.worst, all), "worst", "Worst locations"),
                      named(row_table(units, found.rows, [](const InspectedRow& row) { return row.outlier; }),
                            "outliers", "Outliers"),
                      all_rows(found, units)};
    std::vector<Table> outside = outside_tables(found, units);
    section.tables.insert(section.tables.begin() + 3, std::move_iterator(outside.begin()),
                          std::move_iterator(outside.end()));
    return document;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "report/inspect/inspection_document.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

struct Units {
    ShownUnit deviation, follower, given;

    explicit Units(const Inspection& found) {
        follower = found.is_angle ? unit_named<"mdeg"> : unit_named<"um">;
        deviation = found.points ? unit_named<"um"> : follower;
        given = found.is_angle && !found.points ? unit_named<"deg"> : unit_named<"mm">;
    }
};

constexpr int table_digits = 5, sentence_digits = 4;

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

Table outside_table(const Inspection& found, const ShownUnit& unit) {
    Table table{"out_of_tolerance",
                "Out of tolerance",
                {{"from", {}, degrees_shown}, {"to", {}, degrees_shown}, {"worst", {}, unit}}};
    for (const auto& [from, to, worst] : found.out)
        table.rows.push_back({{from, table_digits}, {to, table_digits}, {worst, table_digits}});
    return table;
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
        if (found.tolerance)
            curve.limits.push_back({curves.angles.front(), curves.angles.back(),
                                    side * unit.of(*found.tolerance), side, "tolerance"});
    curves.curves = {std::move(curve)};
    return curves;
}

}  // namespace

Document inspection_document(const Inspection& found, const std::string& title) {
    const Units units(found);
    const ShownUnit& unit = units.deviation;
    const bool in_tolerance = found.out.empty();
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
             fmt::format("{} ± {}.", in_tolerance ? "In tolerance:" : "OUT OF TOLERANCE:",
                         unit.text(*found.tolerance, sentence_digits))});
    section.figures = {{{"points"}, flag(found.points)},
                       {{"tolerance", {}, unit}, Cell(found.tolerance)},
                       {{"in_tolerance"}, flag(found.tolerance ? std::optional(in_tolerance) : std::nullopt)},
                       {{"noise", {}, unit}, Cell(found.noise)}};
    section.curves = deviation_curves(found, unit);
    const auto all = [](const InspectedRow&) { return true; };
    section.tables = {alignment_table(found, unit),
                      deviation_table(found, unit),
                      named(row_table(units, found.worst, all), "worst", "Worst locations"),
                      outside_table(found, unit),
                      named(row_table(units, found.rows, [](const InspectedRow& row) { return row.outlier; }),
                            "outliers", "Outliers"),
                      named(row_table(units, found.rows, all), "rows", {}, "inspection.csv")};
    return document;
}

}  // namespace camopt

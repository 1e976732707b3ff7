// SPDX-License-Identifier: MIT
#include "output/inspect/inspection_output.hpp"

#include "core/version.hpp"
#include "output/chart/chart.hpp"
#include "output/csv/csv_line.hpp"
#include "output/json/json_text.hpp"
#include "output/page/page_html.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// A unit with the end of keys that names it.
struct KeyUnit : ShownUnit {
    std::string_view key;

    KeyUnit() = default;
    explicit(false) KeyUnit(const Spelling& unit) : ShownUnit(unit), key(unit.suffix) {}
    [[nodiscard]] std::string named(const char* what) const { return fmt::format("{}{}", what, key); }
};

struct Units {
    KeyUnit deviation, follower, given;

    explicit Units(const Inspection& found) {
        follower = found.is_angle ? unit_named<"mdeg"> : unit_named<"um">;
        deviation = found.points ? unit_named<"um"> : follower;
        given = found.is_angle && !found.points ? unit_named<"deg"> : unit_named<"mm">;
    }
};

Json row_json(const InspectedRow& row, const Units& units) {
    return {{"line", row.line},
            {"theta_deg", degrees_shown.of(row.angle)},
            {units.given.named("measured"), units.given.of(row.measured)},
            {units.given.named("nominal"), units.given.of(row.nominal)},
            {units.deviation.named("raw"), units.deviation.of(row.raw)},
            {units.deviation.named("aligned"), units.deviation.of(row.aligned)},
            {units.deviation.named("neighbours"), units.deviation.of(row.around)},
            {units.follower.named("follower"), units.follower.of(row.follower)}};
}

Json figures_json(const char* of, const DeviationFigures& figures, const KeyUnit& unit) {
    if (figures.rows == 0) return {};
    return {{"deviations", of},
            {"rows", figures.rows},
            {unit.named("largest"), unit.of(figures.most)},
            {"largest_at_deg", degrees_shown.of(figures.most_at)},
            {unit.named("least"), unit.of(figures.least)},
            {"least_at_deg", degrees_shown.of(figures.least_at)},
            {unit.named("peak_to_valley"), unit.of(figures.most - figures.least)},
            {unit.named("rms"), unit.of(figures.rms)}};
}

Json inspection_json(const Inspection& found, const std::string& title) {
    const Units units(found);
    const KeyUnit& unit = units.deviation;
    Json json = {{"camopt", version()}, {"title", title}, {"points", found.points}};
    json[unit.named("tolerance")] = found.tolerance ? Json(unit.of(*found.tolerance)) : Json();
    json["in_tolerance"] = found.tolerance ? Json(found.out.empty()) : Json();
    json[unit.named("noise")] = unit.of(found.noise);
    const std::array<std::pair<std::string, ShownUnit>, 4> parameters = {
        {{unit.named("radial_offset"), unit},
         {"angle_offset_deg", degrees_shown},
         {unit.named("eccentricity_x"), unit},
         {unit.named("eccentricity_y"), unit}}};
    for (int k = 0; k < found.fitted; ++k) {
        const auto& [name, shown] = parameters[k];
        json["alignment"].push_back({{"alignment", name},
                                     {"value", shown.of(found.alignment[k])},
                                     {"standard_error", shown.of(found.error[k])}});
    }
    for (const Json& one :
         {figures_json("before alignment", found.raw, unit), figures_json("aligned", found.all, unit),
          figures_json("base circle", found.base, unit), figures_json("lobe", found.lobe, unit)})
        if (!one.is_null()) json["deviations"].push_back(one);
    for (const InspectedRow& row : found.worst) json["worst"].push_back(row_json(row, units));
    json["outliers"] = json["out_of_tolerance"] = Json::array();
    for (const InspectedRow& row : found.rows)
        if (row.outlier) json["outliers"].push_back(row_json(row, units));
    for (const auto& [from, to, worst] : found.out)
        json["out_of_tolerance"].push_back({{"from_deg", degrees_shown.of(from)},
                                            {"to_deg", degrees_shown.of(to)},
                                            {unit.named("worst"), unit.of(worst)}});
    return json;
}

std::string shown_words(const std::string& key) {
    const std::string words = words_of(key);
    return words.ends_with(" um") ? words.substr(0, words.size() - 2) + "µm" : words;
}

/// A list of objects with the same keys.
TextTable table_of(const Json& list) {
    TextTable table;
    for (const auto& [key, value] : list.front().items())
        table.columns.push_back({shown_words(key), value.is_string()});
    for (const Json& one : list) {
        std::vector<std::string>& cells = table.rows.emplace_back();
        for (const Json& value : one)
            cells.push_back(value.is_string() ? shown_words(value.get<std::string>())
                                              : short_text(value.get<double>(), 5));
    }
    return table;
}

CurvePage page_of(const Inspection& found, const Json& json) {
    const Units units(found);
    const ShownUnit& unit = units.deviation;
    CurvePage page;
    page.title = json["title"];
    page.tone = found.out.empty() ? "good" : "bad";
    page.headline = fmt::format("Deviations after alignment: {} to {}, rms {}", unit.text(found.all.least, 4),
                                unit.text(found.all.most, 4), unit.text(found.all.rms, 4));
    if (found.tolerance)
        page.sentences = {fmt::format("{} ± {}.", found.out.empty() ? "In tolerance:" : "OUT OF TOLERANCE:",
                                      unit.text(*found.tolerance, 4))};
    for (const auto& [key, title] :
         {std::pair("alignment", "Alignment"), std::pair("deviations", "Deviations, measured − nominal"),
          std::pair("worst", "Worst locations"), std::pair("out_of_tolerance", "Out of tolerance"),
          std::pair("outliers", "Outliers")})
        if (!json[key].empty()) page.tables.push_back({key, title, table_of(json[key])});
    page.tables.front().note =
        found.points ? "Angle offset: how far the cam is turned on the table, counter-clockwise."
                     : "Angle offset: the angle of the table at angle 0 of the nominal cam.";
    Curve curve{"deviation", "cam", "Deviation, measured − nominal", "d", unit};
    curve.reference = ComparedCurve{"before alignment", {}};
    for (const InspectedRow& row : found.rows) {
        page.angles.push_back(degrees_shown.of(row.angle));
        curve.values.push_back(unit.of(row.aligned));
        curve.reference->values.push_back(unit.of(row.raw));
    }
    for (const int side : {-1, 1})
        if (found.tolerance)
            curve.limits.push_back({page.angles.front(), page.angles.back(), side * unit.of(*found.tolerance),
                                    side, "tolerance"});
    page.curves = {std::move(curve)};
    return page;
}

std::string deviation_svg(const CurvePage& page, const Inspection& found) {
    const Curve& curve = page.curves.front();
    ChartPanel panel{.width = 812, .height = 320, .caption = curve.title};  // px
    panel.frame.horizontal_title = "cam angle (deg)";
    panel.frame.vertical_title = curve.unit.name;
    panel.frame.horizontal = {page.angles.front(), page.angles.back()};
    for (const double tick : degree_ticks(page.angles.front(), page.angles.back(), 13))
        panel.frame.horizontal_ticks.push_back({tick, tick_text(tick, 1.0)});
    const auto add = [&](const char* css, const char* title,
                         const std::function<double(std::size_t)>& value) {
        ChartSeries& line = panel.series.emplace_back(ChartSeries{Look::line, css, {}, 4.0, title});
        for (std::size_t i = 0; i < page.angles.size(); ++i)
            line.points.push_back({page.angles[i], value(i)});
    };
    add("breakpoint", "", [](std::size_t) { return 0.0; });
    add("set-region", "base circle", [&](std::size_t i) { return found.rows[i].base ? 0.0 : std::nan(""); });
    add("reference", "before alignment", [&](std::size_t i) { return curve.reference->values[i]; });
    add("optimum", "aligned", [&](std::size_t i) { return curve.values[i]; });
    for (const CurveLimit& limit : curve.limits)
        add("limit", "tolerance", [&](std::size_t) { return limit.at; });
    return chart_svg({.title = page.title, .lines = {page.headline}, .panels = {panel}});
}

std::string rows_csv(const Inspection& found) {
    std::string text;
    for (const InspectedRow& row : found.rows) {
        CsvLine header, line;
        const Json cells = row_json(row, Units(found));
        for (const auto& [key, value] : cells.items()) {
            header.words(key);
            line.number(value.get<double>());
        }
        text += (text.empty() ? header.finish() : "") + line.finish();
    }
    return text;
}

}  // namespace

InspectionOutput inspection_output(const Inspection& found, const std::string& title,
                                   const RunOrigin& origin) {
    const Json json = inspection_json(found, title);
    const CurvePage page = page_of(found, json);
    InspectionOutput output{fmt::format("{}\n{}\n", page.title, page.headline), json_text(json), {}};
    for (const std::string& sentence : page.sentences) output.text += sentence + "\n";
    for (const ViewTable& table : page.tables)
        output.text += fmt::format("\n{}\n{}{}", table.title, aligned_text(table.table),
                                   table.note.empty() ? "" : table.note + "\n");
    output.files = {{"inspection.csv", rows_csv(found)},
                    {"inspection.svg", deviation_svg(page, found)},
                    {"inspection.html", curve_page_html(page, origin)},
                    {"inspection.json", output.json}};
    return output;
}

}  // namespace camopt

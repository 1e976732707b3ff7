// SPDX-License-Identifier: MIT
#include "core/version.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/page/page_html.hpp"
#include "report/page/page_parts.hpp"
#include "studies/delivered/solution_parts.hpp"

namespace camopt {

namespace {

Json numbers(const std::vector<double>& values) {
    Json all = Json::array();
    for (const double value : values) all.push_back(rounded_json(value));
    return all;
}

Json angle_part(const CurveSet& set) {
    if (set.angles.empty()) return nullptr;
    Json values = numbers(set.angles);
    return {{"unit", "deg"}, {"from", values.front()}, {"to", values.back()}, {"values", values}};
}

Json angle_part(const Curves& curves) {
    Json angle = angle_part(static_cast<const CurveSet&>(curves));
    if (!angle.is_null()) angle.update({{"title", curves.angle_title}, {"unit", curves.angle_unit.name}});
    return angle;
}

Json segments_part(const CurveSet& set) {
    Json all = Json::array();
    for (const ViewSegment& segment : set.segments)
        all.push_back({{"from", rounded_json(segment.from)},
                       {"to", rounded_json(segment.to)},
                       {"title", segment.title}});
    return all;
}

Json law_curves(const Motion& law, const View& view) {
    Json curves = Json::object();
    for (const ShownDerivative& shown : view.units.motion)
        curves[shown.name] = numbers(view.along(law, shown.first));
    return curves;
}

Json compared_json(const std::optional<ComparedCurve>& other) {
    if (!other) return nullptr;
    return {{"title", other->title}, {"values", numbers(other->values)}};
}

Json limits_json(const Curve& curve) {
    Json all = Json::array();
    for (const CurveLimit& limit : curve.limits)
        all.push_back({{"from", rounded_json(limit.from)},
                       {"to", rounded_json(limit.to)},
                       {"at", rounded_json(limit.at)},
                       {"outside", limit.outside},
                       {"words", limit.words}});
    return all;
}

Json marks_json(const Curve& curve) {
    Json all = Json::array();
    for (const CurveMark& mark : curve.marks) {
        all.push_back({{"at", rounded_json(mark.at)},
                       {"value", rounded_json(mark.value)},
                       {"words", mark.words},
                       {"given", mark.given}});
        if (mark.to) all.back()["to"] = rounded_json(*mark.to);
    }
    return all;
}

Json curves_part(const std::vector<Curve>& curves) {
    Json all = Json::array();
    for (const Curve& curve : curves) {
        Json beside = nullptr;
        if (curve.beside)
            beside = {{"unit", curve.beside->name},
                      {"symbol", curve.beside->symbol},
                      {"factor", rounded_json(curve.beside_factor)}};
        Json points = Json::array();
        for (const auto& [at, value] : curve.points)
            points.push_back({rounded_json(at), rounded_json(value)});
        all.push_back({{"key", curve.key},
                       {"group", curve.group},
                       {"title", curve.title},
                       {"symbol", curve.symbol},
                       {"unit", curve.unit.name},
                       {"beside", std::move(beside)},
                       {"values", numbers(curve.values)},
                       {"reference", compared_json(curve.reference)},
                       {"measured", compared_json(curve.measured)},
                       {"points", std::move(points)},
                       {"limits", limits_json(curve)},
                       {"marks", marks_json(curve)}});
        if (curve.band)
            all.back()["band"] = {{"low", numbers(curve.band->low)}, {"high", numbers(curve.band->high)}};
    }
    return all;
}

/// Within a page: without what stands before the element.
std::string page_picture(const Chart& chart) {
    const std::string svg = chart_svg(chart);
    return svg.substr(svg.find("<svg"));
}

Json table_json(const Table& table) {
    const TextTable shown = text_table(table, Where::page);
    Json columns = Json::array();
    for (const TextTable::Column& column : shown.columns)
        columns.push_back({{"title", column.title}, {"left", column.left}});
    Json json = {{"key", table.key},
                 {"title", table.title},
                 {"columns", std::move(columns)},
                 {"rows", shown.rows},
                 {"note", (table.note_where & Where::page) != 0 ? table.note : ""}};
    if (!shown.folders.empty()) json["folders"] = shown.folders;
    return json;
}

/// Beside the document of a solution.
struct Stage {
    Json motor = nullptr, drawing = nullptr, solid = nullptr;
};

std::string data_of(const Document& document, const RunOrigin& origin, const CurveSet& curves, Json angle,
                    Stage stage = {}) {
    using Kind = Sentence::Kind;
    constexpr unsigned page = Where::page;
    const std::vector<std::string> headlines = document.sentences({Kind::headline}, page);
    Json said = Json::array(), figures = Json::array(), tables = Json::array(), lists = Json::array(),
         pictures = Json::array(), reference = nullptr;
    for (const Section& section : document.sections) {
        if ((section.where & page) == 0) continue;
        Json sentences = section.said({Kind::verdict, Kind::warning, Kind::remark}, page);
        if (section.title.empty())
            for (Json& sentence : sentences) said.push_back(std::move(sentence));
        else if (!sentences.empty())
            (section.key == "reference" ? reference : lists.emplace_back()) = {
                {"title", section.title}, {"sentences", std::move(sentences)}};
        for (const Figure& figure : section.figures)
            if (!figure.field.title.empty() && (figure.field.where & page) != 0)
                figures.push_back({{"name", figure.field.title},
                                   {"value", shown_text(figure.cell, figure.field)},
                                   {"at", place_text(figure)}});
        for (const Table* table : section.shown_tables(page))
            tables.push_back(table->motions.empty() ? table_json(*table) : motions_json(*table, origin));
        for (const Picture& picture : section.pictures)
            if (picture.chart && (picture.where & page) != 0)
                pictures.push_back(page_picture(*picture.chart));
    }
    const Json data = {
        {"camopt", version()},
        {"kind", document.kind},
        {"title", document.title},
        {"foot", document.foot.empty() ? document.title : document.foot},
        {"verdict",
         {{"key", document.verdict},
          {"tone", document.tone},
          {"headline", headlines.empty() ? document.title : headlines.front()},
          {"sentences", std::move(said)}}},
        {"figures", std::move(figures)},
        {"reference", std::move(reference)},
        {"angle", std::move(angle)},
        {"curves", curves_part(curves.curves)},
        {"segments", segments_part(curves)},
        {"breakpoints", numbers(curves.breakpoints)},
        {"motor", std::move(stage.motor)},
        {"drawing", std::move(stage.drawing)},
        {"solid", std::move(stage.solid)},
        {"pictures", std::move(pictures)},
        {"tables", std::move(tables)},
        {"lists", std::move(lists)},
        {"notes", document.sentences({Kind::note}, page)},
        {"appendix", {{"sentences", document.sentences({Kind::effort}, page)}, {"command", origin.command}}},
        {"scene", {{"file", origin.scene_file}, {"text", origin.scene_text}}}};
    return data.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

Json rounded_json(double value, int digits) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0.0) return 0;
    const double power =
        std::pow(10.0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    const double rounded = std::isfinite(power) && power > 0.0 ? std::round(value * power) / power : value;
    return rounded;
}

std::string page_data_with(const SolidParts* solids, const View& view, const RunOrigin& origin,
                           SolutionWishes wishes) {
    const Solution& solution = view.solution;
    wishes.where = Where::page;
    Stage stage{.drawing = plane_drawing(view)};
    if (solution.drive) stage.motor = torque_over_speed_svg(view);
    if (solids != nullptr) stage.solid = Json::parse(solids->drawing(view));
    return data_of(solution_document(solution, origin, wishes), origin, view, angle_part(view),
                   std::move(stage));
}

std::string document_html(const Document& document, const RunOrigin& origin) {
    static const Curves none;
    const Curves& curves = document.curves() ? *document.curves() : none;
    return page_html({document.title, data_of(document, origin, curves, angle_part(curves))});
}

std::vector<FolderFile> document_files(const Document& document, const RunOrigin& origin,
                                       const DocumentNames& names) {
    std::vector<FolderFile> files = text_files(document, origin);
    files.push_back({names.page, document_html(document, origin)});
    if (!names.json.empty()) files.push_back({names.json, document_json(document)});
    return files;
}

std::string page_laws(const View& view, std::span<const std::string> keys) {
    const Solution& solution = view.solution;
    Json all = Json::array();
    if (solution.motion)
        for (const std::string& key : keys) {
            const LawMotion placed = law_in_place(solution, key);
            Json law = {{"key", key}, {"title", words_of(key)}, {"misfit", words_json(placed.misfit)}};
            law["curves"] = placed.motion ? law_curves(*placed.motion, view) : Json(nullptr);
            law["peaks"] = {{"velocity", rounded_json(placed.peaks.velocity.value)},
                            {"acceleration", rounded_json(placed.peaks.acceleration.value)},
                            {"jerk", rounded_json(placed.peaks.jerk.value)}};
            all.push_back(std::move(law));
        }
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace camopt

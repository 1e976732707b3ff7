// SPDX-License-Identifier: MIT
#include "core/version.hpp"
#include "output/chart/curve_chart.hpp"
#include "output/page/page_parts.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/words/solution_text.hpp"

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
    }
    return all;
}

/// Within a page: without what stands before the element.
std::string page_picture(const Chart& chart) {
    const std::string svg = chart_svg(chart);
    return svg.substr(svg.find("<svg"));
}

/// At the foot of printed pages: number, revision and date of the title block behind the title.
std::string foot_words(const View& view) {
    std::string text = view.title("Motion");
    for (const auto& [label, words] : title_block_words(view.solution.scene))
        if (label == "number" || label == "revision" || label == "date")
            text += " · " + (label == "number" ? words : label + " " + words);
    return text;
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
                           const PageDataOptions& options) {
    const Solution& solution = view.solution;
    Json page = Json::object();
    page["camopt"] = version();
    page["kind"] = "Report";
    page["title"] = view.title("Motion");
    page["foot"] = foot_words(view);
    page["verdict"] = options.proof ? verdict_part(solution) : open_verdict_part(solution);
    page["figures"] = figures_part(solution);
    page["reference"] = options.proof ? reference_part(solution, options.reference) : Json(nullptr);
    page["angle"] = angle_part(view);
    page["curves"] = curves_part(view.curves);
    page["segments"] = segments_part(view);
    page["breakpoints"] = numbers(view.breakpoints);
    page["motor"] = solution.drive ? Json(torque_over_speed_svg(view)) : Json(nullptr);
    page["drawing"] = plane_drawing(view);
    page["pictures"] = Json::array();
    page["solid"] = options.solid && solids != nullptr ? Json::parse(solids->drawing(view)) : Json(nullptr);
    page["tables"] = options.proof ? tables_part(solution) : Json::array();
    page["remarks"] = options.proof && solution.cam ? Json(cam_remarks(solution)) : Json::array();
    page["notes"] = solution.notes;
    page["appendix"] = options.proof ? appendix_part(solution, origin) : Json(nullptr);
    page["scene"] = {
        {"file", origin.scene_file}, {"text", origin.scene_text}, {"lines", scene_lines(solution.scene)}};
    return page.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string document_html(const Document& document, const RunOrigin& origin) {
    using Kind = Sentence::Kind;
    const std::vector<std::string> headlines = document.sentences({Kind::headline});
    static const Curves none;
    const Curves& curves = document.curves() ? *document.curves() : none;
    Json figures = Json::array(), tables = Json::array(), pictures = Json::array();
    for (const Section& section : document.sections)
        for (const Figure& figure : section.figures)
            if (!figure.field.title.empty())
                figures.push_back({{"name", figure.field.title},
                                   {"value", shown_text(figure.cell, figure.field)},
                                   {"at", place_text(figure)}});
    for (const Table* table : document.shown_tables(true))
        tables.push_back(table->motions.empty()
                             ? table_json(table->key, table->title, text_table(*table), table->note)
                             : motions_json(*table, origin));
    for (const Picture* picture : document.pictures())
        if (picture->on_page) pictures.push_back(page_picture(picture->chart));
    const Json data = {
        {"camopt", version()},
        {"kind", document.kind},
        {"title", document.title},
        {"foot", document.title},
        {"verdict",
         {{"key", ""},
          {"tone", document.tone},
          {"headline", headlines.empty() ? document.title : headlines.front()},
          {"sentences", document.sentences({Kind::verdict, Kind::warning, Kind::remark})}}},
        {"figures", figures},
        {"reference", nullptr},
        {"angle", angle_part(curves)},
        {"curves", curves_part(curves.curves)},
        {"segments", segments_part(curves)},
        {"breakpoints", numbers(curves.breakpoints)},
        {"drawing", nullptr},
        {"solid", nullptr},
        {"pictures", pictures},
        {"tables", tables},
        {"remarks", Json::array()},
        {"notes", document.sentences({Kind::note})},
        {"appendix", {{"sentences", document.sentences({Kind::effort})}, {"command", origin.command}}},
        {"scene", {{"file", origin.scene_file}, {"text", origin.scene_text}, {"lines", Json::array()}}}};
    PageHtml html;
    html.title = document.title;
    html.data = data.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    return page_html(html);
}

std::vector<FolderFile> document_files(const Document& document, const RunOrigin& origin,
                                       const DocumentNames& names) {
    std::vector<FolderFile> files = text_files(document, origin);
    files.push_back({names.page, document_html(document, origin)});
    files.push_back({names.json, document_json(document)});
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

// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"
#include "report/json/result_fields.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/number_text.hpp"

namespace camopt {

namespace {

/// Writes extremes of one solution in the units of files: the value, and where.
class Writer {
 public:
    explicit Writer(const Scene& scene) : units(file_units(scene)), swings_(scene.motion.lift_is_angle) {}

    [[nodiscard]] Json degrees(double x) const { return number_json(units.degrees_per_x * x); }
    /// A figure into its key.
    template <class Summary>
    void add(Json& json, const FigureRow<Summary>& row, const Summary& summary) const {
        const std::optional<CamExtreme> extreme = row.of(summary);
        Json& place = json[swings_ && row.key_of_moment != nullptr ? row.key_of_moment : row.key];
        place = nullptr;
        if (extreme)
            place = {{"value", number_json((units.*row.unit).of(extreme->value))},
                     {"at_deg", degrees(extreme->at)}};
    }

    const ShownUnits units;

 private:
    bool swings_;
};

Json forces_json(const Writer& writer, const std::optional<ForceSummary>& forces) {
    if (!forces) return nullptr;
    Json json = Json::object();
    for (const auto& row : force_figure_rows()) writer.add(json, row, *forces);
    return json;
}

Json smallest_json(const Writer& writer, const std::optional<SmallestCamReport>& smallest) {
    if (!smallest) return nullptr;
    return {{"prime_radius_mm", number_json(writer.units.length.of(smallest->prime_radius))},
            {"given_mm", number_json(writer.units.length.of(smallest->given))},
            {"pressure_angle_deg", number_json(writer.units.angle.of(smallest->pressure_angle))},
            {"stroke", smallest->rises ? "rise" : "return"},
            {"from_deg", writer.degrees(smallest->begin)},
            {"to_deg", writer.degrees(smallest->end)}};
}

/// In SI, bit for bit: millimetres may not read back as the same metres.
Json exact_dimensions_json(const CamSpec& spec, const std::vector<double>& numbers) {
    Json json = Json::object();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const CamDimension& dimension = spec.dimensions[i];
        json[dimension.si_key()] = number_json(numbers[i]);
    }
    return json;
}

/// Of a cam that drives both ways.
Json sides_json(const Writer& writer, const std::vector<SideSummary>& sides) {
    Json all = Json::array();
    for (const SideSummary& side : sides) {
        Json json = {{"name", side.name}};
        for (const auto& row : side_figure_rows()) writer.add(json, row, side);
        all.push_back(std::move(json));
    }
    return all;
}

CurveRecord curve_record(const SplineCurve& curve) {
    CurveRecord record{curve.degree(), curve.continuity(), curve.breakpoints(), {}};
    for (Eigen::Index i = 0; i < curve.pieces().cols(); ++i)
        record.pieces.emplace_back(curve.pieces().col(i));
    return record;
}

}  // namespace

Json motion_json(const MotionChain& motion) {
    std::vector<const Motion*> known;
    MotionRecord record;
    for (const ChainPart& part : motion.parts()) {
        PartRecord& one = record.parts.emplace_back(PartRecord{part, {}, {}});
        if (const auto* spline = dynamic_cast<const SplineCurve*>(part.shape.get())) {
            const auto first = std::ranges::find(known, spline);
            one.curve = static_cast<int>(first - known.begin());
            if (first != known.end()) continue;
            record.curves.push_back(curve_record(*spline));
            known.push_back(spline);
        } else if (const auto* law = dynamic_cast<const Law*>(part.shape.get())) {
            one.law = law_name(law->info());
        }
    }
    return written(record);
}

Json spline_json(const std::optional<SplineCurve>& curve) {
    if (!curve) return nullptr;
    return {{"degree", curve->degree()},
            {"continuity", curve->continuity()},
            {"breakpoints", numbers_json(curve->breakpoints())},
            {"knots", numbers_json(curve->knots())},
            {"coefficients", numbers_json(curve->coefficients())}};
}

Json peaks_json(const std::optional<Peaks>& peaks) {
    if (!peaks) return nullptr;
    Json json = Json::object();
    for (const PeakFigure& figure : peak_figures)
        json[std::string(figure.name)] = figure.extremum != nullptr ? extremum_json((*peaks).*figure.extremum)
                                                                    : number_json(figure.of(*peaks));
    return json;
}

Json segments_json(const Solution& solution) {
    if (solution.segments.empty()) return nullptr;
    const double degrees_per_x = file_units(solution.scene).degrees_per_x;
    Json list = Json::array();
    for (const SegmentReport& segment : solution.segments) {
        const bool open = segment.continuity < 0;
        list.push_back({{"kind", name_of(segment.kind)},
                        {"start_deg", number_json(degrees_per_x * segment.begin)},
                        {"angle_deg", number_json(degrees_per_x * (segment.end - segment.begin))},
                        {"from", number_json(segment.from)},
                        {"to", number_json(segment.to)},
                        {"continuity", open ? Json(nullptr) : Json(segment.continuity)},
                        {"peaks", peaks_json(segment.peaks)},
                        {"spline", spline_json(segment.curve)},
                        {"law", segment.law.empty() ? Json(nullptr) : Json(segment.law)}});
    }
    return list;
}

Json dimensions_json(const Solution& solution) {
    Json json = Json::object();
    for (const DimensionValue& dimension : cam_dimensions(solution))
        json[dimension.name + dimension.unit.suffix] = number_json(dimension.shown);
    return json;
}

Json cam_json(const Solution& solution) {
    if (!solution.cam) return nullptr;
    const CamReport& cam = *solution.cam;
    const CamSummary& summary = cam.summary;
    const CamSpec& spec = solution.scene.cam.value();
    const bool direct = cam.cam.formulas->direct() != nullptr;
    const Writer writer(solution.scene);
    Json json = Json::object();
    json["type"] = spec.type;
    for (const auto& [name, choice] : spec.choices) json[name] = choice;
    json["rotation"] = name_of(spec.rotation);
    for (const auto& row : cam_figure_rows()) {
        const bool has_it = row.of(summary).has_value() || !row.only_where_found;
        if (has_it && (direct || !row.of_direct_cams)) writer.add(json, row, summary);
    }
    json["undercut"] = summary.undercut();
    const bool loaded = direct || summary.forces;
    if (loaded)
        json["no_contact_at_deg"] = summary.no_contact ? writer.degrees(*summary.no_contact) : Json(nullptr);
    if (direct)
        json["smallest"] = smallest_json(writer, cam.smallest);
    else
        json["base_radius_mm"] = number_json(writer.units.length.of(summary.base_radius));
    if (loaded) json["forces"] = forces_json(writer, summary.forces);
    if (!summary.sides.empty()) json["sides"] = sides_json(writer, summary.sides);
    json["dimensions"] = exact_dimensions_json(spec, cam.cam.dimensions);
    Json& check = json["forward_check"];
    if (cam.forward_check) fields(JsonFields(check), to_write(*cam.forward_check), solution.scene);
    return json;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "output/json/solution_json.hpp"

#include "core/motion.hpp"
#include "core/units.hpp"
#include "motions/laws/law.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/segment_table.hpp"
#include "output/words/shown_units.hpp"
#include "splines/curve.hpp"

#include <algorithm>
#include <vector>

namespace camopt {

namespace {

Json curve_json(const SplineCurve& curve) {
    Json pieces = Json::array();
    for (Eigen::Index i = 0; i < curve.pieces().cols(); ++i)
        pieces.push_back(numbers_json(Eigen::VectorXd(curve.pieces().col(i))));
    return {{"degree", curve.degree()},
            {"continuity", curve.continuity()},
            {"breakpoints", numbers_json(curve.breakpoints())},
            {"pieces", std::move(pieces)}};
}

using units::degree, units::millimetre;

constexpr double megapascal = 1e6;

/// Writes extremes of one solution: the value in a unit, and where.
class Writer {
 public:
    explicit Writer(const Solution& solution) : degrees_per_x_(solution.scene.motion.unit_angle() / degree) {}

    [[nodiscard]] Json degrees(double x) const { return number_json(degrees_per_x_ * x); }
    [[nodiscard]] Json extreme(const CamExtreme& extreme, double unit) const {
        return {{"value", number_json(extreme.value / unit)}, {"at_deg", degrees(extreme.at)}};
    }
    [[nodiscard]] Json extreme(const std::optional<CamExtreme>& found, double unit) const {
        return found ? extreme(*found, unit) : Json(nullptr);
    }

 private:
    double degrees_per_x_;
};

Json forces_json(const Writer& writer, const CamReport& cam) {
    if (!cam.summary.forces) return nullptr;
    const ForceSummary& forces = *cam.summary.forces;
    const bool swings = cam.cam.formulas->swings();
    Json json = Json::object();
    json[swings ? "least_moment_nm" : "least_force_n"] = writer.extreme(forces.least_force, 1.0);
    json[swings ? "largest_moment_nm" : "largest_force_n"] = writer.extreme(forces.largest_force, 1.0);
    json["torque_nm"] = writer.extreme(forces.torque, 1.0);
    json["normal_force_n"] = writer.extreme(forces.normal_force, 1.0);
    json["hertz_pressure_mpa"] = writer.extreme(forces.hertz_pressure, megapascal);
    return json;
}

Json smallest_json(const Writer& writer, const std::optional<SmallestCamReport>& smallest) {
    if (!smallest) return nullptr;
    return {{"prime_radius_mm", number_json(smallest->prime_radius / millimetre)},
            {"given_mm", number_json(smallest->given / millimetre)},
            {"pressure_angle_deg", number_json(smallest->pressure_angle / degree)},
            {"stroke", smallest->rises ? "rise" : "return"},
            {"from_deg", writer.degrees(smallest->begin)},
            {"to_deg", writer.degrees(smallest->end)}};
}

/// In SI, bit for bit: millimetres may not read back as the same metres.
Json exact_dimensions_json(const CamSpec& spec, const std::vector<double>& numbers) {
    Json json = Json::object();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const CamDimension& dimension = spec.dimensions[i];
        json[dimension.name + (dimension.is_angle ? "_rad" : "_m")] = number_json(numbers[i]);
    }
    return json;
}

Json play_json(const Writer& writer, const ForwardCheckReport::Play& play, bool swings) {
    const double unit = swings ? degree : millimetre;
    Json json = {{swings ? "least_deg" : "least_mm", number_json(play.least / unit)},
                 {"least_at_deg", writer.degrees(play.least_at)},
                 {swings ? "largest_deg" : "largest_mm", number_json(play.largest / unit)},
                 {"largest_at_deg", writer.degrees(play.largest_at)}};
    if (play.least_groove_width)
        json["least_groove_width_mm"] = number_json(*play.least_groove_width / millimetre);
    return json;
}

/// Of a cam that drives both ways.
Json sides_json(const Writer& writer, const std::vector<SideSummary>& sides) {
    Json all = Json::array();
    for (const SideSummary& side : sides)
        all.push_back({{"name", side.name},
                       {"pressure_angle_deg", writer.extreme(side.pressure_angle, degree)},
                       {"convex_radius_mm", writer.extreme(side.convex_radius, millimetre)},
                       {"concave_radius_mm", writer.extreme(side.concave_radius, millimetre)},
                       {"regularity", writer.extreme(side.regularity, 1.0)},
                       {"normal_force_n", writer.extreme(side.normal_force, 1.0)},
                       {"hertz_pressure_mpa", writer.extreme(side.hertz_pressure, megapascal)}});
    return all;
}

Json forward_check_json(const Writer& writer, const Solution& solution) {
    const std::optional<ForwardCheckReport>& check = solution.cam->forward_check;
    if (!check) return nullptr;
    const bool swings = solution.scene.motion.lift_is_angle;
    Json json = {{swings ? "deviation_deg" : "deviation_mm",
                  number_json(check->deviation / (swings ? degree : millimetre))},
                 {"relative", number_json(check->relative)},
                 {"points", check->points},
                 {"seconds", number_json(check->seconds)},
                 {"at_deg", writer.degrees(check->at)}};
    if (check->play) json["play"] = play_json(writer, *check->play, swings);
    return json;
}

}  // namespace

Json motion_json(const MotionChain& motion) {
    std::vector<const Motion*> written;
    Json curves = Json::array(), parts = Json::array();
    for (const ChainPart& part : motion.parts()) {
        Json curve = nullptr, law = nullptr;
        if (const auto* spline = dynamic_cast<const SplineCurve*>(part.shape.get())) {
            const auto known = std::ranges::find(written, spline);
            curve = known - written.begin();
            if (known == written.end()) {
                curves.push_back(curve_json(*spline));
                written.push_back(spline);
            }
        } else if (const auto* shape = dynamic_cast<const Law*>(part.shape.get())) {
            law = shape->info().key;
        }
        parts.push_back({{"begin", number_json(part.begin)},
                         {"end", number_json(part.end)},
                         {"curve", std::move(curve)},
                         {"law", std::move(law)},
                         {"x0", number_json(part.x0)},
                         {"x_scale", number_json(part.x_scale)},
                         {"y0", number_json(part.y0)},
                         {"y_scale", number_json(part.y_scale)}});
    }
    return {{"curves", std::move(curves)}, {"parts", std::move(parts)}};
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
    const double degrees_per_x = display_scale(solution.scene.motion).degrees_per_x;
    Json list = Json::array();
    for (const SegmentReport& segment : solution.segments) {
        const bool open = segment.continuity < 0;
        list.push_back({{"kind", name_of(segment.kind)},
                        {"start_deg", number_json(degrees_per_x * segment.begin)},
                        {"angle_deg", number_json(degrees_per_x * (segment.end - segment.begin))},
                        {"from", number_json(segment.from)},
                        {"to", number_json(segment.to)},
                        {"continuity", open ? Json(nullptr) : Json(segment.continuity)},
                        {"peaks", peaks_json(segment_peaks(segment))},
                        {"spline", spline_json(segment.curve)},
                        {"law", segment.law.empty() ? Json(nullptr) : Json(segment.law)}});
    }
    return list;
}

Json dimensions_json(const Solution& solution) {
    Json json = Json::object();
    for (const DimensionValue& dimension : cam_dimensions(solution))
        json[dimension.name + (dimension.is_angle ? "_deg" : "_mm")] = number_json(dimension.shown);
    return json;
}

Json cam_json(const Solution& solution) {
    if (!solution.cam) return nullptr;
    const CamReport& cam = *solution.cam;
    const CamSummary& summary = cam.summary;
    const CamSpec& spec = solution.scene.cam.value();
    const bool direct = cam.cam.formulas->is_direct();
    const Writer writer(solution);
    Json json = Json::object();
    json["type"] = spec.type;
    for (const auto& [name, choice] : spec.choices) json[name] = choice;
    json["rotation"] = name_of(spec.rotation);
    json["pressure_angle_deg"] = writer.extreme(summary.pressure_angle, degree);
    if (direct) {
        json["rise_pressure_angle_deg"] = writer.extreme(summary.rise_pressure_angle, degree);
        json["return_pressure_angle_deg"] = writer.extreme(summary.return_pressure_angle, degree);
        json["rest_pressure_angle_deg"] = writer.extreme(summary.rest_pressure_angle, degree);
    }
    json["convex_radius_mm"] = writer.extreme(convex_radius(summary), millimetre);
    json["concave_radius_mm"] = writer.extreme(summary.concave_radius, millimetre);
    json["regularity"] = writer.extreme(summary.regularity, 1.0);
    json["undercut"] = summary.undercut();
    if (direct)
        json["no_contact_at_deg"] = summary.no_contact ? writer.degrees(*summary.no_contact) : Json(nullptr);
    if (summary.contact_offset)
        json["contact_offset_mm"] = writer.extreme(summary.contact_offset, millimetre);
    if (direct) {
        json["smallest"] = smallest_json(writer, cam.smallest);
        json["forces"] = forces_json(writer, cam);
    } else {
        json["base_radius_mm"] = number_json(summary.base_radius / millimetre);
    }
    if (!summary.sides.empty()) json["sides"] = sides_json(writer, summary.sides);
    json["dimensions"] = exact_dimensions_json(spec, cam.cam.dimensions);
    json["forward_check"] = forward_check_json(writer, solution);
    return json;
}

Json bound_json(const Certificate& certificate) {
    return {{"lower", number_json(certificate.lower_bound)},
            {"gap", number_json(certificate.gap)},
            {"proof", name_of(certificate.proof_kind)}};
}

void add_verdict(Json& json, const Certificate& certificate) {
    json["verdict"] = name_of(certificate.verdict);
    json["reason"] = words_json(name_of(certificate.reason));
    json["objective"] = number_json(certificate.objective);
    json["bound"] = bound_json(certificate);
}

}  // namespace camopt

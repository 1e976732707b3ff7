// SPDX-License-Identifier: MIT
#include "output/json/cam_json.hpp"

#include "core/units.hpp"
#include "output/json/mechanism_json.hpp"
#include "output/words/cam_words.hpp"
#include "profiles/disk/disk_kind.hpp"

#include <optional>

namespace camopt {

namespace {

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
    const bool swings = is_oscillating(cam.cam.follower);
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
Json exact_dimensions_json(const DiskCam& cam) {
    Json json = Json::object();
    for (int d = 0; d < dimension_count; ++d) {
        const auto index = static_cast<DimensionIndex>(d);
        if (has_dimension(cam.follower, index))
            json[std::string(name_of(index)) + "_m"] = number_json(cam[index]);
    }
    return json;
}

Json forward_check_json(const Writer& writer, const Solution& solution) {
    const std::optional<ForwardCheckReport>& check = solution.cam->forward_check;
    if (!check) return nullptr;
    const bool swings = solution.scene.motion.lift_is_angle;
    return {{swings ? "deviation_deg" : "deviation_mm",
             number_json(check->deviation / (swings ? degree : millimetre))},
            {"relative", number_json(check->relative)},
            {"points", check->points},
            {"seconds", number_json(check->seconds)},
            {"at_deg", writer.degrees(check->at)}};
}

}  // namespace

Json dimensions_json(const Solution& solution) {
    Json json = Json::object();
    if (solution.scene.mechanism) return mechanism_dimensions_json(solution);
    if (!solution.scene.cam) return json;
    for (const DimensionValue& dimension : cam_dimensions(solution))
        json[dimension.name + "_mm"] = number_json(dimension.millimetres);
    return json;
}

Json cam_json(const Solution& solution) {
    if (solution.mechanism) return mechanism_json(solution);
    if (!solution.cam) return nullptr;
    const CamReport& cam = *solution.cam;
    const CamSummary& summary = cam.summary;
    const Writer writer(solution);
    Json json = Json::object();
    json["type"] = disk_type;
    json["follower"] = name_of(cam.cam.follower);
    json["rotation"] = name_of(cam.cam.rotation);
    json["pressure_angle_deg"] = writer.extreme(summary.pressure_angle, degree);
    json["rise_pressure_angle_deg"] = writer.extreme(summary.rise_pressure_angle, degree);
    json["return_pressure_angle_deg"] = writer.extreme(summary.return_pressure_angle, degree);
    json["rest_pressure_angle_deg"] = writer.extreme(summary.rest_pressure_angle, degree);
    json["convex_radius_mm"] = writer.extreme(convex_radius(summary), millimetre);
    json["concave_radius_mm"] = writer.extreme(summary.concave_radius, millimetre);
    json["regularity"] = writer.extreme(summary.regularity, 1.0);
    json["undercut"] = summary.undercut();
    json["no_contact_at_deg"] = summary.no_contact ? writer.degrees(*summary.no_contact) : Json(nullptr);
    if (has_flat_face(cam.cam.follower))
        json["contact_offset_mm"] = writer.extreme(summary.contact_offset, millimetre);
    json["smallest"] = smallest_json(writer, cam.smallest);
    json["forces"] = forces_json(writer, cam);
    json["dimensions"] = exact_dimensions_json(cam.cam);
    json["forward_check"] = forward_check_json(writer, solution);
    return json;
}

}  // namespace camopt

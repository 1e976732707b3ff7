// SPDX-License-Identifier: MIT
#include "benchmarks/stability/table/scene_text.hpp"

#include "profiles/disk/disk_cam.hpp"
#include "scene/written_limits.hpp"

#include <fmt/format.h>

#include <span>
#include <string_view>

namespace camopt::stability {

namespace {

/// Lines "key = value" under a table's head.
class Lines {
 public:
    void table(std::string_view name) { text_ += fmt::format("[{}]\n", name); }
    void number(std::string_view key, double value) { text_ += fmt::format("{} = {}\n", key, value); }
    void number(std::string_view key, const std::optional<double>& value) {
        if (value) number(key, *value);
    }
    void weight(std::string_view key, double value) {
        if (value != 0.0) number(key, value);
    }
    void word(std::string_view key, std::string_view value) {
        text_ += fmt::format("{} = \"{}\"\n", key, value);
    }
    void raw(std::string_view key, std::string_view value) { text_ += fmt::format("{} = {}\n", key, value); }
    [[nodiscard]] const std::string& text() const { return text_; }

 private:
    std::string text_;
};

std::string point_text(const SetPoint& point) {
    std::string text = fmt::format("{{ at = {}", point.at);
    const auto add = [&](std::string_view key, const std::optional<double>& value) {
        if (value) text += fmt::format(", {} = {}", key, *value);
    };
    add("until", point.until);
    add("displacement", point.displacement);
    add("velocity", point.velocity);
    add("acceleration", point.acceleration);
    return text + " }";
}

std::string points_text(std::span<const SetPoint> points) {
    std::string text;
    for (const SetPoint& point : points) text += (text.empty() ? "" : ", ") + point_text(point);
    return "[" + text + "]";
}

std::string segment_text(const ProgramSegment& segment) {
    std::string text = fmt::format("{{ kind = \"{}\", angle_rad = {}", name_of(segment.kind), segment.angle);
    if (!segment.law.empty()) text += fmt::format(", law = \"{}\"", segment.law);
    if (segment.to) text += fmt::format(", to = {}", *segment.to);
    if (!segment.via.empty()) text += ", via = " + points_text(segment.via);
    return text + " }";
}

void write_motion(Lines& lines, const MotionSpec& motion) {
    lines.table("motion");
    lines.word("type", name_of(motion.type));
    lines.number(motion.lift_is_angle ? "lift_rad" : "lift_m", motion.lift);
    if (motion.type != MotionType::program) lines.number("rise_rad", motion.rise);
    lines.number("return_rad", motion.return_angle);
    lines.number("speed_rad_s", motion.speed);
    if (motion.symmetric) lines.raw("symmetric", "true");
    if (!motion.via.empty()) lines.raw("via", points_text(motion.via));
    if (motion.type != MotionType::program) return;
    if (!motion.closed) lines.raw("closed", "false");
    std::string segments;
    for (const ProgramSegment& segment : motion.segments) segments += segment_text(segment) + ",\n";
    lines.raw("segments", "[\n" + segments + "]");
}

void write_spline(Lines& lines, const SplineSpec& spline) {
    lines.table("spline");
    lines.raw("degree", fmt::format("{}", spline.degree));
    if (spline.breakpoints.empty())
        lines.raw("segments", fmt::format("{}", spline.segments));
    else
        lines.raw("breakpoints", fmt::format("[{}]", fmt::join(spline.breakpoints, ", ")));
    if (spline.continuity) lines.raw("continuity", fmt::format("{}", *spline.continuity));
    lines.word("end_jerk", name_of(spline.end_jerk));
    lines.word("design", name_of(spline.design));
}

void write_objective(Lines& lines, const ObjectiveSpec& objective) {
    lines.table("objective");
    lines.weight("velocity", objective.velocity);
    lines.weight("acceleration", objective.acceleration);
    lines.weight("jerk", objective.jerk);
    lines.weight("torque", objective.torque);
    lines.weight("rms_acceleration", objective.rms_acceleration);
    lines.weight("rms_jerk", objective.rms_jerk);
    for (std::size_t i = 0; i < objective.dimensions.size(); ++i)
        lines.weight(name_of(static_cast<DimensionIndex>(i)), objective.dimensions[i]);
    lines.word("tie_break", name_of(objective.tie_break));
    const Reference& reference = objective.reference;
    if (!reference.numeric) return lines.word("reference", reference.law);
    lines.table("objective.reference");
    lines.number("velocity", reference.velocity);
    lines.number("acceleration", reference.acceleration);
    lines.number("jerk", reference.jerk);
    lines.number("torque", reference.torque);
    lines.number("rms_acceleration", reference.rms_acceleration);
    lines.number("rms_jerk", reference.rms_jerk);
}

void write_cam(Lines& lines, const DiskSpec& cam) {
    lines.table("cam");
    lines.word("type", "disk");
    lines.word("follower", name_of(cam.follower));
    lines.word("rotation", name_of(cam.rotation));
    for (std::size_t i = 0; i < cam.dimensions.size(); ++i) {
        if (!follower_of(cam.follower).dimensions[i]) continue;
        const Dimension& size = cam.dimensions[i];
        const std::string key = fmt::format("{}_m", name_of(static_cast<DimensionIndex>(i)));
        if (size.is_variable())
            lines.raw(key, fmt::format("{{ min = {}, max = {} }}", size.low, size.high));
        else
            lines.number(key, size.low);
    }
    lines.number("face_half_width_m", cam.face_half_width);
}

void write_forces(Lines& lines, const ForceSpec& forces, bool swings) {
    lines.table("forces");
    lines.number(swings ? "inertia_kg_m2" : "mass_kg", forces.mass);
    lines.number(swings ? "spring_rate_nm_rad" : "spring_rate_n_m", forces.spring_rate);
    lines.number(swings ? "preload_nm" : "preload_n", forces.preload);
    lines.number("contact_width_m", forces.contact_width);
    lines.number("cam_modulus_pa", forces.cam_modulus);
    lines.number("follower_modulus_pa", forces.follower_modulus);
    lines.number("cam_poisson", forces.cam_poisson);
    lines.number("follower_poisson", forces.follower_poisson);
}

void write_limits(Lines& lines, const LimitSpec& limits) {
    constexpr std::string_view head = "limits.";
    lines.table("limits");
    for (const auto& limit : {limits.velocity, limits.acceleration, limits.jerk})
        if (limit) lines.number(limit->key.substr(head.size()), limit->given);
    for (const auto& limit : {limits.pressure_angle, limits.rise_pressure_angle, limits.return_pressure_angle,
                              limits.cam_radius_min, limits.concave_radius_min, limits.undercut_margin,
                              limits.contact_force_min, limits.torque_max, limits.hertz_pressure_max})
        if (limit) lines.number(limit->key.substr(head.size()), limit->given());
}

bool has_other_parts(const Scene& scene) {
    bool ranges = false;
    for (const ProgramSegment& segment : scene.motion.segments)
        ranges = ranges || segment.angle_range.has_value();
    return ranges || (scene.cam && scene.cam->type != disk_type) || scene.dynamics || scene.measured ||
           !scene.own_terms.empty() || !scene.own_limits.empty() || scene.spline.free_knots ||
           (scene.cam && scene.cam->formulas()->stations() > 1);
}

}  // namespace

std::optional<std::string> scene_text(const Scene& given) {
    if (has_other_parts(given)) return {};
    const Scene scene = with_written_limits(given);
    Lines lines;
    write_motion(lines, scene.motion);
    write_spline(lines, scene.spline);
    write_objective(lines, scene.objective);
    if (scene.cam) write_cam(lines, disk_of(*scene.cam));
    if (scene.cam && scene.forces) write_forces(lines, *scene.forces, scene.cam->formulas()->swings());
    write_limits(lines, scene.limits);
    lines.table("solver");
    lines.word("name", scene.solver.name);
    lines.number("tolerance", scene.solver.tolerance);
    lines.number("gap", scene.solver.gap);
    return lines.text();
}

}  // namespace camopt::stability

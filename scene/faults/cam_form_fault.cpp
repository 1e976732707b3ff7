// SPDX-License-Identifier: MIT
// The form of a disk cam: what a groove and a conjugate cam need, and whether the second roller of the latter
// has a place on its side of the cam wherever the dimensions lie. With p = base + roller radius, Δ the
// largest displacement given:
//   translating  s0 = √(p² − e²),       D − s0 − Δ > 0          (D between the rollers' axes)
//   oscillating  cos ψ0 = (a² + l² − p²)/(2 a l),  γ − ψ0 − Δ > 0, γ − ψ0 < π   (γ between the arms)
// and the second prime radius above the second roller's.
#include "core/numbers/range.hpp"
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace camopt {
namespace {

using enum DimensionIndex;

Fault form_number_fault(const FormSpec& form) {
    const auto fault = [](const std::optional<double>& value, const Range& range,
                          const char* member) -> Fault {
        if (!value || range.contains(*value)) return std::nullopt;
        return SceneFault{member, fmt::format("{}", *value), range.number_text()};
    };
    for (const auto& [value, member] : std::array<std::pair<std::optional<double>, const char*>, 3>{
             {{form.groove_wall, "cam.groove_wall"},
              {form.second_roller_radius, "cam.second_roller_radius"},
              {form.second_arm_length, "cam.second_arm_length"}}})
        if (Fault found = fault(value, ranges::positive, member)) return found;
    if (Fault found = fault(form.groove_clearance, ranges::not_negative, "cam.groove_clearance"))
        return found;
    return fault(form.second_offset, ranges::any, "cam.second_offset");
}

/// What belongs to another form or follower is given.
Fault foreign_number_fault(const CamSpec& cam) {
    const FormSpec& form = cam.form;
    const bool swings = is_oscillating(cam.follower);
    struct Row {
        bool given, fits;
        const char *member, *allowed;
    };
    const bool slides_conjugate = form.is_conjugate() && !swings,
               swings_conjugate = form.is_conjugate() && swings;
    constexpr const char* groove = "only with cam.form = \"grooved\"";
    constexpr const char* conjugate = "only with cam.form = \"conjugate\"";
    constexpr const char* sliding = "only with cam.form = \"conjugate\" and a translating roller";
    constexpr const char* swinging = "only with cam.form = \"conjugate\" and an oscillating roller";
    const std::array<Row, 7> rows = {{
        {form.groove_clearance != 0.0, form.is_grooved(), "cam.groove_clearance", groove},
        {form.groove_wall.has_value(), form.is_grooved(), "cam.groove_wall", groove},
        {form.second_roller_radius.has_value(), form.is_conjugate(), "cam.second_roller_radius", conjugate},
        {form.roller_distance != 0.0, slides_conjugate, "cam.roller_distance", sliding},
        {form.second_offset.has_value(), slides_conjugate, "cam.second_offset", sliding},
        {form.arm_angle != 0.0, swings_conjugate, "cam.arm_angle", swinging},
        {form.second_arm_length.has_value(), swings_conjugate, "cam.second_arm_length", swinging},
    }};
    for (const Row& row : rows)
        if (row.given && !row.fits)
            return SceneFault{
                row.member,
                fmt::format("a number that a cam of form \"{}\" with the follower \"{}\" does not have",
                            name_of(form.type), name_of(cam.follower)),
                row.allowed};
    return std::nullopt;
}

/// Every corner of the ranges of the dimensions.
std::vector<std::array<double, dimension_count>> corners_of(const CamSpec& cam) {
    std::vector<std::array<double, dimension_count>> all(1);
    for (std::size_t d = 0; d < all.front().size(); ++d) {
        const Dimension& dimension = cam.dimensions[d];
        const std::size_t count = all.size();
        if (dimension.is_variable())
            for (std::size_t i = 0; i < count; ++i) all.push_back(all[i]);
        for (std::size_t i = 0; i < all.size(); ++i) all[i][d] = i < count ? dimension.low : dimension.high;
    }
    return all;
}

constexpr double shown_mm = 1e-3;

Fault second_slide_fault(const CamSpec& cam, const std::array<double, dimension_count>& corner,
                         double highest) {
    const auto at = [&](DimensionIndex which) { return corner[static_cast<std::size_t>(which)]; };
    const double prime = at(base_radius) + at(roller_radius);
    const double rest = cam.form.roller_distance - std::sqrt(prime * prime - at(offset) * at(offset));
    const double second = cam.form.second_roller_radius.value_or(at(roller_radius));
    const double across = cam.form.second_offset.value_or(at(offset));
    if (std::isnan(rest)) return std::nullopt;  // the first disk is not buildable there: no reach
    if (rest - highest > 0.0 && std::hypot(rest - highest, across) > second) return std::nullopt;
    return SceneFault{
        "cam.roller_distance",
        fmt::format("{:.6g} mm, which leaves the second roller {:.6g} mm from the cam's centre where "
                    "the follower stands highest",
                    cam.form.roller_distance / shown_mm, (rest - highest) / shown_mm),
        fmt::format("more than its radius of {:.6g} mm, for every base and roller radius allowed",
                    second / shown_mm)};
}

Fault second_arm_fault(const CamSpec& cam, const std::array<double, dimension_count>& corner,
                       double highest) {
    const auto at = [&](DimensionIndex which) { return corner[static_cast<std::size_t>(which)]; };
    const double prime = at(base_radius) + at(roller_radius), a = at(center_distance), l = at(arm_length);
    const double start = std::acos((a * a + l * l - prime * prime) / (2.0 * a * l));
    if (std::isnan(start)) return std::nullopt;
    const double rest = cam.form.arm_angle - start, lowest = rest - highest;
    const double arm = cam.form.second_arm_length.value_or(l);
    const double distance = std::sqrt(a * a + arm * arm - 2.0 * a * arm * std::cos(lowest));
    const double second = cam.form.second_roller_radius.value_or(at(roller_radius));
    if (lowest > 0.0 && rest < std::numbers::pi && distance > second) return std::nullopt;
    constexpr double deg = std::numbers::pi / 180.0;
    return SceneFault{
        "cam.arm_angle",
        fmt::format("{:.6g} deg, which puts the second arm {:.6g} to {:.6g} deg from the line of "
                    "centres, its roller {:.6g} mm from the cam's centre",
                    cam.form.arm_angle / deg, lowest / deg, rest / deg, distance / shown_mm),
        fmt::format("between 0 and 180 deg, farther than its radius of {:.6g} mm, for every "
                    "dimension allowed",
                    second / shown_mm)};
}

/// The largest displacement that the scene gives, SI.
double highest_of(const MotionSpec& motion) {
    if (motion.type != MotionType::program) return motion.lift;
    double most = 0.0;
    for (const ProgramSegment& segment : motion.segments) most = std::max(most, segment.to.value_or(0.0));
    return motion.lift * most;
}

Fault groove_fault(const CamSpec& cam) {
    const double inner = cam[base_radius].low - 0.5 * cam.form.groove_clearance;
    if (inner > 0.0) return std::nullopt;
    return SceneFault{"cam.groove_clearance", fmt::format("{:.6g} mm", cam.form.groove_clearance / shown_mm),
                      "less than twice the base radius"};
}

}  // namespace

Fault cam_form_fault(const Scene& scene) {
    const CamSpec& cam = *scene.cam;
    const FormSpec& form = cam.form;
    if (form.drives_both_ways() && !has_roller(cam.follower))
        return SceneFault{
            "cam.form",
            fmt::format("\"{}\" for the follower \"{}\"", name_of(form.type), name_of(cam.follower)),
            "only with translating_roller and oscillating_roller: the others touch one side"};
    if (Fault fault = form_number_fault(form)) return fault;
    if (Fault fault = foreign_number_fault(cam)) return fault;
    if (form.is_grooved()) return groove_fault(cam);
    if (!form.is_conjugate()) return std::nullopt;
    const bool swings = is_oscillating(cam.follower);
    const double whole = swings ? form.arm_angle : form.roller_distance;
    if (!(std::isfinite(whole) && whole > 0.0))
        return SceneFault{swings ? "cam.arm_angle" : "cam.roller_distance",
                          fmt::format("{} for a cam of form \"conjugate\"", whole),
                          swings ? "the angle between the arms, above 0"
                                 : "the distance between the rollers' axes, above 0"};
    const double highest = highest_of(scene.motion);
    for (const auto& corner : corners_of(cam)) {
        Fault fault = is_oscillating(cam.follower) ? second_arm_fault(cam, corner, highest)
                                                   : second_slide_fault(cam, corner, highest);
        if (fault) return fault;
    }
    return std::nullopt;
}

}  // namespace camopt

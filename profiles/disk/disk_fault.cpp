// SPDX-License-Identifier: MIT
//
// Faults of a disk cam in a scene: numbers out of their ranges, no buildable cam at rest for any values of
// the
// ranges, a form without space for its second roller. With p = base + roller radius:
//   translating roller, knife: |offset| < p            oscillating roller: |a − l| < p < a + l
//   oscillating flat: |base + face offset| < a         (a centre distance, l arm length)
// The second roller of a conjugate cam, Δ the largest displacement given:
//   translating  s0 = √(p² − e²),       D − s0 − Δ > 0          (D between the rollers' axes)
//   oscillating  cos ψ0 = (a² + l² − p²)/(2 a l),  γ − ψ0 − Δ > 0, γ − ψ0 < π   (γ between the arms)
// and the second prime radius above the second roller's.
#include "core/text/quantity_text.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "scene/key_row.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

using Fault = std::optional<SceneFault>;
using enum DimensionIndex;

Fault dimension_fault(const DiskSpec& cam, DimensionIndex index) {
    if (!has_dimension(cam.follower, index)) return std::nullopt;
    const Dimension& dimension = cam[index];
    const std::string member = fmt::format("cam.{}", name_of(index));
    const Range range = is_offset(index) ? ranges::any : ranges::positive;
    for (const double value : {dimension.low, dimension.high})
        if (!range.contains(value)) return SceneFault{member, fmt::format("{}", value), range.number_text()};
    if (dimension.high < dimension.low)
        return SceneFault{member, fmt::format("a range from {} to {}", dimension.low, dimension.high),
                          "a range that ascends"};
    return std::nullopt;
}

Fault face_fault(const DiskSpec& cam) {
    const Range& range = ranges::positive;
    if (!cam.face_half_width || range.contains(*cam.face_half_width)) return std::nullopt;
    return SceneFault{"cam.face_half_width", fmt::format("{}", *cam.face_half_width), range.number_text()};
}

/// In the unit of the scene file.
std::string written_length(double value, const Dimension& dimension) {
    for (const Spelling& one : spellings::length)
        if (one.factor == dimension.unit) return fmt::format("{:.6g} {}", value / one.factor, one.unit);
    return length_text(value);
}

const char* prime_name(const DiskSpec& cam) {
    return has_roller(cam.follower) ? "base radius + roller radius" : "base radius";
}

Fault offset_fault(const DiskSpec& cam) {
    const Dimension& given = cam[offset];
    const double least = std::max({given.low, -given.high, 0.0});
    const double prime = cam[base_radius].high + cam[roller_radius].high;
    if (least < prime) return std::nullopt;
    return SceneFault{"cam.offset",
                      fmt::format("an offset of {}", written_length(given.low > 0.0 ? least : -least, given)),
                      fmt::format("less than {} to either side, the largest {}", written_length(prime, given),
                                  prime_name(cam))};
}

Fault arm_fault(const DiskSpec& cam) {
    const Dimension& base = cam[base_radius];
    const Dimension& center = cam[center_distance];
    const Dimension& arm = cam[arm_length];
    const double difference = std::max({center.low - arm.high, arm.low - center.high, 0.0});
    const double largest = base.high + cam[roller_radius].high;
    if (!(largest > difference))
        return SceneFault{"cam.base_radius",
                          fmt::format("{} for {}", written_length(largest, base), prime_name(cam)),
                          fmt::format("more than {}, the difference of center distance and arm length",
                                      written_length(difference, base))};
    const double sum = center.high + arm.high;
    const double smallest = base.low + cam[roller_radius].low;
    if (!(smallest < sum))
        return SceneFault{"cam.base_radius",
                          fmt::format("{} for {}", written_length(smallest, base), prime_name(cam)),
                          fmt::format("less than {}, the sum of center distance and arm length",
                                      written_length(sum, base))};
    return std::nullopt;
}

Fault face_reach_fault(const DiskSpec& cam) {
    const Dimension& base = cam[base_radius];
    const double center = cam[center_distance].high;
    const double smallest = base.low + cam[face_offset].low;
    const double largest = base.high + cam[face_offset].high;
    if (smallest < center && largest > -center) return std::nullopt;
    return SceneFault{
        "cam.base_radius",
        fmt::format("{} for base radius + face offset",
                    written_length(smallest < center ? largest : smallest, base)),
        fmt::format("less than {} to either side, the center distance", written_length(center, base))};
}

Fault rest_fault(const DiskSpec& cam) {
    if (has_dimension(cam.follower, offset)) return offset_fault(cam);
    if (has_dimension(cam.follower, arm_length)) return arm_fault(cam);
    if (has_dimension(cam.follower, face_offset)) return face_reach_fault(cam);
    return std::nullopt;
}

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

/// Every corner of the ranges of the dimensions.
std::vector<std::array<double, dimension_count>> corners_of(const DiskSpec& cam) {
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

/// In the unit in which the base radius is written: "12.5 mm".
std::string shown_length(const DiskSpec& cam, double length) {
    const LengthUnit unit = cam[base_radius].unit == units::inch ? LengthUnit::inch : LengthUnit::millimetre;
    return length_text(length, unit);
}

Fault second_slide_fault(const DiskSpec& cam, const std::array<double, dimension_count>& corner,
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
        fmt::format("{}, which leaves the second roller {} from the cam's centre at "
                    "the largest displacement",
                    shown_length(cam, cam.form.roller_distance), shown_length(cam, rest - highest)),
        fmt::format("more than its radius of {}, for every base and roller radius allowed",
                    shown_length(cam, second))};
}

Fault second_arm_fault(const DiskSpec& cam, const std::array<double, dimension_count>& corner,
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
    constexpr double deg = units::degree;
    return SceneFault{
        "cam.arm_angle",
        fmt::format("{:.6g} deg, which puts the second arm {:.6g} to {:.6g} deg from the line of "
                    "centres, its roller {} from the cam's centre",
                    cam.form.arm_angle / deg, lowest / deg, rest / deg, shown_length(cam, distance)),
        fmt::format("between 0 and 180 deg, with more than its radius of {}, for every "
                    "dimension allowed",
                    shown_length(cam, second))};
}

Fault groove_fault(const DiskSpec& cam) {
    const double inner = cam[base_radius].low - 0.5 * cam.form.groove_clearance;
    if (inner > 0.0) return std::nullopt;
    return SceneFault{"cam.groove_clearance", shown_length(cam, cam.form.groove_clearance),
                      "less than twice the base radius"};
}

Fault form_fault(const DiskSpec& cam, const MotionSpec& motion) {
    const FormSpec& form = cam.form;
    if (Fault fault = form_number_fault(form)) return fault;
    if (form.is_grooved()) return groove_fault(cam);
    if (!form.is_conjugate()) return std::nullopt;
    const bool swings = is_oscillating(cam.follower);
    const double whole = swings ? form.arm_angle : form.roller_distance;
    if (!(std::isfinite(whole) && whole > 0.0))
        return SceneFault{swings ? "cam.arm_angle" : "cam.roller_distance",
                          fmt::format("{} for a cam of form \"conjugate\"", whole),
                          swings ? "the angle between the arms, above 0"
                                 : "the distance between the rollers' axes, above 0"};
    const double highest = motion.displacements().second;
    for (const auto& corner : corners_of(cam))
        if (Fault fault =
                swings ? second_arm_fault(cam, corner, highest) : second_slide_fault(cam, corner, highest))
            return fault;
    return std::nullopt;
}

}  // namespace

std::optional<SceneFault> disk_fault(const DiskSpec& cam, const MotionSpec& motion) {
    if (is_oscillating(cam.follower) != motion.lift_is_angle)
        return SceneFault{"cam.follower",
                          fmt::format("\"{}\" where the lift is {}", name_of(cam.follower),
                                      length_or_angle(motion.lift_is_angle)),
                          motion.lift_is_angle ? "an oscillating follower, or a lift in mm, in or m"
                                               : "a translating follower, or a lift in deg or rad"};
    if (Fault fault = foreign_fault(cam)) return fault;
    for (int i = 0; i < dimension_count; ++i)
        if (Fault fault = dimension_fault(cam, static_cast<DimensionIndex>(i))) return fault;
    if (Fault fault = face_fault(cam)) return fault;
    if (Fault fault = rest_fault(cam)) return fault;
    return form_fault(cam, motion);
}

}  // namespace camopt

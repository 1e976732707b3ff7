// SPDX-License-Identifier: MIT
// The cam of a scene, the load of its follower, and the limits that a cam of this kind cannot have.
#include "scene/cam_flanks.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

Fault dimension_fault(const CamDimension& dimension) {
    const Dimension& value = dimension.value;
    const std::string member = value.key.empty() ? "mechanism." + dimension.name : value.key;
    for (const double number : {value.low, value.high})
        if (!std::isfinite(number)) return SceneFault{member, fmt::format("{}", number), "a finite number"};
    if (value.high < value.low)
        return SceneFault{member, fmt::format("a range from {} to {}", value.low, value.high),
                          "a range that ascends"};
    return std::nullopt;
}

constexpr const char* direct_only = "only with a cam that touches the output itself";
constexpr const char* plane_only = "only with a cam that is a plane outline";

/// Limits that only a cam which touches the output itself can have, or a plane one.
Fault foreign_limit(const Scene& scene, const CamMechanism& cam) {
    for (const LimitRow& row : limit_rows())
        if (row.in(scene.limits) && ((cam.direct() == nullptr && row.cams == LimitRow::Cams::disk) ||
                                     (!cam.radius_quantity() && row.cams == LimitRow::Cams::planar)))
            return SceneFault{fmt::format("limits.{}", row.name),
                              fmt::format("a limit that a cam of type \"{}\" does not have", cam.type()),
                              row.cams == LimitRow::Cams::planar ? plane_only : direct_only};
    return std::nullopt;
}

}  // namespace

std::optional<SceneFault> CamMechanism::find_fault(const CamSpec& spec, const MotionSpec& motion) const {
    for (const CamDimension& dimension : spec.dimensions)
        if (Fault fault = dimension_fault(dimension)) return fault;
    if (swings() != motion.lift_is_angle)
        return SceneFault{"motion.lift", length_or_angle(motion.lift_is_angle),
                          fmt::format("{} for this mechanism, whose output {}", length_or_angle(swings()),
                                      swings() ? "swings" : "slides")};
    const auto [least, most] = motion.displacements();
    if (std::string found = fault(spec.middle(), least, most); !found.empty())
        return SceneFault{"cam", found,
                          "a mechanism that reaches (ranges: with every dimension in its middle)"};
    return std::nullopt;
}

Fault cam_fault(const Scene& scene) {
    if (!scene.cam) return std::nullopt;
    const auto formulas = scene.cam->formulas();
    if (scene.forces && !formulas->carries_load())
        return SceneFault{"forces", fmt::format("forces with a cam of type \"{}\"", formulas->type()),
                          direct_only};
    if (Fault fault = foreign_limit(scene, *formulas)) return fault;
    return formulas->find_fault(*scene.cam, scene.motion);
}

Fault force_fault(const Scene& scene) {
    if (!scene.forces) return std::nullopt;
    if (!scene.cam) return SceneFault{"forces", "forces without a cam", "only together with a [cam] table"};
    if (!scene.motion.speed)
        return SceneFault{"forces", "forces without a speed", "only where motion.speed is given"};
    for (const SpringNumber& number : spring_numbers) {
        const auto& range = (*scene.forces).*number.range;
        if (range && !((*range)[0] < (*range)[1]))
            return SceneFault{number.key, fmt::format("{} to {}", (*range)[0], (*range)[1]),
                              "a range { min, max } with min < max, or a number"};
        if (range && !limits_spring(scene.limits))
            return SceneFault{number.key, "a range without a limit on loads",
                              "a number, or a range together with a limit on contact force, torque or Hertz "
                              "pressure: nothing else depends on the spring"};
    }
    if (scene.cam->face_radius && scene.cam->face_half_width == 0.0)
        return SceneFault{"cam.face_radius", fmt::format("{} m", *scene.cam->face_radius),
                          "more than half of forces.contact_width, which lies on the round face"};
    if (const auto& range = scene.forces->speed_range;
        range &&
        !((*range)[0] >= 0.0 && (*range)[0] <= *scene.motion.speed && *scene.motion.speed <= (*range)[1]))
        return SceneFault{"forces.speed_range",
                          fmt::format("{:g} to {:g} rpm", (*range)[0] / units::revolution_per_minute,
                                      (*range)[1] / units::revolution_per_minute),
                          "two speeds, not negative and the lower first, with motion.speed between them"};
    const std::vector<std::array<double, 2>>& load = scene.forces->load;
    for (std::size_t i = 0; i < load.size(); ++i)
        if (!std::isfinite(load[i][0]) || !std::isfinite(load[i][1]) ||
            (i > 0 && !(load[i][0] > load[i - 1][0])))
            return SceneFault{entry_key("forces.load", i),
                              fmt::format("{} at {} rad", load[i][1], load[i][0]),
                              "finite forces at ascending angles of one revolution"};
    return std::nullopt;
}

// The [drawing] table: numbers, and whether bore and keyway fit into the cam. The delivered cam is checked
// again when it is drawn: dimensions may be ranges here.

namespace {

Fault drawing_number_fault(const DrawingSpec& drawing) {
    const auto fault = [](const Range& range, double value, const char* member) -> Fault {
        if (range.contains(value)) return std::nullopt;
        return SceneFault{member, fmt::format("{}", value), range.number_text()};
    };
    const Keyway keyway = drawing.keyway.value_or(Keyway{1.0, 1.0, 0.0});
    for (const auto& [value, member] : std::array<std::pair<double, const char*>, 5>{
             {{drawing.bore.value_or(1.0), "drawing.bore"},
              {drawing.thickness.value_or(1.0), "drawing.thickness"},
              {drawing.groove_depth.value_or(1.0), "drawing.groove_depth"},
              {keyway.width, "drawing.keyway.width"},
              {keyway.depth, "drawing.keyway.depth"}}})
        if (Fault found = fault(ranges::positive, value, member)) return found;
    for (const auto& [value, member] : std::array<std::pair<double, const char*>, 2>{
             {{drawing.datum, "drawing.datum"}, {keyway.at, "drawing.keyway.at"}}})
        if (Fault found = fault(ranges::any, value, member)) return found;
    return std::nullopt;
}

Fault keyway_fault(const DrawingSpec& drawing, LengthUnit unit) {
    if (!drawing.keyway) return std::nullopt;
    if (!drawing.bore)
        return SceneFault{"drawing.keyway", "a keyway without a bore", "only where drawing.bore is given"};
    if (!(drawing.keyway->width < *drawing.bore))
        return SceneFault{"drawing.keyway.width", length_text(drawing.keyway->width, unit),
                          fmt::format("less than the bore's {}", length_text(*drawing.bore, unit))};
    return std::nullopt;
}

Fault groove_depth_fault(const DrawingSpec& drawing, const CamSpec& cam, LengthUnit unit) {
    if (!drawing.groove_depth) return std::nullopt;
    if (cam.find("groove_clearance") == nullptr)
        return SceneFault{"drawing.groove_depth", "a depth without a groove",
                          "only with cam.form = \"grooved\""};
    if (drawing.thickness && !(*drawing.groove_depth < *drawing.thickness))
        return SceneFault{"drawing.groove_depth", length_text(*drawing.groove_depth, unit),
                          fmt::format("less than the thickness, {}", length_text(*drawing.thickness, unit))};
    return std::nullopt;
}

/// The groove's floor at displacement 0 lies under the roller's far end.
Fault drum_drawing_fault(const DrawingSpec& drawing, const CamFlanks& cam, LengthUnit unit) {
    for (const auto& [given, member] : {std::pair(drawing.thickness, "drawing.thickness"),
                                        std::pair(drawing.groove_depth, "drawing.groove_depth")})
        if (given)
            return SceneFault{member, "a number of a disk on a drum",
                              "leave it out: cam.body_length and cam.roller_length say it"};
    const RollerAxis axis = cam.axis(0.0, 0.0);
    const double floor = (axis.foot + cam.roller_length * axis.direction).head<2>().norm();
    if (drawing.reach() < floor) return std::nullopt;
    return SceneFault{drawing.keyway ? "drawing.keyway" : "drawing.bore",
                      fmt::format("one that reaches {} from the axis", length_text(drawing.reach(), unit)),
                      fmt::format("less than {}, where the roller's far end runs", length_text(floor, unit))};
}

}  // namespace

Fault drawing_fault(const Scene& scene) {
    if (!scene.drawing) return std::nullopt;
    const Dimension* const base = scene.cam ? scene.cam->find(DimensionIndex::base_radius) : nullptr;
    const std::optional<CamFlanks> flanks =
        scene.cam ? scene.cam->formulas()->flanks(scene.cam->middle()) : std::nullopt;
    if (base == nullptr && !flanks)
        return SceneFault{"drawing", "a drawing without a base circle",
                          "only with a cam that has a base radius, or with a drum"};
    const DrawingSpec& drawing = *scene.drawing;
    if (Fault fault = drawing_number_fault(drawing)) return fault;
    if (Fault fault = keyway_fault(drawing, scene.length_unit)) return fault;
    if (flanks) return drum_drawing_fault(drawing, *flanks, scene.length_unit);
    if (Fault fault = groove_depth_fault(drawing, *scene.cam, scene.length_unit)) return fault;
    // The base circle is the cam's at displacement 0, where every motion begins.
    const double largest = base->high;
    if (drawing.reach() < largest) return std::nullopt;
    return SceneFault{
        drawing.keyway ? "drawing.keyway" : "drawing.bore",
        fmt::format("{} that {} {} from the centre", drawing.keyway ? "a keyway" : "a bore",
                    drawing.keyway ? "reaches" : "lies", length_text(drawing.reach(), scene.length_unit)),
        fmt::format("less than {}, the {}radius of the base circle", length_text(largest, scene.length_unit),
                    base->is_variable() ? "largest " : "")};
}

}  // namespace camopt

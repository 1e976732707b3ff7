// SPDX-License-Identifier: MIT
// The [drawing] table: numbers, and whether bore and keyway fit into the cam. The delivered cam is checked
// again when it is drawn: dimensions may be ranges here.
#include "core/numbers/range.hpp"
#include "core/units.hpp"
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace camopt {
namespace {

std::string drawn_mm(double length) {
    return fmt::format("{:.6g} mm", length / units::millimetre);
}

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

Fault keyway_fault(const DrawingSpec& drawing) {
    if (!drawing.keyway) return std::nullopt;
    if (!drawing.bore)
        return SceneFault{"drawing.keyway", "a keyway without a bore", "only where drawing.bore is given"};
    if (!(drawing.keyway->width < *drawing.bore))
        return SceneFault{"drawing.keyway.width", drawn_mm(drawing.keyway->width),
                          fmt::format("less than the bore's {}", drawn_mm(*drawing.bore))};
    return std::nullopt;
}

Fault groove_depth_fault(const DrawingSpec& drawing, const CamSpec& cam) {
    if (!drawing.groove_depth) return std::nullopt;
    if (cam.find("groove_clearance") == nullptr)
        return SceneFault{"drawing.groove_depth", "a depth without a groove",
                          "only with cam.form = \"grooved\""};
    if (drawing.thickness && !(*drawing.groove_depth < *drawing.thickness))
        return SceneFault{"drawing.groove_depth", drawn_mm(*drawing.groove_depth),
                          fmt::format("less than the thickness, {}", drawn_mm(*drawing.thickness))};
    return std::nullopt;
}

}  // namespace

Fault drawing_fault(const Scene& scene) {
    if (!scene.drawing) return std::nullopt;
    const Dimension* const base = scene.cam ? scene.cam->find(DimensionIndex::base_radius) : nullptr;
    if (base == nullptr)
        return SceneFault{"drawing", "a drawing without a base circle",
                          "only with a cam that has a base radius"};
    const DrawingSpec& drawing = *scene.drawing;
    if (Fault fault = drawing_number_fault(drawing)) return fault;
    if (Fault fault = keyway_fault(drawing)) return fault;
    if (Fault fault = groove_depth_fault(drawing, *scene.cam)) return fault;
    // The base circle is the cam's at displacement 0, where every motion begins.
    const double largest = base->high;
    if (drawing.reach() < largest) return std::nullopt;
    return SceneFault{drawing.keyway ? "drawing.keyway" : "drawing.bore",
                      fmt::format("{} that {} {} from the centre", drawing.keyway ? "a keyway" : "a bore",
                                  drawing.keyway ? "reaches" : "lies", drawn_mm(drawing.reach())),
                      fmt::format("less than {}, the {}radius of the base circle", drawn_mm(largest),
                                  base->is_variable() ? "largest " : "")};
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The cam of a scene, what its follower carries, and the limits that need them.
#include "core/numbers/range.hpp"
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {
namespace {

Fault dimension_fault(const CamSpec& cam, DimensionIndex index) {
    const Dimension& dimension = cam[index];
    const std::string member = fmt::format("cam.{}", name_of(index));
    if (!has_dimension(cam.follower, index)) {
        if (dimension.low == 0.0 && dimension.high == 0.0) return std::nullopt;
        return SceneFault{
            member, fmt::format("a dimension that the follower \"{}\" does not have", name_of(cam.follower)),
            "only with " + followers_with(index)};
    }
    const Range range = is_offset(index) ? ranges::any : ranges::positive;
    for (const double value : {dimension.low, dimension.high})
        if (!range.contains(value)) return SceneFault{member, fmt::format("{}", value), range.number_text()};
    if (dimension.high < dimension.low)
        return SceneFault{member, fmt::format("a range from {} to {}", dimension.low, dimension.high),
                          "a range that ascends"};
    return std::nullopt;
}

Fault face_fault(const CamSpec& cam) {
    if (!cam.face_half_width) return std::nullopt;
    if (!follower_of(cam.follower).has_face_width)
        return SceneFault{
            "cam.face_half_width",
            fmt::format("a dimension that the follower \"{}\" does not have", name_of(cam.follower)),
            "only with " + followers_with_face_width()};
    const Range& range = ranges::positive;
    if (!range.contains(*cam.face_half_width))
        return SceneFault{"cam.face_half_width", fmt::format("{}", *cam.face_half_width),
                          range.number_text()};
    return std::nullopt;
}

}  // namespace

Fault cam_fault(const Scene& scene) {
    if (!scene.cam) return std::nullopt;
    const CamSpec& cam = *scene.cam;
    if (is_oscillating(cam.follower) != scene.motion.lift_is_angle)
        return SceneFault{"cam.follower",
                          fmt::format("\"{}\" where the lift is {}", name_of(cam.follower),
                                      scene.motion.lift_is_angle ? "an angle" : "a length"),
                          scene.motion.lift_is_angle ? "an oscillating follower, or a lift in mm, in or m"
                                                     : "a translating follower, or a lift in deg or rad"};
    for (int i = 0; i < dimension_count; ++i)
        if (Fault fault = dimension_fault(cam, static_cast<DimensionIndex>(i))) return fault;
    if (Fault fault = face_fault(cam)) return fault;
    if (Fault fault = cam_geometry_fault(cam)) return fault;
    return cam_form_fault(scene);
}

Fault force_fault(const Scene& scene) {
    if (!scene.forces) return std::nullopt;
    if (!scene.cam) return SceneFault{"forces", "forces without a cam", "only together with a [cam] table"};
    if (!scene.motion.speed)
        return SceneFault{"forces", "forces without a speed", "only where motion.speed is given"};
    return std::nullopt;
}

}  // namespace camopt

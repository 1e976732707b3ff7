// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "scene/motion/set_points.hpp"
#include "studies/explain/adjustment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// A wanted number moves by so many times its size, or what is typical of a motion from 0 to 1, at most.
constexpr double farthest_wanted = 1e3;

std::vector<SetPoint>& points_of(MotionSpec& motion, int segment) {
    return segment < 0 ? motion.via : motion.segments[static_cast<std::size_t>(segment)].via;
}

/// A set point of a scene: the `index`-th of the rise, or of a segment.
struct Place {
    int segment = -1;
    std::size_t index = 0;
    double angle = 1.0, width = 1.0;  ///< of what normalises it: rad, x

    [[nodiscard]] SetPoint& in(Scene& scene) const { return points_of(scene.motion, segment)[index]; }
    [[nodiscard]] Scene removed_from(const Scene& scene) const {
        Scene changed = scene;
        std::vector<SetPoint>& points = points_of(changed.motion, segment);
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
        return changed;
    }
};

SetPointChanges::Value value_of(const Scene& scene, const PlacedPoint& point, const Place& place, int order) {
    const WrittenValue written = written_value(scene.motion, point, order);
    const double given = as_written(*point.wanted[static_cast<std::size_t>(order)] * written.per_normalised);
    const double size = std::max(std::abs(given), written.per_normalised);
    const double own_unit = std::pow(place.width, order) / written.per_normalised;
    SetPointChanges::Value value;
    value.order = order;
    value.per_normalised = written.per_normalised;
    value.change =
        number_adjustment(written.key, given, std::abs(given) > 0.0 ? std::abs(given) : size,
                          Range::between(given - farthest_wanted * size, given + farthest_wanted * size),
                          [place, order, own_unit](Scene& changed, double wanted) {
                              value_of(place.in(changed), order) = wanted * own_unit;
                          });
    if (point.is_region() && order > 0) return value;
    const bool only =
        std::ranges::count_if(point.wanted, [](const auto& one) { return one.has_value(); }) == 1;
    value.without = only ? place.removed_from(scene) : scene;
    if (!only) value_of(place.in(*value.without), order).reset();
    return value;
}

Adjustment place_change(const Scene& scene, const PlacedPoint& point, const Place& place) {
    const std::string& written = point.units.place;
    const double unit = written.empty() ? 1.0 : unit_of_place(written) / place.angle;
    Scene copy = scene;
    const double given = as_written(place.in(copy).at / unit);
    const double last = (place.segment < 0 ? scene.motion.length() : 1.0) / unit;
    return number_adjustment(
        fmt::format("{}.at{}{}", point.member, written.empty() ? "" : "_", written), given, last,
        Range::between(0.0, last),
        [place, unit](Scene& changed, double value) { place.in(changed).at = value * unit; });
}

}  // namespace

std::vector<SetPointChanges> set_point_changes(const Scene& scene) {
    std::vector<SetPointChanges> all;
    int segment = -1;
    std::size_t index = 0;
    for (const PlacedPoint& point : placed_points(scene.motion)) {
        index = point.segment == segment && !all.empty() ? index + 1 : 0;
        segment = point.segment;
        Place place{segment, index, scene.motion.unit_angle(), 1.0};
        if (segment >= 0) place.angle = scene.motion.segments[static_cast<std::size_t>(segment)].angle;
        place.width = place.angle / scene.motion.unit_angle();
        SetPointChanges changes{point.member, point.begin, place.removed_from(scene), {}, std::nullopt};
        for (int order = 0; order < 3; ++order)
            if (point.wanted[static_cast<std::size_t>(order)])
                changes.values.push_back(value_of(scene, point, place, order));
        if (!point.is_region()) changes.place = place_change(scene, point, place);
        all.push_back(std::move(changes));
    }
    return all;
}

}  // namespace camopt

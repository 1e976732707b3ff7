// SPDX-License-Identifier: MIT
#include "studies/explain/adjustment.hpp"

#include "core/units.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// The first change tried, relative; then it doubles.
constexpr double first_change = 0.02;
// No cam is built this much larger than asked for, and no limit is worth this much less.
constexpr double farthest_change = 1e3;
// Pressure angles end short of the right angle.
constexpr double largest_pressure_angle = 89.9 * units::degree;

/// Upwards from the limit of the program.
void add_own_limits(std::vector<Adjustment>& all, const Scene& scene) {
    for (std::size_t i = 0; i < scene.own_limits.size(); ++i) {
        const OwnLimit& limit = scene.own_limits[i];
        Adjustment adjustment;
        adjustment.key = limit.key();
        adjustment.given = adjustment.least = limit.limit;
        adjustment.step = first_change * limit.scale();
        adjustment.may_grow = true;
        adjustment.may_shrink = false;
        adjustment.most = limit.limit + farthest_change * limit.scale();
        adjustment.limit = true;
        adjustment.with = [i](const Scene& one, double value) {
            Scene changed = one;
            changed.own_limits[i].limit = value;
            return changed;
        };
        all.push_back(std::move(adjustment));
    }
}

/// Up to `end`, SI.
Adjustment limit_adjustment(const Scene& scene, const LimitRow& row, double end) {
    const WrittenLimit& limit = *row.in(scene.limits);
    const bool grows = !row.is_least();
    const double given = limit.given();
    Adjustment adjustment;
    adjustment.key = limit.key;
    adjustment.given = given;
    adjustment.step = first_change * std::max(std::abs(given), 1e-3 * std::abs(end / limit.unit_value));
    adjustment.may_grow = grows;
    adjustment.may_shrink = !grows;
    adjustment.least = grows ? given : end / limit.unit_value;
    adjustment.most = grows ? end / limit.unit_value : given;
    adjustment.limit = true;
    adjustment.with = [&row, unit = limit.unit_value](const Scene& one, double value) {
        Scene changed = one;
        row.in(changed.limits)->value = value * unit;
        return changed;
    };
    return adjustment;
}

void add_limits(std::vector<Adjustment>& all, const Scene& scene) {
    const LimitSpec& limits = scene.limits;
    // Where both strokes have their own the general one holds at rest, if it is the least.
    const bool both_replaced = limit_on(limits, LimitedFigure::rise_pressure_angle) &&
                               limit_on(limits, LimitedFigure::return_pressure_angle);
    for (const LimitRow& row : limit_rows()) {
        const auto& limit = row.in(limits);
        if (!limit) continue;
        if (row.figure == LimitedFigure::pressure_angle && both_replaced &&
            !pressure_limits(limits).general_at_rest_alone())
            continue;
        const bool is_angle = std::isfinite(row.range.high) && !row.is_least();
        const double most = is_angle ? largest_pressure_angle : farthest_change * limit->value;
        all.push_back(limit_adjustment(scene, row, row.is_least() ? row.range.low : most));
    }
}

void add_rise(std::vector<Adjustment>& all, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    const bool own_places = !scene.spline.breakpoints.empty() || !motion.via.empty();
    if (motion.type == MotionType::program ||
        (motion.type == MotionType::rr && motion.return_angle && own_places)) {
        return;
    }
    const double turn = 360.0;
    const double given = as_written(motion.rise / units::degree);
    const double rest = motion.return_angle ? *motion.return_angle / units::degree : 0.0;
    const bool doubled = motion.type == MotionType::rr && !motion.return_angle;
    Adjustment adjustment{"motion.rise_deg",
                          given,
                          first_change * given,
                          true,
                          false,
                          given,
                          doubled ? 0.5 * turn : turn - rest,
                          {}};
    adjustment.with = [](const Scene& one, double value) {
        Scene changed = one;
        changed.motion.rise = value * units::degree;
        keep_written(changed.motion, one.motion);
        rescale_limits_in_time(changed, changed.motion.rise / one.motion.rise);
        return changed;
    };
    all.push_back(std::move(adjustment));
}

void add_dimension(std::vector<Adjustment>& all, const Scene& scene, DimensionIndex which) {
    const Dimension& dimension = (*scene.cam)[which];
    const std::string key =
        dimension.key.empty() ? std::string("cam.") + name_of(which) + "_mm" : dimension.key;
    const double unit = dimension.unit;
    const double size =
        std::max(std::abs(dimension.high), first_change * (*scene.cam)[DimensionIndex::base_radius].high);
    const bool has_sign = which == DimensionIndex::offset || which == DimensionIndex::face_offset;
    // A larger base circle always helps a translating follower; the rest may have to move either way.
    const bool grows_only = which == DimensionIndex::base_radius && !is_oscillating(scene.cam->follower) &&
                            !scene.cam->form.is_conjugate();
    const auto with = [which, unit](const Scene& one, bool upper, double value) {
        Scene changed = one;
        Dimension& own = (*changed.cam)[which];
        const bool range = own.is_variable();
        if (upper || !range) own.high = value * unit;
        if (!upper || !range) own.low = value * unit;
        return changed;
    };
    const double farthest_value = farthest_change * size / unit;
    if (!dimension.is_variable()) {
        Adjustment adjustment{key,
                              as_written(dimension.low / unit),
                              first_change * size / unit,
                              true,
                              !grows_only,
                              has_sign ? -farthest_value : 0.0,
                              farthest_value,
                              {}};
        adjustment.with = [with](const Scene& one, double value) { return with(one, true, value); };
        all.push_back(std::move(adjustment));
        return;
    }
    Adjustment upper{key + ".max",
                     as_written(dimension.high / unit),
                     first_change * size / unit,
                     true,
                     false,
                     as_written(dimension.high / unit),
                     farthest_value,
                     {}};
    upper.with = [with](const Scene& one, double value) { return with(one, true, value); };
    all.push_back(std::move(upper));
    if (grows_only) return;
    Adjustment lower{key + ".min", as_written(dimension.low / unit), first_change * size / unit,       false,
                     true,         has_sign ? -farthest_value : 0.0, as_written(dimension.low / unit), {}};
    lower.with = [with](const Scene& one, double value) { return with(one, false, value); };
    all.push_back(std::move(lower));
}

/// Of a coordinate or an angle that happens to be 0.
double least_mechanism_size(const Scene& scene, std::size_t index) {
    constexpr double least_angle = 0.5, least_length = 0.05;
    return scene.mechanism->dimensions[index].is_angle ? least_angle : least_length;
}

/// Each may have to move either way; a change is judged by the mechanism's reach too.
void add_mechanism_dimensions(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.mechanism) return;
    for (std::size_t i = 0; i < scene.mechanism->dimensions.size(); ++i) {
        const Dimension& dimension = scene.mechanism->dimensions[i].value;
        if (dimension.key.empty() || dimension.is_variable()) continue;
        const double size = std::max(std::abs(dimension.high), least_mechanism_size(scene, i));
        const double farthest_value = farthest_change * size / dimension.unit;
        Adjustment adjustment{dimension.key,
                              as_written(dimension.low / dimension.unit),
                              first_change * size / dimension.unit,
                              true,
                              true,
                              -farthest_value,
                              farthest_value,
                              {}};
        adjustment.with = [i, unit = dimension.unit](const Scene& one, double value) {
            Scene changed = one;
            Dimension& own = changed.mechanism->dimensions[i].value;
            own.low = own.high = value * unit;
            return changed;
        };
        all.push_back(std::move(adjustment));
    }
}

void add_face(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.cam->face_half_width) return;
    const double unit = metres_of(scene.length_unit), given = as_written(*scene.cam->face_half_width / unit);
    Adjustment adjustment{std::string("cam.face_half_width_") + name_of(scene.length_unit),
                          given,
                          first_change * given,
                          true,
                          false,
                          given,
                          farthest_change * given,
                          {}};
    adjustment.limit = true;
    adjustment.with = [unit](const Scene& one, double value) {
        Scene changed = one;
        changed.cam->face_half_width = value * unit;
        return changed;
    };
    all.push_back(std::move(adjustment));
}

}  // namespace

std::vector<Adjustment> adjustments(const Scene& scene) {
    std::vector<Adjustment> all;
    add_limits(all, scene);
    add_own_limits(all, scene);
    add_rise(all, scene);
    add_mechanism_dimensions(all, scene);
    const std::vector<Adjustment> operating = operating_adjustments(scene);
    all.insert(all.end(), operating.begin(), operating.end());
    if (!scene.cam) return all;
    for (int d = 0; d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        if (has_dimension(scene.cam->follower, which)) add_dimension(all, scene, which);
    }
    add_face(all, scene);
    return all;
}

}  // namespace camopt

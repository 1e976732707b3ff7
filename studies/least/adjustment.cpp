// SPDX-License-Identifier: MIT
#include "studies/least/adjustment.hpp"

#include "objectives/motion_bounds.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Beyond a thousand times its size a change of a dimension or a limit is no advice.
constexpr double farthest_change = 1e3;

/// Upwards from the limit of the program.
void add_own_limits(std::vector<Adjustment>& all, const Scene& scene) {
    for (std::size_t i = 0; i < scene.own_limits.size(); ++i) {
        const OwnLimit& limit = scene.own_limits[i];
        all.push_back(
            number_adjustment(limit.key(), limit.limit, limit.scale(),
                              Range::between(limit.limit, limit.limit + farthest_change * limit.scale()),
                              [i](Scene& changed, double value) { changed.own_limits[i].limit = value; }));
        all.back().limit = true;
        all.back().usefulness = Usefulness::limit;
    }
}

/// Up to `end`, SI.
Adjustment limit_adjustment(const Scene& scene, const LimitRow& row, double end) {
    const WrittenLimit& limit = *row.in(scene.limits);
    const double given = limit.given(), last = end / limit.unit_value;
    Adjustment adjustment =
        number_adjustment(limit.key, given, std::max(std::abs(given), 1e-3 * std::abs(last)),
                          row.is_least() ? Range::between(last, given) : Range::between(given, last),
                          [&row, unit = limit.unit_value](Scene& changed, double value) {
                              row.in(changed.limits)->value = value * unit;
                          });
    adjustment.limit = true;
    adjustment.usefulness = Usefulness::limit;
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

/// What a dimension is measured by.
double size_of(const CamSpec& cam, const CamDimension& dimension) {
    constexpr double least_angle = 0.5,
                     least_length = 0.05;  // of a coordinate or an angle that happens to be 0
    const double own = std::abs(dimension.value.high);
    if (const Dimension* const base = cam.find(DimensionIndex::base_radius))
        return std::max(own, first_change * base->high);
    return std::max(own, dimension.is_angle ? least_angle : least_length);
}

/// A larger base circle always helps a follower that is pushed straight; the rest may have to move either
/// way.
bool only_grows(const CamMechanism& formulas, const CamDimension& dimension) {
    return dimension.name == name_of(DimensionIndex::base_radius) && !formulas.swings() &&
           !formulas.limit_structure().binds(MechanismQuantity::pressure_numerator, 1);
}

std::optional<DimensionIndex> index_named(const std::string& name) {
    for (int d = 0; d < dimension_count; ++d)
        if (name == name_of(static_cast<DimensionIndex>(d))) return static_cast<DimensionIndex>(d);
    return {};
}

/// Arms and radii of a cam with a base circle are positive. Of another cam a dimension without which it
/// cannot be stays on its side of 0; what else may be negative is for the formulas to say.
bool keeps_sign(const CamSpec& cam, std::size_t index) {
    if (cam.find(DimensionIndex::base_radius) != nullptr) {
        const std::optional<DimensionIndex> which = index_named(cam.dimensions[index].name);
        return !(which && is_offset(*which));
    }
    std::vector<double> numbers = cam.middle();
    const auto formulas = cam.formulas();
    if (!formulas->fault(numbers, 0.0, 0.0).empty()) return false;
    numbers[index] = 0.0;
    return !formulas->fault(numbers, 0.0, 0.0).empty();
}

void add_dimension(std::vector<Adjustment>& all, const CamSpec& cam, std::size_t index, bool grows_only) {
    const CamDimension& dimension = cam.dimensions[index];
    const Dimension& value = dimension.value;
    const double unit = value.unit, size = size_of(cam, dimension);
    const double farthest = farthest_change * size / unit;
    const bool one_side = keeps_sign(cam, index);
    const double least = one_side && !(value.low < 0.0) ? 0.0 : -farthest,
                 largest = one_side && value.low < 0.0 ? 0.0 : farthest;
    const auto add = [&](const std::string& name, double number, const Range& range, bool upper) {
        all.push_back(number_adjustment(name, number, size / unit, range,
                                        [index, unit, upper](Scene& changed, double to) {
                                            Dimension& own = changed.cam->dimensions[index].value;
                                            const bool one = !own.is_variable();
                                            if (upper || one) own.high = to * unit;
                                            if (!upper || one) own.low = to * unit;
                                        }));
        if (dimension.name == name_of(DimensionIndex::base_radius))
            all.back().usefulness = Usefulness::base_radius;
    };
    const double from = as_written(value.low / unit), to = as_written(value.high / unit);
    if (!value.is_variable())
        return add(value.key, from, Range::between(grows_only ? from : least, largest), true);
    add(value.key + ".max", to, Range::between(to, largest), true);
    if (!grows_only) add(value.key + ".min", from, Range::between(least, from), false);
}

/// Of a cam with a base circle not the numbers of its form, of a linkage not what is free already.
bool is_looked_at(const CamSpec& cam, const CamDimension& dimension) {
    if (dimension.value.key.empty()) return false;
    if (cam.find(DimensionIndex::base_radius) == nullptr) return !dimension.value.is_variable();
    return index_named(dimension.name).has_value();
}

void add_dimensions(std::vector<Adjustment>& all, const CamSpec& cam) {
    const auto formulas = cam.formulas();
    for (std::size_t i = 0; i < cam.dimensions.size(); ++i)
        if (is_looked_at(cam, cam.dimensions[i]))
            add_dimension(all, cam, i, only_grows(*formulas, cam.dimensions[i]));
}

void add_face(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.cam->face_half_width) return;
    const CamSpec& cam = *scene.cam;
    const Spelling spelling = scene.length_spelling_of(cam.face_key());
    const double unit = spelling.factor;
    const double given = as_written(cam.face_radius.value_or(*cam.face_half_width) / unit);
    const double contact =
        cam.face_radius ? 2.0 * std::sqrt(std::max(0.0, *cam.face_radius * *cam.face_radius -
                                                            *cam.face_half_width * *cam.face_half_width))
                        : 0.0;
    all.push_back(number_adjustment(fmt::format("{}{}", cam.face_key(), spelling.suffix), given, given,
                                    Range::between(given, farthest_change * given),
                                    [unit, contact](Scene& changed, double value) {
                                        if (changed.cam->face_radius)
                                            changed.cam->set_round_face(value * unit, contact);
                                        else
                                            changed.cam->face_half_width = value * unit;
                                    }));
    all.back().limit = true;
    all.back().usefulness = Usefulness::limit;
}

// Caps on peaks, springs, speed: what a user could change beside the cam.

// Beyond a thousand times its size a change of a spring, a speed or a cap is no advice.
constexpr double farthest_operating_change = 1e3;

/// The bounds of corridors, each to its side.
void add_corridors(std::vector<Adjustment>& all, const Scene& scene) {
    for (const WrittenBound& bound : motion_bounds(scene)) {
        if (bound.corridor < 0) continue;
        const auto index = static_cast<std::size_t>(bound.corridor);
        const double size = std::max(std::abs(bound.given), bound.per_normalised);
        const double end = bound.given + bound.sign * farthest_operating_change * size;
        all.push_back(
            number_adjustment(bound.key, bound.given, size,
                              Range::between(std::min(bound.given, end), std::max(bound.given, end)),
                              [index, order = static_cast<std::size_t>(bound.order), least = bound.sign < 0,
                               unit = bound.per_normalised](Scene& changed, double value) {
                                  Corridor::Bounds& bounds = changed.motion.corridors[index].bounds[order];
                                  (least ? bounds.least : bounds.most) = value / unit;
                              }));
        all.back().limit = true;
        all.back().usefulness = Usefulness::limit;
        all.back().begin = bound.from;
        all.back().end = bound.until;
    }
}

Adjustment peak_adjustment(const PeakLimit& limit, const PeakLimitRow& row) {
    // Of one side: to that side, by a thousand times its size (which may be that of the peak, in its unit).
    const double size =
        row.side == 0 ? limit.given : std::max(std::abs(limit.given), limit.unit_per_normalised());
    const double end = limit.given + (row.side < 0 ? -1.0 : 1.0) * farthest_operating_change * size;
    Adjustment adjustment = number_adjustment(
        limit.key, limit.given, size, Range::between(std::min(limit.given, end), std::max(limit.given, end)),
        [&row](Scene& changed, double value) {
            PeakLimit& own = *row.in(changed.limits);
            own.normalised = value / own.unit_per_normalised();
            own.given = value;
        });
    adjustment.limit = true;
    adjustment.usefulness = Usefulness::limit;
    return adjustment;
}

/// One number of the forces, or the ends of the range that it is chosen from. least_size: what a change of it
/// is measured by at least, SI.
void add_spring_number(std::vector<Adjustment>& all, const Scene& scene, const char* name,
                       const Spelling& otherwise, double ForceSpec::*member,
                       std::optional<std::array<double, 2>> ForceSpec::*range, double least_size) {
    const Spelling spelling = scene.spelling_of(name, otherwise);
    const double unit = spelling.factor;
    const std::string key = fmt::format("{}{}", name, spelling.suffix);
    const auto sized = [&](double number) { return std::max(std::abs(number), least_size / unit); };
    const auto& both = (*scene.forces).*range;
    if (!both) {
        const double given = as_written((*scene.forces).*member / unit), size = sized(given);
        all.push_back(number_adjustment(
            key, given, size, Range::between(std::min(0.0, given), farthest_operating_change * size),
            [member, unit](Scene& changed, double value) { (*changed.forces).*member = value * unit; }));
        return;
    }
    for (const std::size_t end : {std::size_t{1}, std::size_t{0}}) {
        const double given = as_written((*both)[end] / unit), size = sized(given);
        all.push_back(number_adjustment(key + (end == 1 ? ".max" : ".min"), given, size,
                                        end == 1 ? Range::between(given, farthest_operating_change * size)
                                                 : Range::between(std::min(0.0, given), given),
                                        [member, range, end, unit](Scene& changed, double value) {
                                            std::array<double, 2>& own = *((*changed.forces).*range);
                                            own[end] = value * unit;
                                            (*changed.forces).*member = 0.5 * (own[0] + own[1]);
                                        }));
    }
}

void add_springs(std::vector<Adjustment>& all, const Scene& scene) {
    const ForceSpec& forces = *scene.forces;
    const bool swings = scene.motion.lift_is_angle;
    const double lift = scene.motion.lift;
    // A follower without spring or preload has forces of the size of its limit, or of one N.
    const auto& least_force = limit_on(scene.limits, LimitedFigure::contact_force);
    const double limit = least_force ? std::abs(least_force->value) : 0.0;
    const double force =
        std::max({std::abs(forces.preload), forces.spring_rate * lift, limit, limit > 0.0 ? 0.0 : 1.0});
    const bool inches = scene.length_unit == LengthUnit::inch;
    const Spelling& rate = swings   ? unit_named<"N m/rad">
                           : inches ? unit_named<"lbf/in">
                                    : unit_named<"N/mm">;
    add_spring_number(all, scene, "forces.preload",
                      (swings ? spellings::moment : spellings::force)[inches ? 1 : 0], &ForceSpec::preload,
                      &ForceSpec::preload_range, force);
    add_spring_number(all, scene, "forces.spring_rate", rate, &ForceSpec::spring_rate,
                      &ForceSpec::spring_rate_range, force / lift);
}

void add_contact_width(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.forces->contact_width || !limit_on(scene.limits, LimitedFigure::hertz_pressure)) return;
    const Spelling spelling = scene.length_spelling_of("forces.contact_width");
    const double unit = spelling.factor, given = as_written(*scene.forces->contact_width / unit);
    all.push_back(number_adjustment(
        fmt::format("forces.contact_width{}", spelling.suffix), given, given,
        Range::between(given, farthest_operating_change * given),
        [unit](Scene& changed, double value) { changed.forces->contact_width = value * unit; }));
}

void add_forces(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.forces || !limits_spring(scene.limits)) return;
    add_springs(all, scene);
    add_contact_width(all, scene);
}

/// Tighter, down to none at all.
void add_tolerance(std::vector<Adjustment>& all, const Scene& scene, const std::string& name,
                   const Spelling& otherwise, double size,
                   const std::function<void(ToleranceSpec&, double size)>& set) {
    const Spelling spelling = scene.spelling_of("tolerance." + name, otherwise);
    const double unit = spelling.factor, given = as_written(size / unit);
    all.push_back(number_adjustment(
        fmt::format("tolerance.{}{}", name, spelling.suffix), given, given, Range::between(0.0, given),
        [set, unit](Scene& changed, double value) { set(*changed.tolerance, value * unit); }));
}

void add_tolerances(std::vector<Adjustment>& all, const Scene& scene) {
    using namespace spellings;
    const std::array<Spelling, 3> of_motion = {profile_error[0], slope_error[0], acceleration_error[0]};
    for (std::size_t order = 0; order < of_motion.size(); ++order)
        if (const auto& size = scene.tolerance->motion[order])
            add_tolerance(all, scene, motion_tolerance_names[order], of_motion[order], *size,
                          [order](ToleranceSpec& own, double to) { own.motion[order] = to; });
    for (const auto& [name, tolerance] : scene.tolerance->numbers) {
        const int own = scene.cam->written_as(name);
        const Spelling* const of_dimension =
            own < 0 ? nullptr : unit_of_key(scene.cam->dimensions[static_cast<std::size_t>(own)].value.key);
        const Spelling si = of_dimension != nullptr ? *of_dimension
                            : name == "preload"     ? unit_named<"N">
                                                    : unit_named<"N/mm">;
        add_tolerance(all, scene, name + (tolerance.percent ? "_percent" : ""),
                      tolerance.percent ? unit_named<""> : si, tolerance.size,
                      [name = name](ToleranceSpec& own, double to) { own.numbers.at(name).size = to; });
    }
}

bool goes_by_time(const Scene& scene) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits); limit && limit->in_time()) return true;
    for (const LimitRow& row : limit_rows())
        if (row.needs_drive && row.in(scene.limits)) return true;
    if (!scene.limits.motor_curve.empty()) return true;
    return scene.forces && limits_forces(scene.limits);
}

void add_speed(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.motion.speed || !goes_by_time(scene)) return;
    const bool engine = scene.motion.valve.has_value();  // turns twice as fast as its cam
    const std::string name = engine ? "motion.engine_speed" : "motion.speed";
    const Spelling spelling = scene.spelling_of(name, spellings::speed[0]);
    const double unit = (engine ? 0.5 : 1.0) * spelling.factor;
    const double given = as_written(*scene.motion.speed / unit);
    all.push_back(number_adjustment(fmt::format("{}{}", name, spelling.suffix), given, given,
                                    Range::between(given / farthest_operating_change, given),
                                    [unit](Scene& changed, double value) {
                                        const MotionSpec before = changed.motion;
                                        changed.motion.speed = value * unit;
                                        keep_written(changed, before);
                                    }));
    all.back().usefulness = Usefulness::speed;
}

}  // namespace

Adjustment number_adjustment(std::string key, double given, double size, const Range& range,
                             std::function<void(Scene& scene, double value)> set) {
    Adjustment adjustment;
    adjustment.key = std::move(key);
    adjustment.given = given;
    adjustment.step = first_change * size;
    adjustment.least = range.low;
    adjustment.most = range.high;
    adjustment.may_grow = range.high > given;
    adjustment.may_shrink = range.low < given;
    adjustment.with = [set = std::move(set)](const Scene& scene, double value) {
        Scene changed = scene;
        set(changed, value);
        copy_repeats(changed.motion);
        return changed;
    };
    return adjustment;
}

std::vector<Adjustment> adjustments(const Scene& scene) {
    std::vector<Adjustment> all;
    add_corridors(all, scene);
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits)) all.push_back(peak_adjustment(*limit, row));
    for (Adjustment& one : motion_adjustments(scene)) all.push_back(std::move(one));
    add_limits(all, scene);
    add_own_limits(all, scene);
    add_forces(all, scene);
    add_speed(all, scene);
    if (!scene.cam) return all;
    if (scene.tolerance) add_tolerances(all, scene);
    add_dimensions(all, *scene.cam);
    add_face(all, scene);
    return all;
}

}  // namespace camopt

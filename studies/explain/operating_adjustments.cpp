// SPDX-License-Identifier: MIT
// Caps on peaks, springs, speed: what a user could change beside the cam.
#include "core/units.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"
#include "studies/explain/adjustment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

// Beyond a thousand times its size a change of a spring, a speed or a cap is no advice.
constexpr double farthest_operating_change = 1e3;

Adjustment peak_adjustment(const PeakLimit& limit, const PeakLimitRow& row) {
    Adjustment adjustment =
        number_adjustment(limit.key, limit.given, limit.given,
                          Range::between(limit.given, farthest_operating_change * limit.given),
                          [&row](Scene& changed, double value) {
                              PeakLimit& own = *row.in(changed.limits);
                              own.normalised = value / own.unit_per_normalised();
                              own.given = value;
                          });
    adjustment.limit = true;
    adjustment.usefulness = Usefulness::limit;
    return adjustment;
}

/// One number of the forces. size: what a change of it is measured by, in the unit of the key.
struct ForceNumber {
    const char* key;
    double ForceSpec::*member;
    double unit;  ///< SI value of one unit of the key
    double size;
};

Adjustment force_adjustment(const Scene& scene, const ForceNumber& number) {
    const double given = as_written((*scene.forces).*number.member / number.unit);
    const double size = std::max(std::abs(given), number.size);
    return number_adjustment(
        number.key, given, size, Range::between(std::min(0.0, given), farthest_operating_change * size),
        [number](Scene& changed, double value) { (*changed.forces).*number.member = value * number.unit; });
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
    all.push_back(force_adjustment(
        scene, {swings ? "forces.preload_nm" : "forces.preload_n", &ForceSpec::preload, 1.0, force}));
    const double rate_unit = swings ? 1.0 : 1.0 / units::millimetre;
    all.push_back(force_adjustment(scene, {swings ? "forces.spring_rate_nm_rad" : "forces.spring_rate_n_mm",
                                           &ForceSpec::spring_rate, rate_unit, force / lift / rate_unit}));
}

void add_contact_width(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.forces->contact_width || !limit_on(scene.limits, LimitedFigure::hertz_pressure)) return;
    const double unit = metres_of(scene.length_unit), given = as_written(*scene.forces->contact_width / unit);
    all.push_back(number_adjustment(
        std::string("forces.contact_width_") + name_of(scene.length_unit), given, given,
        Range::between(given, farthest_operating_change * given),
        [unit](Scene& changed, double value) { changed.forces->contact_width = value * unit; }));
}

bool goes_by_time(const Scene& scene) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits); limit && limit->in_time()) return true;
    return scene.forces && limits_forces(scene.limits);
}

void add_speed(std::vector<Adjustment>& all, const Scene& scene) {
    if (!scene.motion.speed || !goes_by_time(scene)) return;
    const double unit = units::revolution_per_minute;
    const double given = as_written(*scene.motion.speed / unit);
    all.push_back(number_adjustment("motion.speed_rpm", given, given,
                                    Range::between(given / farthest_operating_change, given),
                                    [unit](Scene& changed, double value) {
                                        const MotionSpec before = changed.motion;
                                        changed.motion.speed = value * unit;
                                        keep_written(changed, before);
                                    }));
    all.back().usefulness = Usefulness::speed;
}

}  // namespace

void keep_written(Scene& changed, const MotionSpec& before) {
    MotionSpec& now = changed.motion;
    keep_written(now, before);
    // Normalised peak · lift · (speed / unit angle)^order is what a limit in time holds.
    const double pace =
        before.speed.value_or(1.0) / now.speed.value_or(1.0) * now.unit_angle() / before.unit_angle();
    for (const PeakLimitRow& row : peak_limit_rows())
        if (auto& limit = row.in(changed.limits); limit && limit->in_time())
            limit->normalised *= before.lift / now.lift * std::pow(pace, row.order());
}

std::vector<Adjustment> peak_adjustments(const Scene& scene) {
    std::vector<Adjustment> all;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits)) all.push_back(peak_adjustment(*limit, row));
    return all;
}

std::vector<Adjustment> operating_adjustments(const Scene& scene) {
    std::vector<Adjustment> all;
    if (scene.forces && limits_forces(scene.limits)) {
        add_springs(all, scene);
        add_contact_width(all, scene);
    }
    add_speed(all, scene);
    return all;
}

}  // namespace camopt

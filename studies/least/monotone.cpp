// SPDX-License-Identifier: MIT
#include "studies/least/monotone.hpp"

#include "scene/cam_mechanism.hpp"
#include "scene/limit_table.hpp"

namespace camopt {

namespace {

bool counts_in_time(const std::optional<SetPoint>& point) {
    return point && (is_unit_of_time(point->units.velocity) || is_unit_of_time(point->units.acceleration));
}

bool has_limit(const Scene& scene, const std::function<bool(const LimitRow&)>& of) {
    return std::ranges::any_of(
        limit_rows(), [&](const LimitRow& row) { return of(row) && row.in(scene.limits).has_value(); });
}

bool limits_loads_beside_contact_force(const Scene& scene) {
    return has_limit(scene, [](const LimitRow& row) {
        return (row.needs_forces || row.needs_dynamics) && row.figure != LimitedFigure::contact_force;
    });
}

/// The follower is never below s = 0.
bool stays_above_zero(const MotionSpec& motion) {
    if (motion.valve) return true;  // a lobe only opens, then closes
    const auto moves = [](const std::optional<SetPoint>& end) {
        return end && end->velocity.value_or(0.0) != 0.0;
    };
    // Set points and ends in motion may take a stroke out of the range of its displacements.
    if (!motion.via.empty() || moves(motion.start) || moves(motion.end)) return false;
    const auto last = std::ranges::find_if(
        motion.segments.rbegin(), motion.segments.rend(),
        [](const ProgramSegment& segment) { return segment.kind != SegmentKind::dwell; });
    for (const ProgramSegment& segment : motion.segments) {
        const bool returns = motion.closed && last != motion.segments.rend() && &segment == &*last;
        const bool is_free = segment.kind != SegmentKind::dwell && !segment.to && !returns;
        if (is_free || !segment.via.empty() || moves(segment.end)) return false;
    }
    return motion.within_lift && motion.displacements().first >= 0.0;
}

/// F(sω) = F_0 + s² (F(ω) − F_0) for s < 1 lies between F(ω) and the force F_0 at rest, which satisfies the
/// limit everywhere.
bool contact_tightens_with_speed(const Scene& scene) {
    if (!limit_on(scene.limits, LimitedFigure::contact_force)) return true;
    const ForceSpec& forces = *scene.forces;
    if (forces.damping > 0.0 || forces.speed_range || !stays_above_zero(scene.motion)) return false;
    double least_load = forces.load.empty() ? 0.0 : forces.load.front()[1];
    for (const auto& [angle, load] : forces.load) least_load = std::min(least_load, load);
    const double preload = forces.preload_range ? (*forces.preload_range)[0] : forces.preload;
    return preload + least_load >= limit_on(scene.limits, LimitedFigure::contact_force)->value;
}

/// Every limit loosens as the base radius, or the travel of a plate towards -x, grows: s' lies between bounds
/// in proportion to the travel.
bool loosens_with_size(const Scene& scene) {
    const auto formulas = scene.cam->formulas();
    if (formulas->swings() || formulas->limit_structure().binds(MechanismQuantity::pressure_numerator, 1))
        return false;
    const bool flat = formulas->contact() == ContactKind::flat;
    return !has_limit(scene, [&](const LimitRow& row) {
        const bool pressure = row.figure == LimitedFigure::pressure_angle ||
                              row.figure == LimitedFigure::rise_pressure_angle ||
                              row.figure == LimitedFigure::return_pressure_angle;
        const bool radius = row.figure == LimitedFigure::convex_radius ||
                            row.figure == LimitedFigure::concave_radius ||
                            row.figure == LimitedFigure::regularity;
        return row.of_cam() && !pressure && !(radius && flat);
    });
}

}  // namespace

std::optional<Tightens> tightening_of(const Scene& scene, std::string_view key) {
    if (scene.prescribes_output())
        return std::nullopt;  // the cam's motion changes with the train and the speed
    const auto is = [&](std::string_view name) { return key.starts_with(name); };
    if (scene.forces && is("forces.preload") && !limits_loads_beside_contact_force(scene))
        return Tightens::downward;
    if (scene.forces && is("forces.spring_rate") && !limits_loads_beside_contact_force(scene) &&
        stays_above_zero(scene.motion))
        return Tightens::downward;
    if ((is("motion.speed") || is("motion.engine_speed")) && only_tightens_with_speed(scene))
        return Tightens::upward;
    if (is("tolerance.")) return Tightens::upward;
    const Dimension* const travel = scene.cam ? scene.cam->find("travel") : nullptr;
    const bool grows = is("cam.base_radius") || (is("cam.travel") && travel != nullptr && travel->low > 0.0);
    if (scene.cam && grows && loosens_with_size(scene)) return Tightens::downward;
    return std::nullopt;
}

bool only_tightens_with_speed(const Scene& scene) {
    // τ(sω) = s² (τ(ω) − τ_0) + τ_0 lies between τ(ω) and the torque τ_0 at rest, which every limit allows;
    // viscous friction, and a torque that falls with the speed, change by s.
    const LimitSpec& limits = scene.limits;
    const bool holds_torque =
        limits.motor_torque || limits.motor_torque_min || limits.motor_torque_max || limits.motor_torque_rms;
    if (!limits.motor_curve.empty() || (holds_torque && scene.drive && scene.drive->viscous > 0.0))
        return false;
    if (limits_loads_beside_contact_force(scene) || !contact_tightens_with_speed(scene)) return false;
    for (const PeakLimitRow& row : peak_limit_rows())  // of one side: an interval around 0 only shrinks
        if (const auto& limit = row.in(scene.limits);
            limit && limit->in_time() && row.side * limit->normalised < 0.0)
            return false;
    return !has_points_in_time(scene.motion);
}

bool has_points_in_time(const MotionSpec& motion) {
    for (const Corridor& corridor : motion.corridors)
        for (const Corridor::Bounds& bounds : corridor.bounds)
            if (is_unit_of_time(bounds.unit)) return true;
    const auto any_in = [](const std::vector<SetPoint>& points) {
        return std::ranges::any_of(points, [](const SetPoint& point) { return counts_in_time(point); });
    };
    return counts_in_time(motion.start) || counts_in_time(motion.end) || any_in(motion.via) ||
           std::ranges::any_of(motion.segments, [&](const ProgramSegment& segment) {
               return counts_in_time(segment.end) || any_in(segment.via);
           });
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/delivered/limit_activity.hpp"

#include "scene/limit_table.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

double finite_size(double value) {
    return std::isfinite(value) ? std::abs(value) : 0.0;
}

/// Of the quantity itself, SI; 0 where limit and reached value are all there is to measure by.
double quantity_size(const Scene& scene, const CamReport* cam, const LimitRow& row) {
    using enum LimitRow::Size;
    if (row.needs_dynamics && scene.dynamics && row.size == one)  // the springs at the lift
        return scene.dynamics->preload + scene.dynamics->return_stiffness * scene.motion.lift;
    if (row.size == one) return 1.0;
    if (cam != nullptr && row.size == base_radius) return finite_size(cam->summary.base_radius);
    if (cam == nullptr || row.size != largest_force || !cam->summary.forces) return 0.0;
    const ForceSummary& forces = *cam->summary.forces;
    return std::max(finite_size(forces.largest_force.value), finite_size(forces.least_force.value));
}

}  // namespace

double limit_scale(const Scene& scene, const CamReport* cam, const ConstraintReport& report) {
    for (const OwnLimit& limit : scene.own_limits)
        if (limit.key() == report.key) return limit.scale();
    const double size = finite_size(report.limit);
    const LimitRow* const row = limit_named(report.name);
    const bool given = row != nullptr && row->in(scene.limits).has_value();
    const double own = given ? quantity_size(scene, cam, *row) / row->in(scene.limits)->unit_value : 0.0;
    return std::max(size, own > 0.0 ? own : finite_size(report.worst));
}

double limit_excess(const ConstraintReport& report) {
    return is_least_limit(report.name) ? report.limit - report.worst : report.worst - report.limit;
}

bool is_nowhere(const ConstraintReport& report) {
    return std::isinf(report.worst) && report.worst > 0.0 && is_least_limit(report.name);
}

void judge_activity(Solution& solution) {
    const CamReport* const cam = solution.cam ? &*solution.cam : nullptr;
    for (ConstraintReport& report : solution.constraints)
        report.active = limit_excess(report) >= -active_limit * limit_scale(solution.scene, cam, report);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/delivered/cam/cam_report.hpp"

#include "core/errors.hpp"
#include "core/infinity.hpp"
#include "core/units.hpp"
#include "scene/limit_table.hpp"
#include "studies/explain/smallest_of_any_motion.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

/// The key without its unit: "limits.pressure_angle_deg" → "pressure_angle".
std::string plain_name(const std::string& key) {
    const char* const name = limit_name_in(key);
    return name != nullptr ? name : key;
}

/// A limit and what was reached.
ConstraintReport limit_report(const WrittenLimit& limit, const CamExtreme& worst) {
    return {plain_name(limit.key),          limit.key,  limit.given(),
            worst.value / limit.unit_value, limit.unit, worst.at};
}

/// None where neither is there.
std::optional<CamExtreme> larger(const std::optional<CamExtreme>& one,
                                 const std::optional<CamExtreme>& other) {
    if (!one || !other) return one ? one : other;
    return one->value >= other->value ? one : other;
}

/// What the general limit on the pressure angle speaks of: all, or the stroke that has none of its own, and
/// always where the follower rests.
std::optional<CamExtreme> general_pressure_angle(const LimitSpec& limits, const CamSummary& summary) {
    const bool rise = limit_on(limits, LimitedFigure::rise_pressure_angle).has_value();
    const bool back = limit_on(limits, LimitedFigure::return_pressure_angle).has_value();
    if (!rise && !back) return summary.pressure_angle;
    if (rise && back) return summary.rest_pressure_angle;
    return larger(rise ? summary.return_pressure_angle : summary.rise_pressure_angle,
                  summary.rest_pressure_angle);
}

/// None where this cam has nothing it could be computed from.
std::optional<CamExtreme> figure_of(LimitedFigure figure, const LimitSpec& limits,
                                    const CamSummary& summary) {
    const CamExtreme nowhere{infinity, 0.0};  // a radius that the cam has nowhere
    const std::optional<ForceSummary>& forces = summary.forces;
    if (limit_row(figure).needs_forces && !forces) return std::nullopt;
    switch (figure) {
        case LimitedFigure::pressure_angle:
            return general_pressure_angle(limits, summary);
        case LimitedFigure::rise_pressure_angle:
            return larger(summary.rise_pressure_angle, summary.rest_pressure_angle);
        case LimitedFigure::return_pressure_angle:
            return larger(summary.return_pressure_angle, summary.rest_pressure_angle);
        case LimitedFigure::convex_radius:
            return summary.convex_radius.value_or(nowhere);
        case LimitedFigure::concave_radius:
            return summary.concave_radius.value_or(nowhere);
        case LimitedFigure::regularity:
            return summary.regularity;
        case LimitedFigure::contact_force:
            return forces->least_force;
        case LimitedFigure::torque:
            return forces->torque;
        case LimitedFigure::hertz_pressure:
            return forces->hertz_pressure;
        case LimitedFigure::residual:
        case LimitedFigure::dynamic_contact_force:
            break;  // of the train, not of the cam
    }
    return std::nullopt;
}

/// The side on which a figure is as it is; empty where it is not of one side, or the same on both.
std::string side_of(LimitedFigure figure, const CamExtreme& worst, const CamSummary& summary) {
    const auto on = [&](const SideSummary& side) -> std::optional<CamExtreme> {
        switch (figure) {
            case LimitedFigure::pressure_angle:
            case LimitedFigure::rise_pressure_angle:
            case LimitedFigure::return_pressure_angle:
                return side.pressure_angle;
            case LimitedFigure::convex_radius:
                return side.convex_radius;
            case LimitedFigure::concave_radius:
                return side.concave_radius;
            case LimitedFigure::regularity:
                return side.regularity;
            case LimitedFigure::hertz_pressure:
                return side.hertz_pressure;
            case LimitedFigure::contact_force:
            case LimitedFigure::torque:
            case LimitedFigure::residual:
            case LimitedFigure::dynamic_contact_force:
                break;
        }
        return std::nullopt;
    };
    std::string name;
    for (const SideSummary& side : summary.sides) {
        const std::optional<CamExtreme> own = on(side);
        if (!own || own->value != worst.value) continue;
        if (!name.empty()) return {};
        name = side.name;
    }
    return name;
}

/// The limits that need forces, or those that do not.
void add_constraints(std::vector<ConstraintReport>& all, const Scene& scene, const CamSummary& summary,
                     bool of_forces) {
    for (const LimitRow& row : limit_rows()) {
        const auto& limit = row.in(scene.limits);
        if (!limit || row.needs_forces != of_forces) continue;
        const std::optional<CamExtreme> worst = figure_of(row.figure, scene.limits, summary);
        if (!worst) continue;
        all.push_back(limit_report(*limit, *worst));
        all.back().side = side_of(row.figure, *worst, summary);
        if (row.needs_contact && summary.no_contact) all.back().worst = infinity;
        all.back().no_contact = summary.no_contact && std::isinf(all.back().worst) && !row.may_be_infinite;
    }
}

}  // namespace

CamReport cam_report(const Scene& scene, std::vector<double> dimensions, const Motion& motion) {
    CamReport report;
    report.cam = {scene.cam.value().formulas(), std::move(dimensions)};
    report.summary = cam_summary(report.cam, motion, scene);
    report.smallest = smallest_of_any_motion(scene, report.cam);
    return report;
}

std::vector<ConstraintReport> cam_constraints(const Scene& scene, const CamReport& report) {
    const CamSummary& summary = report.summary;
    std::vector<ConstraintReport> all;
    add_constraints(all, scene, summary, false);
    if (scene.cam && scene.cam->face_half_width && summary.contact_offset) {
        const std::string unit = name_of(scene.length_unit);
        const WrittenLimit width{*scene.cam->face_half_width, "cam.face_half_width_" + unit,
                                 metres_of(scene.length_unit), unit};
        all.push_back(limit_report(width, *summary.contact_offset));
        all.back().name = "face_half_width";
        all.back().no_contact = summary.no_contact && std::isinf(all.back().worst);
    }
    add_constraints(all, scene, summary, true);
    return all;
}

}  // namespace camopt

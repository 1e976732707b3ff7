// SPDX-License-Identifier: MIT
#include "studies/delivered/cam_report.hpp"

#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"
#include "core/units.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"

#include <cmath>
#include <cstddef>

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

/// The side that reaches the extreme of the whole cam; empty where the limit is not of one side, or both do.
std::string side_of(std::size_t figure, const CamExtreme& worst, const CamSummary& summary) {
    std::string name;
    for (const SideSummary& side : summary.sides) {
        const std::optional<CamExtreme>& own = side.limited[figure];
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
        const auto figure = static_cast<std::size_t>(row.figure);
        const std::optional<CamExtreme>& worst = summary.limited[figure];
        if (!worst) continue;
        all.push_back(limit_report(*limit, *worst));
        all.back().side = side_of(figure, *worst, summary);
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

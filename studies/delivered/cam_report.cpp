// SPDX-License-Identifier: MIT
#include "studies/delivered/cam_report.hpp"

#include "scene/limit_table.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"

#include <fmt/format.h>

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

/// The side that reaches the extreme of the whole cam; empty
/// where the limit is not of one side, or both do.
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

/// The speed, other than that of the scene, at which a load is worst.
std::string speed_of(const LimitRow& limit, const CamExtreme& worst, const CamSummary& summary) {
    if (!limit.needs_forces) return {};
    for (const auto& [speed, loads] : summary.other_loads)
        for (const std::optional<CamExtreme>& own :
             {std::optional(loads.least_force), std::optional(loads.largest_force),
              std::optional(loads.torque), loads.hertz_pressure})
            if (own && own->value == worst.value) return speed;
    return {};
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
        all.back().speed = speed_of(row, *worst, summary);
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
        const Spelling spelling = scene.length_spelling_of(scene.cam->face_key());
        const WrittenLimit width{*scene.cam->face_half_width,
                                 fmt::format("{}{}", scene.cam->face_key(), spelling.suffix), spelling.factor,
                                 std::string(spelling.unit)};
        all.push_back(limit_report(width, *summary.contact_offset));
        all.back().name = "face_half_width";
        all.back().no_contact = summary.no_contact && std::isinf(all.back().worst);
    }
    add_constraints(all, scene, summary, true);
    return all;
}

}  // namespace camopt

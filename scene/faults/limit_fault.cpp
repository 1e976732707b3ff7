// SPDX-License-Identifier: MIT
// Limits that need a speed, a cam or forces, and those that a follower cannot have.
#include "scene/cam_mechanism.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <string>

namespace camopt {
namespace {

Fault time_fault(const Scene& scene) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits); limit && limit->in_time() && !scene.motion.speed)
            return SceneFault{fmt::format("limits.{}", row.name()),
                              fmt::format("a limit in {} without a speed", limit->unit),
                              "a limit in time only where motion.speed is given"};
    return std::nullopt;
}

Fault missing_table_fault(const Scene& scene) {
    for (const LimitRow& row : limit_rows()) {
        if (!row.in(scene.limits)) continue;
        const std::string member = fmt::format("limits.{}", row.name);
        if (row.needs_dynamics) continue;  // dynamics_fault.cpp
        if (!scene.cam)
            return SceneFault{member, "a limit of a cam without a cam", "only together with a [cam] table"};
        if (row.needs_forces && !scene.forces)
            return SceneFault{member, "a limit of a force without forces",
                              "only together with a [forces] table"};
    }
    return std::nullopt;
}

/// The cam is there.
Fault follower_fault(const Scene& scene) {
    const CamSpec& cam = *scene.cam;
    const auto formulas = cam.formulas();
    const ContactKind contact = formulas->contact();
    for (const LimitRow& row : limit_rows()) {
        if (!row.in(scene.limits)) continue;
        const std::string member = fmt::format("limits.{}", row.name);
        if (row.refusal.contact == contact)
            return SceneFault{
                member, fmt::format("{} for the follower \"{}\"", row.refusal.found, cam.choice("follower")),
                row.refusal.allowed};
        if (row.figure == LimitedFigure::contact_force && formulas->drives_both_ways())
            return SceneFault{
                member, fmt::format("a least contact force for a cam of form \"{}\"", cam.choice("form")),
                "only with cam.form = \"open\": this cam drives both ways"};
        if (row.needs_contact_width && !scene.forces->contact_width)
            return SceneFault{member, "a pressure without a contact width",
                              "only where forces.contact_width is given"};
    }
    return std::nullopt;
}

}  // namespace

Fault limit_fault(const Scene& scene) {
    if (Fault fault = time_fault(scene)) return fault;
    if (Fault fault = missing_table_fault(scene)) return fault;
    return scene.cam ? follower_fault(scene) : std::nullopt;
}

}  // namespace camopt

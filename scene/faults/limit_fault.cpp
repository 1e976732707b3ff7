// SPDX-License-Identifier: MIT
// Limits that need a speed, a cam or forces, and those that a follower cannot have.
#include "scene/cam_mechanism.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"
#include "scene/unit_fault.hpp"

#include <fmt/format.h>

#include <set>

namespace camopt {
namespace {

Fault limit_unit_fault(const Scene& scene) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits)) {
            if (row.of_cam && !scene.prescribes_output())
                return SceneFault{fmt::format("limits.{}", row.key_name),
                                  "a limit of the cam's own motion, which is the motion",
                                  "only together with dynamics.prescribe = \"output\""};
            const std::array names = {KeyNames{row.key_name, row.spellings}};
            if (Fault fault =
                    unit_fault(fmt::format("limits.{}", row.name()), limit->unit, scene.motion, names))
                return fault;
        }
    return std::nullopt;
}

Fault missing_table_fault(const Scene& scene) {
    for (const LimitRow& row : limit_rows()) {
        if (!row.in(scene.limits)) continue;
        const std::string member = fmt::format("limits.{}", row.name);
        if (!row.of_cam()) continue;  // dynamics_fault.cpp, drive_fault.cpp
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
        if (row.figure == LimitedFigure::contact_force && formulas->carries_load() && formulas->sides() > 1)
            return SceneFault{
                member,
                fmt::format("a least contact force for a cam of {}",
                            formulas->direct() != nullptr ? fmt::format("form \"{}\"", cam.choice("form"))
                                                          : fmt::format("type \"{}\"", cam.type)),
                "only with cam.form = \"open\": this cam drives both ways"};
        if (row.needs_contact_width && !scene.forces->contact_width)
            return SceneFault{member, "a pressure without a contact width",
                              "only where forces.contact_width is given"};
    }
    return std::nullopt;
}

constexpr int most_at_once = 50;  // each is some ten rows of all entries

/// There are forces, and with them a speed.
Fault spring_fault(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    if (!(scene.forces->spring_rate > 0.0))
        return SceneFault{"forces.spring_frequency", "a natural frequency without a spring",
                          "only where forces.spring_rate is above 0"};
    const bool returns = motion.type == MotionType::rr && !motion.start && !motion.end;
    if (!returns && !(motion.type == MotionType::program && motion.closed && !motion.relative))
        return SceneFault{"forces.spring_frequency",
                          "a natural frequency with a motion that is no closed revolution",
                          "motion type \"RR\" from rest to rest, or a closed program"};
    if (scene.nearest_harmonic() <= most_harmonic) return std::nullopt;
    return SceneFault{"forces.spring_frequency", "a natural frequency far above the speed of the cam",
                      fmt::format("at most {} times the speed", most_harmonic)};
}

Fault harmonic_fault(const Scene& scene) {
    const std::optional<WrittenLimit>& limit = scene.limits.spring_harmonic;
    if (scene.forces && scene.forces->spring_frequency) {
        if (Fault fault = spring_fault(scene)) return fault;
    } else if (limit) {
        return SceneFault{"limits.spring_harmonic", "a limit on harmonics without a natural frequency",
                          "only where forces.spring_frequency is given"};
    }
    const auto [first, last] = scene.limits.spring_harmonics;
    const bool given = first != 0 || last != 0;
    if (given && (first < 1 || last < first || last > most_harmonic || last - first >= most_at_once))
        return SceneFault{"limits.spring_harmonics", fmt::format("harmonics from {} to {}", first, last),
                          fmt::format("at most {} harmonics from 1 to {}", most_at_once, most_harmonic)};
    return limit ? limit_unit_fault(scene, LimitedFigure::spring_harmonic) : std::nullopt;
}

}  // namespace

Fault limit_fault(const Scene& scene) {
    if (Fault fault = limit_unit_fault(scene)) return fault;
    if (Fault fault = missing_table_fault(scene)) return fault;
    if (Fault fault = harmonic_fault(scene)) return fault;
    return scene.cam ? follower_fault(scene) : std::nullopt;
}

namespace {

/// Common to terms and limits.
template <class Rule>
Fault own_rule_fault(const Rule& rule, const std::string& member, std::set<std::string>& names) {
    if (!is_plain_name(rule.name))
        return SceneFault{member + ".name", fmt::format("\"{}\"", rule.name),
                          "a name of lower case letters, digits and _"};
    if (!names.insert(rule.name).second)
        return SceneFault{member + ".name", fmt::format("\"{}\" twice", rule.name), "each name once"};
    if (!rule.formula) return SceneFault{member + ".formula", "none", "a function"};
    if (rule.highest_order < 0 || rule.highest_order > 3)
        return SceneFault{member + ".highest_order", fmt::to_string(rule.highest_order),
                          "an integer from 0 to 3"};
    return std::nullopt;
}

Fault positive_fault(const std::string& member, double value) {
    if (std::isfinite(value) && value > 0.0) return std::nullopt;
    return SceneFault{member, fmt::format("{}", value), "a number > 0"};
}

}  // namespace

Fault limit_unit_fault(const Scene& scene, LimitedFigure figure) {
    const LimitRow& row = limit_row(figure);
    const std::array names = {KeyNames{row.name, row.spellings}};
    const std::optional<WrittenLimit>& limit = row.in(scene.limits);
    return limit ? unit_fault(joined_key("limits", row.name), limit->unit, scene.motion, names)
                 : std::nullopt;
}

Fault own_rules_fault(const Scene& scene) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.own_terms.size(); ++i) {
        const OwnTerm& term = scene.own_terms[i];
        const std::string member = entry_key("own_terms", i);
        if (Fault fault = own_rule_fault(term, member, names)) return fault;
        if (Fault fault = positive_fault(member + ".weight", term.weight)) return fault;
        if (Fault fault = positive_fault(member + ".reference", term.reference)) return fault;
    }
    names.clear();
    for (std::size_t i = 0; i < scene.own_limits.size(); ++i) {
        const OwnLimit& limit = scene.own_limits[i];
        const std::string member = entry_key("own_limits", i);
        if (Fault fault = own_rule_fault(limit, member, names)) return fault;
        if (!std::isfinite(limit.limit))
            return SceneFault{member + ".limit", fmt::format("{}", limit.limit), "a finite number"};
        if (!std::isfinite(limit.size) || limit.size < 0.0)
            return SceneFault{member + ".size", fmt::format("{}", limit.size), "a number >= 0"};
    }
    return std::nullopt;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "shop/sheet/form_notes.hpp"

#include "core/text/list_text.hpp"
#include "report/view/key_words.hpp"
#include "scene/limit_table.hpp"
#include "shop/sheet/sheet.hpp"

#include <fmt/format.h>

namespace camopt {

std::string follower_note(const ProfileShape& shape, LengthUnit lengths) {
    const DirectCamDrawing& drawn = shape.direct.value();
    std::string text = "Follower: " + words_of(drawn.follower);
    const std::vector<NamedDimension>& all = drawn.dimensions;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].of_form && static_cast<int>(i) != shape.formulas().base_radius_index())
            text += fmt::format(
                ", {} {}", words_of(all[i].name),
                all[i].is_angle ? degrees_shown.text(all[i].value) : drawn_length(all[i].value, lengths));
    return text + ".";
}

void add_form_notes(std::vector<std::string>& notes, const Solution& solution, bool both_disks) {
    std::string limits;
    for (const LimitRow& row : limit_rows())
        if (const auto& limit = row.in(solution.scene.limits);
            limit && !row.needs_forces && !row.needs_dynamics)
            append_item(limits, fmt::format("{} {} {}{}", key_words(fmt::format("limits.{}", row.name)).words,
                                            row.is_least() ? "≥" : "≤", short_text(limit->given()),
                                            limit->unit.empty() ? "" : " " + limit->unit));
    if (!limits.empty()) notes.push_back("Limits of form: " + limits + ".");
    const CamSummary& summary = solution.cam->summary;
    const LengthUnit unit = solution.scene.length_unit;
    std::string radii;
    if (summary.convex_radius)
        radii = fmt::format("convex {}", drawn_length(summary.convex_radius->value, unit));
    if (summary.concave_radius)
        append_item(radii, "concave " + drawn_length(summary.concave_radius->value, unit));
    if (!radii.empty())
        notes.push_back(
            fmt::format("Least radii of curvature{}: {}.", both_disks ? " of both disks" : "", radii));
}

void add_tolerance_note(std::vector<std::string>& notes, const Scene& scene) {
    if (!scene.tolerance) return;
    const auto& [profile, slope, acceleration] = scene.tolerance->motion;
    const bool turns = scene.motion.lift_is_angle;
    const double unit = turns ? units::degree : metres_of(scene.length_unit);
    const char* const name = turns ? "deg" : name_of(scene.length_unit);
    std::string words;
    if (profile)
        append_item(words,
                    fmt::format("the follower's displacement within ±{:.4g} {}", *profile / unit, name));
    if (slope)
        append_item(words,
                    fmt::format("its slope within ±{:.4g} {}/deg", *slope / unit * units::degree, name));
    if (!words.empty()) notes.push_back(fmt::format("Profile: {}.", words));
}

}  // namespace camopt

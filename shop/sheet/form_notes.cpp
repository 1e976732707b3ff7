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

namespace {

/// A tolerance of the output's displacement, or of a dimension, as the drawing shows numbers.
struct ShownTolerance {
    double unit = 1.0;
    const char* name = "mm";

    [[nodiscard]] std::string text(double size) const { return fmt::format("±{:.4g} {}", size / unit, name); }
};

ShownTolerance shown(bool angle, LengthUnit lengths) {
    if (angle) return {units::degree, "deg"};
    return {metres_of(lengths), name_of(lengths)};
}

std::string profile_note(const Scene& scene) {
    const auto& [profile, slope, acceleration] = scene.tolerance.value().motion;
    const ShownTolerance shape = shown(scene.motion.lift_is_angle, scene.length_unit);
    std::string words;
    if (profile) append_item(words, "the follower's displacement within " + shape.text(*profile));
    if (slope) append_item(words, fmt::format("its slope within {}/deg", shape.text(*slope * units::degree)));
    if (acceleration)
        append_item(words, fmt::format("its second derivative within {}/deg²",
                                       shape.text(*acceleration * units::degree * units::degree)));
    return words.empty() ? words : fmt::format("Profile: {}.", words);
}

/// What the limits were held for.
std::string numbers_note(const Scene& scene) {
    std::string words;
    const CamSpec& cam = scene.cam.value();
    for (const auto& [name, tolerance] : scene.tolerance.value().numbers) {
        const int own = cam.written_as(name);
        if (own < 0 || tolerance.percent) continue;
        const bool angle = cam.dimensions[static_cast<std::size_t>(own)].is_angle;
        append_item(words, fmt::format("{} {}", words_of(name),
                                       shown(angle, scene.length_unit).text(tolerance.size)));
    }
    return words.empty() ? words : fmt::format("Limits hold for {}.", words);
}

}  // namespace

void add_tolerance_notes(std::vector<std::string>& notes, const Scene& scene) {
    if (!scene.tolerance) return;
    for (std::string note : {profile_note(scene), numbers_note(scene)})
        if (!note.empty()) notes.push_back(std::move(note));
}

std::string profile_band(const Scene& scene) {
    if (!scene.tolerance || !scene.tolerance->motion[0]) return {};
    return shown(scene.motion.lift_is_angle, scene.length_unit).text(*scene.tolerance->motion[0]) +
           " of the follower";
}

}  // namespace camopt

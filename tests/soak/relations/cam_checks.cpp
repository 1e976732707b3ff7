// SPDX-License-Identifier: MIT
// Checks of the delivered cam: its figures and limits from its geometry.
#include "tests/soak/figures/cam_extremes.hpp"
#include "tests/soak/relations/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace camopt::soak {

namespace {

constexpr double none = -std::numeric_limits<double>::infinity();
constexpr double figure_digits = 1e-6;
/// What a limit may be passed by, relative to its own scale: solver.tolerance is 1e-9 to 1e-7 in the trials.
constexpr double limit_digits = 1e-6;
/// Slower than this part of the fastest counts as standing still.
constexpr double standstill = 1e-7;

using Published = std::map<std::string, double>;

/// One figure: its published name, the unit it is published in, its own value.
struct Figure {
    std::string name;
    double unit = 1.0, value = 0.0, scale = 1.0;
};

double pressure(const CamPoint& point) {
    return point.pressure_angle;
}

/// Where the face turns back the formula passes through infinity: how far it turns stands for it.
double regular(const CamPoint& point) {
    return point.turning <= 0.0 ? point.turning : point.regularity;
}

std::vector<Figure> figures_of(const Cam& cam, const CamSurvey& survey) {
    constexpr double degree = std::numbers::pi / 180.0;
    const bool flat = cam.follower.ends_with("flat");
    const double turning = survey.least([](const CamPoint& p) { return p.turning; });
    const double least =
        turning <= 0.0 ? turning : survey.least([](const CamPoint& p) { return p.regularity; });
    std::vector<Figure> all;
    if (cam.follower != "translating_flat")
        all.push_back({"pressure_angle_deg", degree, survey.largest(pressure), 0.1});
    all.push_back({"regularity", 1.0, least, 1.0});
    if (flat) {
        all.push_back(
            {"contact_offset_mm", 1e-3,
             turning <= 0.0 ? HUGE_VAL : survey.largest([](const CamPoint& p) { return p.contact_offset; }),
             cam.base});
    } else {
        const double sharp = survey.largest([](const CamPoint& p) { return p.curvature; });
        if (sharp > 0.0) all.push_back({"convex_radius_mm", 1e-3, 1.0 / sharp - cam.roller, cam.base});
        const double hollow = survey.least([](const CamPoint& p) { return p.curvature; });
        // A hollow of 1e6 base radii is a straight line.
        if (hollow < -1e-6 / cam.base)
            all.push_back({"concave_radius_mm", 1e-3, cam.roller - 1.0 / hollow, cam.roller - 1.0 / hollow});
    }
    if (cam.forces.empty()) return all;
    const bool swings = cam.follower.starts_with("oscillating");
    const double largest = survey.largest([](const CamPoint& p) { return p.force; });
    const double smallest = survey.least([](const CamPoint& p) { return p.force; });
    const double scale = std::max(std::abs(largest), std::abs(smallest));
    all.push_back({swings ? "forces.least_moment_nm" : "forces.least_force_n", 1.0, smallest, scale});
    all.push_back({swings ? "forces.largest_moment_nm" : "forces.largest_force_n", 1.0, largest, scale});
    all.push_back({"forces.torque_nm", 1.0,
                   survey.largest([](const CamPoint& p) { return std::abs(p.torque); }),
                   scale * survey.fastest()});
    if (least > 1e-3 && cam.follower != "translating_knife" && cam.forces.contains("contact_width"))
        all.push_back({"forces.hertz_pressure_mpa", 1e6,
                       survey.largest([](const CamPoint& p) { return p.hertz; }), 1e6});
    return all;
}

std::optional<double> limit_of(const SceneNumbers& scene, const char* name) {
    const auto found = scene.limits.find(name);
    return found == scene.limits.end() ? std::nullopt : std::optional(found->second);
}

/// While rising its own limit or the general one, while returning likewise; at rest the strictest.
double pressure_passed(const SceneNumbers& scene, const CamSurvey& survey) {
    const auto general = limit_of(scene, "pressure_angle");
    const auto own_rise = limit_of(scene, "rise_pressure_angle");
    const auto own_back = limit_of(scene, "return_pressure_angle");
    const double rise = own_rise.value_or(general.value_or(10.0));
    const double back = own_back.value_or(general.value_or(10.0));
    const double rest = std::min({rise, back, general.value_or(10.0)});
    const double slow = standstill * survey.fastest();
    const auto amount = [&](const CamPoint& point) {
        const double limit = point.velocity > slow ? rise : point.velocity < -slow ? back : rest;
        return limit > 9.0 ? none : (point.pressure_angle - limit) / limit;
    };
    return survey.largest(amount);
}

void note_force_limits(const SceneNumbers& scene, const CamSurvey& survey, Miss& worst) {
    const auto force = [](const CamPoint& p) { return p.force; };
    if (const auto least = limit_of(scene, scene.swings ? "contact_moment_min" : "contact_force_min"))
        worst.note((*least - survey.least(force)) /
                       survey.largest([](const CamPoint& p) { return std::abs(p.force); }),
                   "contact force");
    if (const auto most = limit_of(scene, "torque_max"))
        worst.note(survey.largest([](const CamPoint& p) { return std::abs(p.torque); }) / *most - 1.0,
                   "torque");
    if (const auto most = limit_of(scene, "hertz_pressure_max")) {
        if (survey.least(regular) <= 0.0)
            worst.note(HUGE_VAL, "Hertz pressure (undercut)");
        else
            worst.note(survey.largest([](const CamPoint& p) { return p.hertz; }) / *most - 1.0,
                       "Hertz pressure");
    }
}

void note_shape_limits(const SceneNumbers& scene, const Cam& cam, const CamSurvey& survey, Miss& worst) {
    const bool pressed = limit_of(scene, "pressure_angle") || limit_of(scene, "rise_pressure_angle") ||
                         limit_of(scene, "return_pressure_angle");
    if (pressed && scene.follower != "translating_flat")
        worst.note(pressure_passed(scene, survey), "pressure_angle");
    const double size = cam.base + cam.roller;
    if (const auto least = limit_of(scene, "cam_radius_min")) {
        const double sharp = survey.largest([](const CamPoint& p) { return p.curvature; });
        const double radius = scene.is_flat() ? survey.least([](const CamPoint& p) { return p.cam_radius; })
                              : sharp > 0.0   ? 1.0 / sharp - cam.roller
                                              : HUGE_VAL;
        worst.note((*least - radius) / size, "cam_radius_min");
    }
    if (const auto least = limit_of(scene, "concave_radius_min")) {
        const double hollow = survey.least([](const CamPoint& p) { return p.curvature; });
        if (hollow < 0.0) worst.note((*least - cam.roller + 1.0 / hollow) / size, "concave_radius_min");
    }
    if (const auto margin = limit_of(scene, "undercut_margin");
        margin && scene.follower != "translating_knife")
        worst.note(*margin - survey.least(regular), "undercut_margin");
    if (scene.face_half_width)
        worst.note(
            survey.largest([](const CamPoint& p) { return p.contact_offset; }) / *scene.face_half_width - 1.0,
            "face_half_width");
}

void note_train_limits(const Solved& solved, Miss& worst) {
    const TrainFigures& train = solved.figures.train;
    if (const auto most = limit_of(solved.numbers, "residual"))
        worst.note(train.residual * solved.numbers.lift / *most - 1.0, "residual");
    if (const auto least = limit_of(solved.numbers, "dynamic_contact_force_min"))
        worst.note((*least - train.least_force) / solved.numbers.train->preload, "dynamic contact force");
}

}  // namespace

Finding check_cam_figures(const Solved& solved) {
    if (!solved.motion || solved.numbers.follower.empty()) return no_case;
    const Cam cam = cam_of(solved.numbers, solved.dimensions);
    if (std::isnan(cam.rest()))
        return fmt::format("the follower does not reach the cam of these dimensions ({})",
                           solved.outcome.verdict);
    const CamSurvey survey(*solved.motion, cam);
    for (const Figure& figure : figures_of(cam, survey)) {
        const auto published = solved.outcome.cam.find(figure.name);
        const double own = figure.value / figure.unit;
        if (published != solved.outcome.cam.end() && std::isinf(own))
            return fmt::format("{} {:.12g} published, infinite of the cam", figure.name, published->second);
        if (published == solved.outcome.cam.end()) {
            if (std::isinf(own) || std::isnan(own)) continue;
            return fmt::format("{} is missing, {:.9g} of the cam", figure.name, own);
        }
        const double scale = std::max(std::abs(figure.scale) / figure.unit, std::abs(own));
        if (!(std::abs(published->second - own) <= figure_digits * scale))
            return fmt::format("{} {:.12g} published, {:.12g} of the cam ({})", figure.name,
                               published->second, own, solved.outcome.verdict);
    }
    return holds;
}

Miss passed_follower_limits(const Solved& solved) {
    Miss worst;
    if (solved.numbers.train) note_train_limits(solved, worst);
    if (solved.numbers.follower.empty()) return worst;
    const Cam cam = cam_of(solved.numbers, solved.dimensions);
    const CamSurvey survey(*solved.motion, cam);
    note_force_limits(solved.numbers, survey, worst);
    note_shape_limits(solved.numbers, cam, survey, worst);
    return worst;
}

Finding check_cam_limits(const Solved& solved) {
    const bool follows = solved.numbers.train || !solved.numbers.follower.empty();
    if (!solved.motion || !follows || solved.outcome.verdict == "failed") return no_case;
    const Miss passed = passed_follower_limits(solved);
    if (passed.amount <= limit_digits) return holds;
    return fmt::format("{} passed by {:.3g} of its scale ({})", passed.what,
                       static_cast<double>(passed.amount), solved.outcome.verdict);
}

namespace {

/// What a reported limit is passed relative to; one that may be 0 needs a size of its own.
double scale_of_limit(const Solved& solved, const PublishedLimit& limit) {
    double size = limit.unit == "mm" ? 1e3 * solved.numbers.lift : 1e-3;
    // The figures themselves are compared with those of the cam by check_cam_figures.
    for (const auto& [of, figure] : {std::pair{"contact_force_min", "forces.largest_force_n"},
                                     std::pair{"contact_moment_min", "forces.largest_moment_nm"}}) {
        const auto largest = solved.outcome.cam.find(figure);
        if (limit.key.find(of) != std::string::npos && largest != solved.outcome.cam.end())
            size = std::abs(largest->second);
    }
    return std::max(std::abs(limit.limit), size);
}

}  // namespace

Finding check_reported_limits(const Solved& solved) {
    if (!solved.motion || solved.outcome.verdict == "failed") return no_case;
    if (const auto& missing = solved.outcome.limits_without_worst; !missing.empty())
        return fmt::format("{} has no worst value ({})", missing.front(), solved.outcome.verdict);
    for (const PublishedLimit& limit : solved.outcome.limits) {
        if (limit.name.empty() || limit.key.empty()) return std::string("a limit without a name or a key");
        const bool least = limit.key.find("_min") != std::string::npos ||
                           limit.key.find("undercut_margin") != std::string::npos;
        const double passed = (least ? limit.limit - limit.worst : limit.worst - limit.limit);
        const double scale = scale_of_limit(solved, limit);
        if (limit.unit == "in" || limit.unit == "m") continue;
        if (passed > 10 * limit_digits * scale)
            return fmt::format("{} is reported broken: {:.12g}, limit {:.12g} ({})", limit.key, limit.worst,
                               limit.limit, solved.outcome.verdict);
    }
    return solved.outcome.limits.empty() ? no_case : holds;
}

Finding check_dimensions(const Solved& solved) {
    if (!solved.motion || solved.numbers.follower.empty()) return no_case;
    for (const auto& [name, range] : solved.numbers.dimensions) {
        const auto found = solved.dimensions.find(name);
        if (found == solved.dimensions.end()) continue;
        const double slack = 1e-8 * std::max(std::abs(range.low), std::abs(range.high));
        if (found->second < range.low - slack || found->second > range.high + slack)
            return fmt::format("{} {:.12g} m outside {:.12g} to {:.12g}", name, found->second, range.low,
                               range.high);
    }
    return holds;
}

}  // namespace camopt::soak

// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_limits.hpp"

#include "objectives/rules/cam_limit_parts.hpp"
#include "scene/limit_table.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace cam_limit_parts {

namespace {

// A flat oscillating face turns back on itself where 1 + ψ' vanishes; it stays this far away.
constexpr double least_face_turn = 1e-3;

}  // namespace

void add_face_turn(Rules& rules, const Shared& cam, const std::string& key) {
    if (!has_turning_face(cam->cam.follower)) return;
    CamFormula formula = cam_formula(key, [](const DiskCam& own, const auto& state) {
        return shifted(scaled(velocity(state), -sense_of(own.rotation)), least_face_turn - 1.0);
    });
    formula.remark = "face turns back";
    formula.highest_order = 1;
    formula.linear = true;
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

void add_regularity(Rules& rules, const Shared& cam, const std::string& key, double margin) {
    if (has_edge(cam->cam.follower)) return;
    // Flat and translating: (base + s + s'')/base >= margin times base is linear in the base radius too.
    const bool linear = has_pushed_face(cam->cam.follower);
    if (linear) {
        const double base = cam->cam[DimensionIndex::base_radius];
        CamFormula formula = cam_formula(key, [base, margin](const DiskCam& own, const auto& state) {
            return sum(margin / base, dimension(own, state, DimensionIndex::base_radius), -1.0 / base,
                       quantity(own, state, Quantity::cam_radius));
        });
        formula.linear = true;
        rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
        return;
    }
    rules.push_back(std::make_shared<CamRule>(
        cam, cam_formula(key, [margin](const DiskCam& own, const auto& state) {
            return shifted(scaled(quantity(own, state, Quantity::regularity), -1.0), margin);
        })));
}

}  // namespace cam_limit_parts

namespace {

using namespace cam_limit_parts;

/// (r + shift) κ − 1: the convex radius stays above shift, the concave one above −shift.
void add_roller_radius(Rules& rules, const Shared& cam, const WrittenLimit& limit, double shift,
                       double scale) {
    CamFormula formula = cam_formula(limit.key, [shift](const DiskCam& own, const auto& state) {
        const auto curvature = quantity(own, state, Quantity::pitch_curvature);
        if (!has_roller(own.follower)) return shifted(scaled(curvature, shift), -1.0);
        const auto roller = dimension(own, state, DimensionIndex::roller_radius);
        return shifted(product(shifted(roller, shift), curvature), -1.0);
    });
    formula.scale = scale;
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

void add_roller_radii(Rules& rules, const Scene& scene, const Shared& cam) {
    const bool roller = has_roller(cam->cam.follower);
    const double nominal = roller ? cam->cam[DimensionIndex::roller_radius] : 0.0;
    if (const auto& limit = limit_on(scene.limits, LimitedFigure::convex_radius);
        limit && (roller || limit->value > 0.0)) {
        const double least = limit->value;
        const double scale = least > 0.0 ? std::max(least_scale, least / (nominal + least)) : 1.0;
        add_roller_radius(rules, cam, *limit, least, scale);
    }
    const auto& concave = limit_on(scene.limits, LimitedFigure::concave_radius);
    const bool may_bite =
        concave && (cam->is_variable(DimensionIndex::roller_radius) || concave->value > nominal);
    if (may_bite) {
        const double least = concave->value;
        const double scale = std::clamp(least / std::max(least - nominal, least_scale * least), 1.0, 1e3);
        add_roller_radius(rules, cam, *concave, -least, scale);
    }
}

void add_flat_radius(Rules& rules, const Scene& scene, const Shared& cam) {
    const auto& limit = limit_on(scene.limits, LimitedFigure::convex_radius);
    if (!limit) return;
    const double base = cam->cam[DimensionIndex::base_radius];
    const double least = limit->value;
    CamFormula formula = cam_formula(limit->key, [base, least](const DiskCam& own, const auto& state) {
        return scaled(shifted(quantity(own, state, Quantity::cam_radius), -least), -1.0 / base);
    });
    formula.linear = has_pushed_face(cam->cam.follower);
    formula.scale = least > 0.0 ? std::max(least_scale, least / base) : 1.0;
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

void add_face_width(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!scene.cam->face_half_width) return;
    const double width = *scene.cam->face_half_width;
    for (const int sign : {1, -1}) {
        CamFormula formula =
            cam_formula("cam.face_half_width", [sign, width](const DiskCam&, const auto& state) {
                return shifted(scaled(velocity(state), sign / width), -1.0);
            });
        formula.highest_order = 1;
        formula.linear = true;
        rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
    }
}

/// The limit that speaks of the shape of the cam's surface, if any: what keeps it makes contact possible.
const WrittenLimit* limit_of_contact(const Scene& scene) {
    const bool press = scene.forces && scene.motion.speed;
    for (const LimitedFigure figure : {LimitedFigure::convex_radius, LimitedFigure::regularity,
                                       LimitedFigure::hertz_pressure, LimitedFigure::torque}) {
        if (limit_row(figure).needs_forces && !press) continue;
        if (const auto& limit = limit_on(scene.limits, figure)) return &*limit;
    }
    return nullptr;
}

}  // namespace

Rules cam_limits(const Scene& scene, const CamVariables& variables) {
    const auto cam = std::make_shared<const DiskVariables>(variables);
    Rules rules;
    add_pressure(rules, scene, cam);
    if (has_flat_face(cam->cam.follower)) {
        add_flat_radius(rules, scene, cam);
    } else {
        add_roller_radii(rules, scene, cam);
    }
    if (const auto& limit = limit_on(scene.limits, LimitedFigure::regularity))
        add_regularity(rules, cam, limit->key, limit->value);
    if (const WrittenLimit* limit = limit_of_contact(scene)) add_face_turn(rules, cam, limit->key);
    add_face_width(rules, scene, cam);
    add_forces(rules, scene, cam);
    return rules;
}

}  // namespace camopt

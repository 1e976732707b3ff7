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

/// The surface lies this much farther from the roller's centre than its radius: half a groove's clearance.
double wider_by(const DiskCam& cam, int side) {
    return surface_offset(cam, side) - roller_radius_of(cam, side);
}

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

void add_regularity(Rules& rules, const Shared& cam, const WrittenLimit& limit, int side) {
    if (has_edge(cam->cam.follower)) return;
    const std::string& key = limit.key;
    const double margin = limit.value;
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
    CamFormula formula = cam_formula(key, [margin, side](const DiskCam& own, const auto& state) {
        return shifted(scaled(quantity(own, state, Quantity::regularity, side), -1.0), margin);
    });
    if (has_roller(cam->cam.follower)) {
        formula.over = [margin, side, wider = wider_by(cam->cam, side)](const DiskCam& own,
                                                                        const StateOver& state) {
            const RangeOver surface = shifted(roller_on(own, state, side), wider);
            return curvature_excess(own, state, surface, 1.0 - margin, side);
        };
    }
    add_on_side(rules, cam, std::move(formula), side);
}

}  // namespace cam_limit_parts

namespace {

using namespace cam_limit_parts;

/// What a radius of one side is held to.
struct RadiusShift {
    double shift = 0.0, scale = 1.0;
    int side = 0;
};

/// (R + shift) κ − 1 with the curvature of the side: the convex radius stays above shift, the concave one
/// above −shift. R: the roller's radius, in a groove half the clearance more.
void add_roller_radius(Rules& rules, const Shared& cam, const WrittenLimit& limit, const RadiusShift& held) {
    const double wider = wider_by(cam->cam, held.side);
    CamFormula formula = cam_formula(
        limit.key, [shift = held.shift, side = held.side, wider](const DiskCam& own, const auto& state) {
            const auto curvature = quantity(own, state, Quantity::pitch_curvature, side);
            if (!has_roller(own.follower)) return shifted(scaled(curvature, shift), -1.0);
            const auto roller = roller_on(own, state, side);
            return shifted(product(shifted(roller, shift + wider), curvature), -1.0);
        });
    formula.over = [shift = held.shift, side = held.side, wider](const DiskCam& own, const StateOver& state) {
        const RangeOver factor =
            has_roller(own.follower) ? shifted(roller_on(own, state, side), shift + wider) : RangeOver(shift);
        return curvature_excess(own, state, factor, 1.0, side);
    };
    formula.scale = held.scale;
    add_on_side(rules, cam, std::move(formula), held.side);
}

/// The roller of this side is a dimension that moves.
bool is_roller_variable(const DiskVariables& cam, int side) {
    const bool own = side == 1 && cam.cam.form.is_conjugate() && cam.cam.form.second_roller_radius;
    return !own && cam.is_variable(DimensionIndex::roller_radius);
}

void add_roller_radii(Rules& rules, const Scene& scene, const Shared& cam, int side) {
    const bool roller = has_roller(cam->cam.follower);
    const double nominal = roller ? surface_offset(cam->cam, side) : 0.0;
    if (const auto& limit = limit_on(scene.limits, LimitedFigure::convex_radius);
        limit && (roller || limit->value > 0.0)) {
        const double least = limit->value;
        const double scale = least > 0.0 ? std::max(least_scale, least / (nominal + least)) : 1.0;
        add_roller_radius(rules, cam, *limit, {least, scale, side});
    }
    const auto& concave = limit_on(scene.limits, LimitedFigure::concave_radius);
    const bool may_bite = concave && (is_roller_variable(*cam, side) || concave->value > nominal);
    if (may_bite) {
        const double least = concave->value;
        const double scale = std::clamp(least / std::max(least - nominal, least_scale * least), 1.0, 1e3);
        add_roller_radius(rules, cam, *concave, {-least, scale, side});
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
        formula.sign = sign;
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
        for (int side = 0; side < side_count(cam->cam); ++side) add_roller_radii(rules, scene, cam, side);
    }
    if (const auto& limit = limit_on(scene.limits, LimitedFigure::regularity))
        for (int side = 0; side < side_count(cam->cam); ++side) add_regularity(rules, cam, *limit, side);
    if (const WrittenLimit* limit = limit_of_contact(scene)) add_face_turn(rules, cam, limit->key);
    add_face_width(rules, scene, cam);
    add_forces(rules, scene, cam);
    return rules;
}

}  // namespace camopt

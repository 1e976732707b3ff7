// SPDX-License-Identifier: MIT
#include "objectives/cam_limits.hpp"

#include "objectives/cam_limit_parts.hpp"
#include "profiles/quantity_algebra.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using namespace cam_limit_parts;

// A flat oscillating face turns back on itself where 1 + ψ' vanishes; it stays this far away.
constexpr double least_face_turn = 1e-3;

void add_roller_radii(Rules& rules, const Scene& scene, const Shared& cam) {
    const bool roller = has_roller(cam->cam.follower);
    const auto radius_of = [roller](const DiskCam& own) {
        const double radius = roller ? own[DimensionIndex::roller_radius] : 0.0;
        return roller ? variable_quantity(radius, column_of(DimensionIndex::roller_radius))
                      : constant_quantity(0.0);
    };
    const double nominal = roller ? cam->cam[DimensionIndex::roller_radius] : 0.0;
    if (const auto& limit = scene.limits.cam_radius_min; limit && (roller || limit->value > 0.0)) {
        const double least = limit->value;
        const double scale = least > 0.0 ? std::max(least_scale, least / (nominal + least)) : 1.0;
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{limit->key,
                            [radius_of, least](const DiskCam& own, const FollowerState& state) {
                                return shifted(product(shifted(radius_of(own), least),
                                                       quantity(own, state, Quantity::pitch_curvature)),
                                               -1.0);
                            },
                            2,
                            false,
                            scale,
                            {}}));
    }
    const auto& concave = scene.limits.concave_radius_min;
    const bool may_bite =
        concave && (cam->is_variable(DimensionIndex::roller_radius) || concave->value > nominal);
    if (may_bite) {
        const double least = concave->value;
        const double scale = std::clamp(least / std::max(least - nominal, least_scale * least), 1.0, 1e3);
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{concave->key,
                            [radius_of, least](const DiskCam& own, const FollowerState& state) {
                                return shifted(product(shifted(radius_of(own), -least),
                                                       quantity(own, state, Quantity::pitch_curvature)),
                                               -1.0);
                            },
                            2,
                            false,
                            scale,
                            {}}));
    }
}

void add_flat_radius(Rules& rules, const Scene& scene, const Shared& cam) {
    const auto& limit = scene.limits.cam_radius_min;
    if (!limit) return;
    const double base = cam->cam[DimensionIndex::base_radius];
    const double least = limit->value;
    const bool translating = cam->cam.follower == FollowerType::translating_flat;
    const double scale = least > 0.0 ? std::max(least_scale, least / base) : 1.0;
    rules.push_back(std::make_shared<CamRule>(
        cam, CamFormula{limit->key,
                        [base, least](const DiskCam& own, const FollowerState& state) {
                            return scaled(shifted(quantity(own, state, Quantity::cam_radius), -least),
                                          -1.0 / base);
                        },
                        2,
                        translating,
                        scale,
                        {}}));
    if (translating) return;
    rules.push_back(std::make_shared<CamRule>(
        cam, CamFormula{limit->key + " (face turns back)",
                        [](const DiskCam& own, const FollowerState& state) {
                            const double sign = sense_of(own.rotation);
                            return shifted(scaled(variable_quantity(state.velocity, 1), -sign),
                                           least_face_turn - 1.0);
                        },
                        1,
                        true,
                        1.0,
                        {}}));
}

void add_margin(Rules& rules, const Scene& scene, const Shared& cam) {
    const auto& limit = scene.limits.undercut_margin;
    if (!limit || cam->cam.follower == FollowerType::translating_knife) return;
    // Flat and translating: (base + s + s'')/base >= margin times base is linear in the base radius too.
    if (cam->cam.follower == FollowerType::translating_flat) {
        const double base = cam->cam[DimensionIndex::base_radius];
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{limit->key,
                            [base, margin = limit->value](const DiskCam& own, const FollowerState& state) {
                                const QuantityValue own_base = variable_quantity(
                                    own[DimensionIndex::base_radius], column_of(DimensionIndex::base_radius));
                                return sum(margin / base, own_base, -1.0 / base,
                                           quantity(own, state, Quantity::cam_radius));
                            },
                            2,
                            true,
                            1.0,
                            {}}));
        return;
    }
    rules.push_back(std::make_shared<CamRule>(
        cam, CamFormula{limit->key,
                        [margin = limit->value](const DiskCam& own, const FollowerState& state) {
                            return shifted(scaled(quantity(own, state, Quantity::regularity), -1.0), margin);
                        },
                        2,
                        false,
                        1.0,
                        {}}));
}

void add_face_width(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!scene.cam->face_half_width) return;
    const double width = *scene.cam->face_half_width;
    for (const int sign : {1, -1}) {
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{"cam.face_half_width",
                            [sign, width](const DiskCam&, const FollowerState& state) {
                                return shifted(scaled(variable_quantity(state.velocity, 1), sign / width),
                                               -1.0);
                            },
                            1,
                            true,
                            1.0,
                            {}}));
    }
}

}  // namespace

Rules cam_limits(const Scene& scene, const Shared& cam) {
    Rules rules;
    add_pressure(rules, scene, cam);
    if (has_flat_face(cam->cam.follower)) {
        add_flat_radius(rules, scene, cam);
    } else {
        add_roller_radii(rules, scene, cam);
    }
    add_margin(rules, scene, cam);
    add_face_width(rules, scene, cam);
    add_forces(rules, scene, cam);
    return rules;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Scenes with a cam that the tests of studies/ share.
#pragma once

#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "scene/scene.hpp"

namespace camopt::testing_support {

inline WrittenLimit degrees(double value, const char* key) {
    return {value * units::degree, key, units::degree, "deg"};
}
inline WrittenLimit millimetres(double value, const char* key) {
    return {value * units::millimetre, key, units::millimetre, "mm"};
}

inline void paper_weights(Scene& scene) {
    scene.objective.velocity = scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    Reference& reference = scene.objective.reference;
    reference.numeric = true;
    reference.velocity = 1.76;
    reference.acceleration = 5.53;
    reference.jerk = 69.0;
}

/// docs/theory/pressure_angle.md: rise 60°, lift 20 mm, |φ| <= 30°, cubic, roller of 10 mm on the cam axis.
inline Scene pressure_angle_scene(double prime_radius_mm, int segments = 24) {
    Scene scene;
    scene.motion.lift = 20e-3;
    scene.motion.rise = 60.0 * units::degree;
    scene.spline.segments = segments;
    paper_weights(scene);
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, (prime_radius_mm - 10.0) * 1e-3);
    scene.cam->set(DimensionIndex::roller_radius, 10e-3);
    scene.limits.pressure_angle = degrees(30.0, "limits.pressure_angle_deg");
    return scene;
}

/// A flat-faced valve lift: rise and return of 70° each, lift 14 mm.
inline Scene flat_scene(double base_mm, double radius_mm) {
    Scene scene;
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 14e-3;
    scene.motion.rise = 70.0 * units::degree;
    scene.spline.segments = 24;
    paper_weights(scene);
    scene.cam = disk_spec({.follower = FollowerType::translating_flat});
    scene.cam->set(DimensionIndex::base_radius, base_mm * 1e-3);
    scene.limits.cam_radius_min = millimetres(radius_mm, "limits.cam_radius_min_mm");
    return scene;
}

}  // namespace camopt::testing_support

// SPDX-License-Identifier: MIT
#include "tests/soak/figures/cam_point.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace camopt::soak {

namespace {

using Complex = std::complex<double>;

/// What a force on the follower becomes: its lever along the normal and the radius that it presses on.
struct Contact {
    double lever = 1.0, radius = 0.0;
};

Contact roll(const Cam& cam, const std::array<double, 3>& state, CamPoint& point) {
    const Complex i(0, 1);
    const double at = cam.rest() + state[0];
    Complex center(cam.offset, at);
    Complex first = i;  // dC/ds
    Complex second = 0;
    if (cam.follower == "oscillating_roller") {
        const Complex arm = std::polar(cam.arm, std::numbers::pi - at);
        center = cam.center + arm;
        first = -i * arm;
        second = -arm;
    }
    const Complex along = first * state[1] - i * cam.sense * center;
    const Complex bend =
        second * state[1] * state[1] + first * state[2] - 2.0 * i * cam.sense * first * state[1] - center;
    const double speed = std::abs(along);
    const Complex normal = i * cam.sense * along / speed;
    const Complex turned = normal * std::conj(first);
    point.pressure_angle = std::abs(std::arg(turned));
    point.curvature = -cam.sense * (std::conj(along) * bend).imag() / (speed * speed * speed);
    point.cam_radius = 1.0 / point.curvature - cam.roller;
    point.regularity = 1.0 - cam.roller * point.curvature;
    return {turned.real(), cam.roller * point.regularity};
}

Contact push_face(const Cam& cam, const std::array<double, 3>& state, CamPoint& point) {
    point.cam_radius = cam.base + state[0] + state[2];
    point.curvature = 1.0 / point.cam_radius;
    point.regularity = point.cam_radius / cam.base;
    point.contact_offset = std::abs(state[1]);
    return {1.0, point.cam_radius};
}

Contact swing_face(const Cam& cam, const std::array<double, 3>& state, CamPoint& point) {
    const double psi = cam.rest() + state[0];
    const double p = cam.center * std::sin(psi) - cam.face;
    const double p1 = cam.center * std::cos(psi) * state[1];
    const double p2 =
        -cam.center * std::sin(psi) * state[1] * state[1] + cam.center * std::cos(psi) * state[2];
    const double a1 = -state[1] - cam.sense;  // of the normal's angle in the cam
    const double a2 = -state[2];
    point.cam_radius = p + (p2 * a1 - p1 * a2) / (a1 * a1 * a1);
    point.curvature = 1.0 / point.cam_radius;
    point.turning = 1.0 + cam.sense * state[1];
    point.regularity = point.turning * point.cam_radius / cam.base;
    const double lever = p1 / a1 + cam.center * std::cos(psi);  // from the pivot's foot to the contact
    point.contact_offset = std::abs(lever);
    // A contact behind the pivot is irregular; the angle is the one between the lines.
    point.pressure_angle = std::atan2(std::abs(cam.face), std::abs(lever));
    return {lever, point.cam_radius};
}

double entry(const std::map<std::string, double>& numbers, const char* name) {
    const auto found = numbers.find(name);
    return found == numbers.end() ? 0.0 : found->second;
}

}  // namespace

double Cam::rest() const {
    const double prime = base + roller;
    if (follower == "translating_flat") return base;
    if (follower == "oscillating_flat") return std::asin((base + face) / center);
    if (follower == "oscillating_roller")
        return std::acos((center * center + arm * arm - prime * prime) / (2 * center * arm));
    return std::sqrt(prime * prime - offset * offset);
}

Cam cam_of(const SceneNumbers& scene, const std::map<std::string, double>& dimensions) {
    Cam cam;
    cam.follower = scene.follower;
    cam.sense = scene.sense;
    cam.base = entry(dimensions, "base_radius");
    cam.roller = entry(dimensions, "roller_radius");
    cam.offset = entry(dimensions, "offset");
    cam.center = entry(dimensions, "center_distance");
    cam.arm = entry(dimensions, "arm_length");
    cam.face = entry(dimensions, "face_offset");
    cam.speed = scene.speed;
    cam.forces = scene.forces;
    return cam;
}

CamPoint cam_point(const Cam& cam, const std::array<double, 3>& state) {
    CamPoint point;
    point.velocity = state[1];
    const Contact contact = cam.follower == "translating_flat"   ? push_face(cam, state, point)
                            : cam.follower == "oscillating_flat" ? swing_face(cam, state, point)
                                                                 : roll(cam, state, point);
    if (cam.forces.empty()) return point;
    point.force = entry(cam.forces, "mass") * cam.speed * cam.speed * state[2] +
                  entry(cam.forces, "spring_rate") * state[0] + entry(cam.forces, "preload");
    point.torque = point.force * state[1];
    point.normal_force = point.force / contact.lever;
    const double width = entry(cam.forces, "contact_width");
    if (width <= 0.0) return point;
    const double square =
        point.normal_force / (entry(cam.forces, "compliance") * std::numbers::pi * width * contact.radius);
    point.hertz = contact.radius <= 0.0 ? std::numeric_limits<double>::infinity()
                  : square > 0.0        ? std::sqrt(square)
                                        : 0.0;
    return point;
}

}  // namespace camopt::soak

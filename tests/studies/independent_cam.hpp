// SPDX-License-Identifier: MIT
// What a disk cam does at one cam angle, from where the follower is alone: the path of the roller's centre as
// complex numbers, the face as the envelope of its lines. No formula of profiles/ is used.
#pragma once

#include "core/motion.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace camopt::testing_support {

struct CamContact {
    double pressure = 0.0;                          ///< |φ|
    double radius = 0.0;                            ///< of the cam, > 0 convex; meaningful where it touches
    double curvature = 0.0;                         ///< of the pitch curve (flat: of the cam)
    bool touches = true;                            ///< a regular cam under a follower that can be pushed
    double force = 0.0, torque = 0.0, hertz = 0.0;  ///< hertz: infinite where nothing touches
    double velocity = 0.0;                          ///< s'
};

class IndependentCam {
 public:
    IndependentCam(const Scene& scene, const DiskCam& cam) : scene_(scene), cam_(cam) {
        using enum DimensionIndex;
        const double prime = cam_[base_radius] + radius_of_roller();
        const double a = cam_[center_distance], l = cam_[arm_length];
        switch (cam_.follower) {
            case FollowerType::translating_flat:
                start_ = cam_[base_radius];
                break;
            case FollowerType::oscillating_roller:
                start_ = std::acos((a * a + l * l - prime * prime) / (2.0 * a * l));
                break;
            case FollowerType::oscillating_flat:
                start_ = std::asin((cam_[base_radius] + cam_[face_offset]) / a);
                break;
            default:
                start_ = std::sqrt(prime * prime - cam_[offset] * cam_[offset]);
        }
    }

    [[nodiscard]] CamContact at(const MotionPoint& point) const {
        const double unit = scene_.motion.unit_angle(), lift = scene_.motion.lift;
        const double s = lift * point.derivative[0], v = lift * point.derivative[1] / unit,
                     w = lift * point.derivative[2] / (unit * unit);
        CamContact contact = has_flat_face(cam_.follower) ? face({s, v, w}) : roller({s, v, w});
        contact.velocity = v;
        if (!scene_.forces || !scene_.motion.speed) return contact;
        const ForceSpec& forces = *scene_.forces;
        const double speed = *scene_.motion.speed;
        contact.force = forces.mass * speed * speed * w + forces.spring_rate * s + forces.preload;
        contact.torque = std::abs(contact.force * v);
        if (!forces.contact_width) return contact;
        const double relative = contact.touches ? 1.0 / contact.radius + own_curvature() : 0.0;
        const double elastic =
            (1.0 - forces.cam_poisson * forces.cam_poisson) / forces.cam_modulus +
            (1.0 - forces.follower_poisson * forces.follower_poisson) / forces.follower_modulus;
        const double squared =
            contact.force / lever_ * relative / (std::acos(-1.0) * *forces.contact_width * elastic);
        contact.hertz =
            !contact.touches ? std::numeric_limits<double>::infinity() : std::sqrt(std::max(0.0, squared));
        return contact;
    }

 private:
    using Complex = std::complex<double>;

    [[nodiscard]] double radius_of_roller() const {
        return has_roller(cam_.follower) ? cam_[DimensionIndex::roller_radius] : 0.0;
    }
    [[nodiscard]] double own_curvature() const {
        return has_roller(cam_.follower) ? 1.0 / radius_of_roller() : 0.0;
    }

    /// The centre's path seen from the cam, whose frame turns back by σθ; the follower pushes along `way`.
    [[nodiscard]] CamContact roller(const FollowerState& now) const {
        using enum DimensionIndex;
        const Complex i(0.0, 1.0);
        const double sense = sense_of(cam_.rotation);
        Complex at, first, second;  // by s
        if (is_oscillating(cam_.follower)) {
            // The arm points from the pivot at a to a − l e^{−iψ}.
            const Complex arm = -cam_[arm_length] * std::exp(-i * (start_ + now.s));
            at = cam_[center_distance] + arm;
            first = -i * arm;
            second = -arm;
        } else {
            at = Complex(cam_[offset], start_ + now.s);
            first = i;
        }
        const Complex turn = -i * sense;
        const Complex d1 = first * now.velocity + turn * at;
        const Complex d2 = first * now.acceleration + second * now.velocity * now.velocity +
                           2.0 * turn * first * now.velocity + turn * turn * at;
        const Complex normal = i * sense * d1 / std::abs(d1);
        CamContact contact;
        contact.curvature = -sense * (std::conj(d1) * d2).imag() / std::pow(std::abs(d1), 3);
        contact.radius = 1.0 / contact.curvature - radius_of_roller();
        const Complex way = first / std::abs(first);
        const double along = (std::conj(normal) * way).real(), across = (std::conj(normal) * way).imag();
        contact.pressure = std::abs(std::atan2(across, along));
        lever_ = along * std::abs(first);
        contact.touches = along > 0.0 && 1.0 - radius_of_roller() * contact.curvature > 0.0;
        return contact;
    }

    /// The face is a line at the distance p from the cam's centre, its normal at the angle α in the cam
    /// frame.
    [[nodiscard]] CamContact face(const FollowerState& now) const {
        using enum DimensionIndex;
        const double sense = sense_of(cam_.rotation);
        double p, p1, p2, a1, a2;  // by θ
        if (is_oscillating(cam_.follower)) {
            const double psi = start_ + now.s, a = cam_[center_distance];
            p = a * std::sin(psi) - cam_[face_offset];
            p1 = a * std::cos(psi) * now.velocity;
            p2 = a * std::cos(psi) * now.acceleration - a * std::sin(psi) * now.velocity * now.velocity;
            a1 = -now.velocity - sense;  // α = 90° − ψ − σθ
            a2 = -now.acceleration;
        } else {
            p = start_ + now.s;
            p1 = now.velocity;
            p2 = now.acceleration;
            a1 = -sense;
            a2 = 0.0;
        }
        const double by_angle = p1 / a1, bend = (p2 - by_angle * a2) / (a1 * a1);
        CamContact contact;
        contact.radius = p + bend;
        contact.curvature = 1.0 / contact.radius;
        lever_ = 1.0;
        bool turns = true;
        if (is_oscillating(cam_.follower)) {
            // From the pivot's foot on the face, towards the cam.
            const double a = cam_[center_distance], psi = start_ + now.s;
            lever_ = a * std::cos(psi) + by_angle;
            turns = a1 * -sense > 0.0;
            contact.pressure = std::abs(std::atan2(cam_[face_offset], lever_));
        }
        contact.touches = turns && contact.radius > 0.0 && lever_ > 0.0;
        return contact;
    }

    const Scene& scene_;
    DiskCam cam_;
    double start_ = 0.0;
    mutable double lever_ = 1.0;
};

/// The largest value of `excess(x, side)` on `samples` places a piece of the motion, refined about the worst.
template <class Excess>
[[nodiscard]] double densely_worst(const Motion& motion, int samples, const Excess& excess) {
    double worst = -std::numeric_limits<double>::infinity(), at = motion.begin();
    const auto see = [&](double x, Side side) {
        const double value = excess(motion.at(x, side));
        if (!(value <= worst)) {
            worst = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
            at = x;
        }
    };
    const double length = motion.end() - motion.begin();
    for (int k = 0; k < samples; ++k) see(motion.begin() + length * k / samples, Side::right);
    for (const double x : motion.breakpoints()) {
        see(x, Side::left);
        see(x, Side::right);
    }
    double reach = length / samples;
    for (int round = 0; round < 8; ++round, reach *= 0.1) {
        const double center = at;
        for (int k = -20; k <= 20; ++k)
            see(std::clamp(center + 0.05 * k * reach, motion.begin(), motion.end()), Side::right);
    }
    return worst;
}

}  // namespace camopt::testing_support

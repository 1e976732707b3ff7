// SPDX-License-Identifier: MIT
// The cam of a scene and what its follower carries. SI units and radians.
#pragma once

#include "scene/follower.hpp"

#include <array>
#include <optional>
#include <string>

namespace camopt {

enum class Rotation { counterclockwise, clockwise };

[[nodiscard]] const char* name_of(Rotation value);
/// σ: +1 counterclockwise, −1 clockwise.
[[nodiscard]] constexpr double sense_of(Rotation rotation) {
    return rotation == Rotation::counterclockwise ? 1.0 : -1.0;
}

/// How the cam holds its follower.
enum class CamForm {
    open,      ///< on one side: a force presses the follower on it
    grooved,   ///< its roller runs in a groove, between two flanks: the cam drives both ways
    conjugate  ///< two disks on one shaft, each with a roller of the one follower: the cam drives both ways
};

[[nodiscard]] const char* name_of(CamForm value);

/// The form of a disk cam and the numbers it needs; those that another form needs are left alone. m, rad.
struct FormSpec {
    CamForm type = CamForm::open;
    double groove_clearance = 0.0;      ///< groove: its width less the roller's diameter, half on either side
    std::optional<double> groove_wall;  ///< groove: of its outer wall where it is thinnest; roller radius
    double roller_distance = 0.0;       ///< conjugate, translating: between the rollers' axes along the lift
    double arm_angle = 0.0;             ///< conjugate, oscillating: between the arms, in (0, 2π)
    /// Of the second roller, conjugate; none: as those of the first.
    std::optional<double> second_roller_radius, second_offset, second_arm_length;

    [[nodiscard]] bool is_grooved() const { return type == CamForm::grooved; }
    [[nodiscard]] bool is_conjugate() const { return type == CamForm::conjugate; }
    /// The cam pulls the follower back too: no force has to press it on.
    [[nodiscard]] bool drives_both_ways() const { return type != CamForm::open; }
};

/// A dimension of the cam: a number, or a range in which the optimizer is free. m.
struct Dimension {
    double low = 0.0, high = 0.0;
    std::string key = {};  ///< as written, e.g. "cam.base_radius_mm"
    double unit = 1e-3;    ///< m in one unit of the key

    Dimension() = default;
    Dimension(double value) : low(value), high(value) {}  // NOLINT(google-explicit-constructor)
    Dimension(double from, double to) : low(from), high(to) {}
    [[nodiscard]] bool is_variable() const { return high > low; }
    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
};

/// A disk cam: cam centre at the origin, follower at the top (translating, lift along +y, axis at x = offset)
/// or with its pivot at (center_distance, 0) (oscillating). Prime radius = base radius + roller radius.
struct CamSpec {
    FollowerType follower = FollowerType::translating_roller;
    Rotation rotation = Rotation::counterclockwise;
    std::array<Dimension, dimension_count> dimensions{};  ///< those the follower has not are 0
    std::optional<double> face_half_width;                ///< translating flat face, m: |s'| <= it
    FormSpec form = {};                                   ///< rollers only: others are open

    [[nodiscard]] Dimension& operator[](DimensionIndex index) {
        return dimensions[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] const Dimension& operator[](DimensionIndex index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

/// What the follower carries. Translating: F = mass ω² s'' + spring_rate s + preload, in kg, N/m, N.
/// Oscillating: the moment M = mass ω² ψ'' + spring_rate (ψ − ψ₀) + preload, in kg m², N m/rad, N m.
/// F, M > 0 presses the follower on the cam. ω is the scene's speed.
struct ForceSpec {
    double mass = 0.0, spring_rate = 0.0, preload = 0.0;
    std::optional<double> contact_width;                   ///< m; with the moduli it gives the Hertz pressure
    double cam_modulus = 210e9, follower_modulus = 210e9;  ///< Pa
    double cam_poisson = 0.3, follower_poisson = 0.3;

    /// F (or M) at cam speed ω, for s and s'' by the cam angle.
    [[nodiscard]] double force(double speed, double s, double acceleration) const {
        return mass * speed * speed * acceleration + spring_rate * s + preload;
    }
    /// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, 1/Pa: with the width b and 1/R = 1/ρ_cam + 1/r the Hertz pressure
    /// of the normal force N is √(N E* / (π b R)).
    [[nodiscard]] double compliance() const {
        return (1.0 - cam_poisson * cam_poisson) / cam_modulus +
               (1.0 - follower_poisson * follower_poisson) / follower_modulus;
    }
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The cam of a scene, of any kind: its type, numbers and choices, and their formulas. A leaf of profiles/
// makes one of its kind (disk_spec, remote_spec, spatial_spec, inverse_spec); the reader of scene files makes
// any kind known to its program. SI units and radians.
#pragma once

#include "core/motion.hpp"
#include "core/text/list_text.hpp"
#include "core/unit.hpp"
#include "scene/follower.hpp"

#include <map>

namespace camopt {

class CamMechanism;

enum class Rotation { counterclockwise, clockwise };

[[nodiscard]] const char* name_of(Rotation value);
/// σ: +1 counterclockwise, −1 clockwise.
[[nodiscard]] constexpr double sense_of(Rotation rotation) {
    return rotation == Rotation::counterclockwise ? 1.0 : -1.0;
}

/// A dimension of the cam: a number, or a range for the optimizer. m, rad.
struct Dimension {
    double low = 0.0, high = 0.0;
    std::string key = {};             ///< as written, e.g. "cam.base_radius_mm"
    double unit = units::millimetre;  ///< SI value of one unit of the key

    Dimension() = default;
    Dimension(double value) : low(value), high(value) {}  // NOLINT(google-explicit-constructor)
    Dimension(double from, double to) : low(from), high(to) {}
    [[nodiscard]] bool is_variable() const { return high > low; }
    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
    friend bool operator==(const Dimension&, const Dimension&) = default;
};

struct CamDimension {
    std::string name;  ///< "base_radius", "coupler"
    Dimension value;   ///< without a key: this variant of the kind has no such dimension
    bool is_angle = false;
    /// Of a file in SI: "base_radius_m".
    [[nodiscard]] std::string si_key() const {
        return name + std::string((is_angle ? unit_named<"rad"> : unit_named<"m">).suffix);
    }
    friend bool operator==(const CamDimension&, const CamDimension&) = default;
};

/// A line, or with a centre an arc, of a cam that exists: a part of the path of the roller's centre, in the
/// cam's frame. It begins where the one before it ends. Two coordinates each, m; empty: not given.
struct CamPiece {
    std::vector<double> to = {}, center = {};
    std::vector<double> from = {};  ///< of the first: its begin; not given: where the last one ends
    friend bool operator==(const CamPiece&, const CamPiece&) = default;
};

struct CamSpec {
    std::string type;  ///< "disk", "remote", …: cam.type
    Rotation rotation = Rotation::counterclockwise;
    std::vector<CamDimension> dimensions;        ///< all of the kind, in its order; unused ones are 0
    std::map<std::string, std::string> choices;  ///< "linkage" → "lever", "form" → "grooved", …
    std::vector<CamPiece> pieces = {};           ///< of a cam that exists, in order; empty: it is designed
    std::optional<double> face_half_width;       ///< m, of a flat face that is pushed straight: |s'| <= it
    /// m, of a round flat face: half its chord beside the contact line is then face_half_width.
    std::optional<double> face_radius;
    /// The key, without its unit, that says how wide the face is.
    [[nodiscard]] const char* face_key() const {
        return face_radius ? "cam.face_radius" : "cam.face_half_width";
    }
    /// A round face with a line of contact of this length: it touches along a chord at
    /// |s'| <= √(radius² − (width / 2)²).
    void set_round_face(double radius, double contact_width) {
        face_radius = radius;
        face_half_width = std::sqrt(std::max(0.0, radius * radius - 0.25 * contact_width * contact_width));
    }
    /// Makes the formulas of this kind.
    std::function<std::shared_ptr<const CamMechanism>(const CamSpec& spec)> make = {};

    /// Of these choices and numbers, created by every call. Throws InputError without `make`, and for an
    /// unknown choice.
    [[nodiscard]] std::shared_ptr<const CamMechanism> formulas() const;
    /// Every dimension; of a range its middle.
    [[nodiscard]] std::vector<double> middle() const;
    /// Null if the cam has no such dimension.
    [[nodiscard]] const Dimension* find(std::string_view name) const;
    [[nodiscard]] const Dimension* find(DimensionIndex index) const { return find(name_of(index)); }
    /// The word chosen; empty: the kind has no such choice.
    [[nodiscard]] std::string choice(const std::string& name) const;
    /// A number or a range; without a key the current one remains. Throws InputError if the cam has no such
    /// dimension.
    void set(std::string_view name, const Dimension& value);
    void set(DimensionIndex index, const Dimension& value) { set(name_of(index), value); }
};

/// Throws InputError "linkage: found "…"; allowed: …".
[[noreturn]] void refuse_choice(const std::string& name, const std::string& found,
                                const std::string& allowed);

/// The one among `all`, an array, whose name_of is the word chosen under that name. Throws InputError if
/// there is none.
template <class Choices>
[[nodiscard]] auto chosen(const CamSpec& cam, const std::string& name, const Choices& all) {
    const std::string word = cam.choice(name);
    std::string allowed;
    for (const auto value : all) {
        if (word == name_of(value)) return value;
        append_item(allowed, in_quotes(name_of(value)));
    }
    refuse_choice(name, word, allowed);
}

/// The loads of a follower are linear in (ω², ω): over a range of speeds from a to b these lie in the
/// triangle of both ends and ((a b), (a + b)/2), where the tangents at the ends meet.
struct LoadSpeed {
    double square = 0.0, speed = 0.0;
    std::string words = {};  ///< "at 0 rpm"; empty: the speed of the scene
    bool is_speed = true;    ///< false: the third corner
};

/// The load of the follower. Translating: F = mass ω² s'' + damping ω s' + spring_rate s + preload +
/// load(θ), in kg, N s/m, N/m, N. Oscillating: the moment M of the same form for ψ − ψ₀, in kg m²,
/// N m s/rad, N m/rad, N m. F, M > 0 presses the follower on the cam. ω is the speed of
/// the scene.
struct ForceSpec {
    double mass = 0.0, spring_rate = 0.0, preload = 0.0;
    double damping = 0.0;  ///< >= 0, viscous
    /// What preload and spring rate are chosen from, SI: the optimizer's, with the motion. The numbers above
    /// are then the middle, of a solution what was chosen. None: fixed.
    std::optional<std::array<double, 2>> preload_range = {}, spring_rate_range = {};
    /// An outer force at cam angles counted from the start of the motion (rad; N or N m), ascending, linear
    /// between them; the last one passes on to the first of the next turn. One: constant. None: 0.
    std::vector<std::array<double, 2>> load = {};
    std::optional<double> contact_width;                   ///< m; with the moduli it gives the Hertz pressure
    double cam_modulus = 210e9, follower_modulus = 210e9;  ///< Pa
    double cam_poisson = 0.3, follower_poisson = 0.3;
    std::optional<double> spring_frequency = {};  ///< rad/s, > 0: natural, of the spring between fixed ends
    /// rad/s of the cam, the lower first: limits on loads hold at every speed between (Scene::load_speeds).
    std::optional<std::array<double, 2>> speed_range = {};

    /// The optimizer chooses a number of the spring.
    [[nodiscard]] bool is_chosen() const { return preload_range || spring_rate_range; }
    /// Of the ranges the numbers that were chosen remain.
    void fix() {
        preload_range.reset();
        spring_rate_range.reset();
    }
    /// The outer force at a cam angle, and its derivative by it: linear on the stretch that `side` sees.
    struct Load {
        double force = 0.0, slope = 0.0;
    };
    [[nodiscard]] Load load_at(double angle, Side side = Side::right) const;
    /// F (or M) at cam speed ω, for s, s', s'' by the cam angle at `angle`.
    [[nodiscard]] double force(double speed, const FollowerState& state, double angle,
                               Side side = Side::right) const {
        return mass * speed * speed * state.acceleration + damping * speed * state.velocity +
               spring_rate * state.s + preload + load_at(angle, side).force;
    }
    /// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, 1/Pa: with the width b and 1/R = 1/ρ_cam + 1/r the Hertz pressure
    /// of the normal force N is √(N E* / (π b R)).
    [[nodiscard]] double compliance() const {
        return (1.0 - cam_poisson * cam_poisson) / cam_modulus +
               (1.0 - follower_poisson * follower_poisson) / follower_modulus;
    }
    friend bool operator==(const ForceSpec&, const ForceSpec&) = default;
};

/// A number of ForceSpec that may be a range.
struct SpringNumber {
    const char* key;  ///< without its unit
    double ForceSpec::*number;
    std::optional<std::array<double, 2>> ForceSpec::*range;
};
inline constexpr std::array<SpringNumber, 2> spring_numbers = {{
    {"forces.preload", &ForceSpec::preload, &ForceSpec::preload_range},
    {"forces.spring_rate", &ForceSpec::spring_rate, &ForceSpec::spring_rate_range},
}};

// Data of a workshop drawing and a solid of a disk cam in addition to its profile, without effect on the
// motion. m and rad. Angles are cam angles: the ray of the cam that points along +y when the cam has turned
// by this angle from the start of the motion.

/// A parallel slot in the bore.
struct Keyway {
    double width = 0.0;  ///< m, > 0, below the bore's diameter
    double depth = 0.0;  ///< m, > 0: distance of its floor outside the bore's circle
    double at = 0.0;     ///< rad: its middle

    /// From the centre to the corners of its floor in a bore of this radius.
    [[nodiscard]] double reach(double bore_radius) const {
        return std::hypot(bore_radius + depth, 0.5 * width);
    }
    friend bool operator==(const Keyway&, const Keyway&) = default;
};

/// Text of the title block in addition to the scene's title; empty: none.
struct TitleBlock {
    std::string part = {}, material = {}, tolerance = {}, drawn_by = {};
    std::string number = {}, revision = {}, date = {}, organisation = {};
    std::string surface_finish = {}, profile_tolerance = {}, bore_fit = {}, keyway_tolerance = {};
    friend bool operator==(const TitleBlock&, const TitleBlock&) = default;
};

/// The method of projection that the symbol of the title block shows (ISO 5456-2).
enum class Projection { first_angle, third_angle };
[[nodiscard]] const char* name_of(Projection value);

struct DrawingSpec {
    std::optional<double> bore = {};          ///< m, diameter, > 0; none: the cam has no hole
    std::optional<Keyway> keyway = {};        ///< only in a bore
    std::optional<double> thickness = {};     ///< m, > 0
    std::optional<double> groove_depth = {};  ///< m, > 0: of a grooved cam; none: half the thickness
    double datum = 0.0;                       ///< rad: the mark of the cam; tables count from there
    TitleBlock title_block = {};
    Projection projection = Projection::first_angle;
    std::optional<double> density = {};  ///< kg/m³, > 0: with it the drawing gives the mass

    /// m: reach of bore and keyway from the centre; 0: there is no bore.
    [[nodiscard]] double reach() const {
        if (!bore) return 0.0;
        return keyway ? keyway->reach(0.5 * *bore) : 0.5 * *bore;
    }
    friend bool operator==(const DrawingSpec&, const DrawingSpec&) = default;
};

}  // namespace camopt

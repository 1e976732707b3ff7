// SPDX-License-Identifier: MIT
// Disk cams: one point of the follower's motion makes one point of the cam.
//
// Frames. The cam centre is the origin. In the fixed frame the cam turns by σθ about +z, with
// σ = +1 counterclockwise, −1 clockwise; θ >= 0 is the cam angle of the motion. Cam frame = Rot(−σθ) · fixed.
//   translating: follower axis x = offset e, lift along +y; roller centre C = (e, s0 + s),
//                s0 = sqrt((base + roller)² − e²); flat face: the line y = base + s.
//   oscillating: pivot A = (a, 0), ψ = ψ0 + s at the pivot from the line to the cam centre up to the arm;
//                roller centre C = (a − l cos ψ, l sin ψ), ψ0 from (base + roller)² = a² + l² − 2 a l cos ψ0;
//                flat face: the line of the arm, displaced by the face offset f towards the cam centre (away
//                from it where f < 0): base = a sin ψ0 − f.
// s, s', s'' are by the cam angle θ: m, m/rad, m/rad² (rad, 1, 1/rad for oscillating). All lengths m.
//
// With V = C' − σ z × C (velocity in the cam frame) the pitch curve has the outward normal
// n = σ (−V_y, V_x)/|V|, the curvature κ = −σ (V × V')/|V|³ (V' in the cam frame; positive where the cam is
// convex), and the cam lies at C − r n. A flat face is an envelope of lines: with p its distance from the cam
// centre and α the angle of its normal u in the cam frame, the contact is p u + p_α u⊥, the radius
// p + p_αα.
//
// Pressure angle φ = atan2(numerator, denominator), its sign that of the numerator:
//   translating roller: s' − σe over s0 + s           oscillating roller: l(1 + σψ') − a cos ψ over a sin ψ
//   translating flat:   0 over base + s               oscillating flat:   f(1 + σψ') over a cos ψ
// Source: J. Angeles, C. López-Cajún, Optimization of Cam Mechanisms (1991). Checked against envelopes made
// from follower positions alone (tests/profiles/envelope_test.cpp).
// A cam with a geometry_fault may give NaN; nothing here throws for it.
#pragma once

#include "profiles/disk/disk_cam_dimensions.hpp"
#include "profiles/disk/quantity_value.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt {

/// The origin of s: the follower's height s0 over the cam centre (m; of the roller centre, of a flat face),
/// or the arm's angle ψ0 (rad), on the base circle. NaN if the dimensions do not reach.
[[nodiscard]] double rest_position(const DiskCam& cam);
/// The same with its partials.
[[nodiscard]] QuantityValue rest_quantity(const DiskCam& cam);

/// Why this cam cannot be built at all (|offset| >= prime radius, arm that cannot reach, …); empty: it can.
/// `least`, `most`: the extremes of s.
[[nodiscard]] std::string geometry_fault(const DiskCam& cam, double least, double most);

struct ProfilePoint {
    double theta = 0.0;
    Eigen::Vector2d center, pitch;  ///< roller centre (flat: contact point) in the fixed and the cam frame
    Eigen::Vector2d contact;        ///< contact point in the cam frame: a point of the cam's surface
    Eigen::Vector2d normal;         ///< outward unit normal of the cam there, cam frame
    double pressure_angle = 0.0;    ///< signed, rad: between the normal and the follower's velocity
    double pitch_curvature = 0.0;   ///< 1/m, > 0 convex; flat: the cam's own
    /// Signed radius of curvature of the cam, m: > 0 convex, < 0 concave, infinite where straight. Past
    /// undercut (regularity < 0) the sign is that of the formula.
    double cam_radius = 0.0;
    /// Roller: 1 − r κ; knife: 1; flat: cam radius / base radius (its oscillating form times (1 + σψ')).
    /// <= 0: undercut.
    double regularity = 0.0;
    /// Contact offset of a flat face, m. Translating: x from the follower's axis, σ s'; oscillating: from the
    /// pivot's foot on the face towards the cam, a cos ψ / (1 + σψ').
    double contact_offset = 0.0;
};

[[nodiscard]] ProfilePoint profile_point(const DiskCam& cam, double theta, const FollowerState& state);

/// Throws ModelError if the follower has no such quantity. 0.1 to 2 µs.
[[nodiscard]] QuantityValue quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which);

// The sides of a disk cam: the surfaces that its follower touches. An open cam has one; a groove has two
// flanks, a conjugate cam a disk on either side of the follower.
//
// Side 0 is that of an open cam of the same dimensions: the inner flank, the first disk. A force F > 0 along
// the lift acts on it, F < 0 on side 1: the cam drives both ways, and no closing force is needed.
//
// Groove. Both flanks are offsets of the pitch curve by R = roller radius + clearance/2. The outer flank is
// the surface of material outside: with the pitch curve's curvature κ it has the pitch curvature −κ, so
//   outward normal −n (towards the roller),  radius −1/κ − R (concave where the pitch curve is convex),
//   regularity 1 + R κ,  and the roller of radius r lies on either flank with the combined radius
//   R_eff = r (1 − R κ_side)/(1 − (R − r) κ_side).
//
// Conjugate. The second roller is carried by the same follower. Translating: its centre at
// (e2, s0 + s − D), D between the rollers' axes; oscillating: its arm below the line of centres by ψ2 = γ −
// ψ, γ between the arms. In the mirror image about the x axis it is an open cam whose follower moves
// by −s: second_disk(). Its points here are mirrored back. The disks are fixed to one shaft.

[[nodiscard]] int side_count(const DiskCam& cam);
[[nodiscard]] int side_count(const FormSpec& form);
/// "inner flank", "second disk"; empty: there is only one.
[[nodiscard]] std::string side_name(const FormSpec& form, int side);
/// Of the roller on this side, m; 0 without a roller.
[[nodiscard]] double roller_radius_of(const DiskCam& cam, int side);
/// From the roller's centre to the surface: R above; m.
[[nodiscard]] double surface_offset(const DiskCam& cam, int side);

/// The second disk of a conjugate cam in the mirror image about the x axis, as an open cam: driven by −s,
/// −s', −s''. A base radius that is not positive, or NaN: there is none.
[[nodiscard]] DiskCam second_disk(const DiskCam& cam);
[[nodiscard]] FollowerState second_state(const FollowerState& state);
/// The second roller's distance (m) or angle (rad) along the follower's path at s = 0: D − s0, γ − ψ0.
[[nodiscard]] double second_rest_position(const DiskCam& cam);

[[nodiscard]] ProfilePoint profile_point(const DiskCam& cam, double theta, const FollowerState& state,
                                         int side);

/// As quantity(), of one side; partials by the variables of the whole
/// cam. The pressure angle of the second disk has the sign of its mirror image.
[[nodiscard]] QuantityValue quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which,
                                     int side);
[[nodiscard]] RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which,
                                  int side);

// The disk cam with any of its followers as a CamMechanism, for reports, checks and files. The optimizer uses
// the formulas above directly.
//
// Its dimensions are those of the follower, in the order of DimensionIndex, then the numbers of its form; a
// station is a side. m, rad.

/// CamSpec::make of a disk cam. Throws InputError for an unknown follower or form.
[[nodiscard]] std::shared_ptr<const CamMechanism> disk_formulas(const CamSpec& spec);

/// The cam of a scene: type "disk", the choices "follower" and "form", a key for every dimension, and the
/// formulas. Throws SceneError for a number that this follower or form does not have.
[[nodiscard]] CamSpec disk_spec(const DiskSpec& cam);

[[nodiscard]] DrivenMechanism disk_mechanism(const DiskCam& cam);

/// The disk cam of these formulas and numbers; none: they are of another kind.
[[nodiscard]] std::optional<DiskCam> disk_cam(const DrivenMechanism& mechanism);

// Enclosures of quantities of a disk cam over an interval of the cam angle, and over a box of motions and
// dimensions: of their values and derivatives, by the formulas above (disk_cam_formulas.hpp).

/// Slopes and second derivatives by the cam angle. Unbounded where the formula may divide by zero somewhere
/// in the interval. Throws ModelError if the follower has no such quantity.
[[nodiscard]] RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which);

/// s, s', s'' and the dimensions, each a number, a separate interval, or a function of the box's variables.
struct StateOver {
    RangeOver s, velocity, acceleration;
    std::array<RangeOver, dimension_count> dimensions;

    [[nodiscard]] const RangeOver& operator[](DimensionIndex index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

/// With first and second partials by the box's variables; unbounded results and errors as above. The
/// dimensions of `cam` do not matter.
[[nodiscard]] RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which);

/// As those above.
[[nodiscard]] RangeOver quantity(const DiskCam& cam, const StateOver& state, MechanismQuantity which,
                                 int side);
[[nodiscard]] RangeOver roller_on(const DiskCam& cam, const StateOver& state, int side);

/// (factor κ − share)(speed of the roller centre)³ over the coefficient of s'', of followers with a pitch
/// curve and with the curvature κ of a side: >= 0 where factor κ >= share, and linear in s''. Unbounded where
/// that coefficient may vanish.
[[nodiscard]] RangeOver curvature_excess(const DiskCam& cam, const StateOver& state, const RangeOver& factor,
                                         double share, int side);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Three-dimensional cams whose follower carries a cylindrical roller: the kinematics of the roller's axis.
//
// Frames. The cam's axis is z. In the fixed frame the cam turns by σθ about +z, with σ = +1
// counterclockwise, −1 clockwise; θ is the cam angle of the motion. Cam frame = Rot_z(−σθ) · fixed. The
// roller's axis is the line C(θ, h) = c(θ) + h e(θ), h >= 0 along the roller from its near end. Its place in
// the fixed frame follows from the follower's position q = start + s alone:
//   barrel                    (q = a, index radius r_i, l1, l2, l3; the index turns about y)
//     C = (r_i cos q − l1, l3 − h, −r_i sin q − l2),      e = (0, −1, 0)
//   cylindrical_rotating      (q = θ_f, follower length f_l, dx, dy, dz; the follower turns about x)
//     C = (dx, dy − (f_l + h) cos q, dz + (f_l + h) sin q), e = (0, −cos q, sin q)
//   cylindrical_translating   (the follower slides along z, q = s)
//     C = (dx, ρ0 − h, z0 + q),                            e = (0, −1, 0)
// With u the unit direction in which the axis travels (q' > 0), b = u × e, V = ∂C/∂θ in the cam frame,
// V_u = V·u, V_b = V·b and W² = V_u² + V_b², the roller touches the flank σ_f = ±1 at C + r n,
//   n = σ_f V × e / W = σ_f (V_u b − V_b u) / W,
// which is both the envelope of the roller and the relative-velocity condition n · V = 0.
//
// Pressure angle tan φ = V_u / |V_b|, positive while the follower moves on:
//   barrel (r_i q' − σ ρ sin q) / (ρ cos q), rotating (ρ q' − σ dx sin q) / (dy − ρ cos q), translating s'/ρ.
// Undercut function g = (1 − r k1)(1 − r k2) of the offset of the axis surface; the flank is regular where
// g > 0 and cut away beyond its edge g = 0. It is a local condition.
//   g = 1 − r (L − 2FM)/W² − r² M²/W²,  F = V·e,  L = C_θθ·n,  M = e_θ·n.
//
// Groove wider than its roller. With the clearance c the flanks are offset by R = r + c/2 in place of r, in
// all formulas above. The follower has the lost motion c / (lever cos φ) between them, where the lever is
// ∂(A·u)/∂q'' (barrel r_i, rotating f_l + h, translating 1): of a whole roller the least along it.
//
// Loads. The flank with σ_f V_b > 0 pushes the follower on (side 0: F > 0), the other pulls it back. The
// force along the normal is F / (lever cos φ). Roller and flank touch along a line that is inclined on the
// roller by q = R M/W; across it their relative curvature is (1 + q²)/(R g) + 1/r − 1/R. A force N over the
// length b of the roller loads b √(1 + q²) of the line, so p = √(N E* / (π b R_c)) with
//   R_c = r R g √(1 + q²) / (r (1 + q²) + (R − r) g);   without clearance r g / √(1 + q²).
// The whole force is taken to act at each station: the pressure of a load spread evenly lies between.
//
// s, s', s'' are by the cam angle: m, m/rad, m/rad² for the translating follower, else rad, 1, 1/rad.
// Lengths m. Where W = 0 (the axis does not move across itself) n and g are not defined: NaN.
// Sources: seeds 001 (OCRF) and 002 (barrel cam) with their formulas corrected (docs/papers).
#pragma once

#include "profiles/spatial/spatial_dimensions.hpp"
#include "scene/cam_flanks.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt {

/// A cam with all its dimensions fixed.
struct SpatialCam : SpatialDimensions {
    /// What exports and checks know of it (scene/cam_flanks.hpp), so that they take it as it is.
    operator CamFlanks() const;  // NOLINT(google-explicit-constructor)
};

/// Why this cam cannot be built (a dimension not positive, the axis at or beyond the cam's axis, a barrel's
/// arm beyond a right angle, …); empty: it can. `least`, `most`: the extremes of s.
[[nodiscard]] std::string geometry_fault(const SpatialCam& cam, double least, double most);

[[nodiscard]] RollerAxis roller_axis(const SpatialCam& cam, double theta, double s);

/// The cam at one cam angle and one station.
struct SpatialPoint {
    Eigen::Vector3d center;       ///< C: of the roller's axis, cam frame
    Eigen::Vector3d contact;      ///< C + r n: a point of the flank, cam frame
    Eigen::Vector3d normal;       ///< n, unit, from the roller's axis into the cam's material, cam frame
    double pressure_angle = 0.0;  ///< signed, rad; of both flanks
    double undercut = 0.0;        ///< g
    double contact_radius = 0.0;  ///< R_c, m
};
[[nodiscard]] SpatialPoint spatial_point(const SpatialCam& cam, double theta, const FollowerState& state,
                                         const RollerStation& station);

/// What a groove takes of its body where the follower moves from s = `least` to `most`; m. Along the axis the
/// whole width of the groove at the roller's two ends; radii: largest of the roller's near and far end.
struct DrumExtent {
    double lower = 0.0, upper = 0.0;
    double outer_radius = 0.0, floor_radius = 0.0;
};
[[nodiscard]] DrumExtent drum_extent(const SpatialCam& cam, double least, double most);

/// Variables of the partials: (s, s', s'', dimensions by SpatialDimension).
inline constexpr int spatial_variables = 3 + spatial_dimension_count;
[[nodiscard]] constexpr int column_of(SpatialDimension dimension) {
    return 3 + static_cast<int>(dimension);
}

/// A quantity with exact first and second partials (automatic differentiation of the formulas above).
struct SpatialValue {
    double value = 0.0;
    Eigen::Matrix<double, spatial_variables, 1> gradient;
    Eigen::Matrix<double, spatial_variables, spatial_variables> hessian;
};
[[nodiscard]] SpatialValue spatial_quantity(const SpatialCam& cam, const FollowerState& state,
                                            const RollerStation& station, SpatialQuantity which);

// Barrel and cylindrical cams as a CamMechanism, for the optimizer.
//
// Stations are heights along the roller, uniformly from its near to its far end, each on both flanks: station
// 2 k is flank +1, station 2 k + 1 flank −1 of height k. The pressure angle is the same on both flanks, and
// cos φm V_u − sin φm |V_b| is linear in h, so that its limit holds everywhere if it holds at both ends: it
// binds at two stations only. g binds at every station. Dimensions in the order of SpatialNumber
// (profiles/spatial/spatial_spec.hpp); m, rad.

/// Heights at which g is enforced; g is smooth over a roller (its extremes have always been found at its
/// ends).
inline constexpr int mechanism_heights = 3;

/// CamSpec::make of the types "barrel" and "cylindrical". Throws InputError for another.
[[nodiscard]] std::shared_ptr<const CamMechanism> spatial_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every number at 0, complete: type "barrel" or "cylindrical", the latter
/// with the choice "follower" = "rotating" or "translating".
[[nodiscard]] CamSpec spatial_spec(SpatialFollower follower);

/// The cam with these numbers, in the order of SpatialNumber.
[[nodiscard]] SpatialCam spatial_cam(SpatialFollower follower, Rotation rotation,
                                     std::span<const double> numbers, const DrumForm& form = {});
/// The same of a scene's cam; throws InputError for one of another type.
[[nodiscard]] SpatialCam spatial_cam(const CamSpec& spec, std::span<const double> numbers);

}  // namespace camopt

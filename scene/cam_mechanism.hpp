// SPDX-License-Identifier: MIT
// Interface of any mechanism between a cam and its output, for the optimizer and the reports: from one state
// of the output and the mechanism's dimensions it computes the quantities in limits, and a point of the cam.
//
// Implemented by the leaves of profiles/ (disk, remote, …). A mechanism is a formula: its numbers
// (dimensions) are arguments of every call, in the order of its CamSpec. Stations are locations along the
// contact, each with its own limits: one in a planar cam, heights and flanks of a roller in a spatial one.
//
// SI: m, rad, s' and s'' by the cam angle. A state or dimensions out of the mechanism's reach give NaN, never
// an exception; `fault` describes in words what does not reach.
#pragma once

#include "core/numbers/enclosures.hpp"
#include "core/partials.hpp"
#include "scene/cam_spec.hpp"

namespace camopt {

struct CamFlanks;
struct MotionSpec;
struct RollerGuide;
struct SceneFault;

/// Quantities in limits. Each is smooth wherever the mechanism moves (a flat face on an arm: and 1 + σψ' ≠
/// 0). Every mechanism has the first two and the regularity; the others if it says so.
enum class MechanismQuantity {
    pressure_numerator,    ///< tan φ = numerator / denominator; m
    pressure_denominator,  ///< > 0 where the mechanism moves; m
    pitch_curvature,       ///< of the roller centre's path, 1/m, > 0 where the cam is convex; planar cams
    cam_radius,            ///< signed radius of the cam, m; followers with a flat face
    regularity,            ///< <= 0: undercut. Planar: 1 − r κ; spatial: g of the flank
    contact_offset,        ///< contact offset of a flat face, m
    normal_lever  ///< force along the normal = F / lever (pushed: cos φ) or M / lever (swinging, m); direct
                  ///< cams
};

/// Throws ModelError: the mechanism does not have the requested quantity.
[[noreturn]] void refuse_quantity(std::string_view mechanism);

/// Value with first and second partials by (s, s', s'', the active dimensions in their order); its sums and
/// products: core/partials.hpp.
struct MechanismValue {
    static constexpr int most_active = 24;  ///< dimensions that may be variable at once
    using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 + most_active, 1>;
    using Hessian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 + most_active,
                                  3 + most_active>;
    double value = 0.0;
    Gradient gradient;
    Hessian hessian;
    double by_angle = 0.0;  ///< partial by MechanismState::theta; 0 if the input rotates uniformly
};

struct DrivenMechanism;

/// One side of a limit on the pressure angle, at one station.
struct PressureSide {
    double limit = 0.0;  ///< φm, rad
    int sign = 1;
    int station = 0;
};

/// A mechanism whose active dimensions the optimizer varies; the others have these values.
struct MechanismSetting {
    std::span<const double> dimensions;
    std::span<const int> active;
};

/// +1 if a force F > 0 along the lift acts on the station, −1 if F < 0 does, for cams that drive both ways.
[[nodiscard]] constexpr double pressing_sense(int station) {
    return station == 0 ? 1.0 : -1.0;
}

/// One state of one mechanism.
struct MechanismState {
    std::span<const double> dimensions;
    FollowerState output;
    double theta = 0.0;  ///< cam angle, rad: for mechanisms whose input does not rotate uniformly (inverse)
};

/// A mechanism over a box: each number a function of the box's variables.
struct MechanismStateOver {
    std::vector<RangeOver> dimensions;
    RangeOver s, velocity, acceleration;
    Interval theta;
};

/// The same along a stretch of a motion, with derivatives by the variable of the motion.
struct MechanismStateAlong {
    std::span<const double> dimensions;
    RangeAlong s, velocity, acceleration;
    RangeAlong theta;
};

/// One point of the cam at one station. Planar: z = 0.
struct MechanismPoint {
    double theta = 0.0;
    Eigen::Vector3d pitch, contact;  ///< roller centre (axis) and a point of the cam's surface, cam frame
    Eigen::Vector3d normal;          ///< outward unit normal of the cam there, cam frame
    double pressure_angle = 0.0;     ///< signed, rad
    double pitch_curvature = 0.0;    ///< 1/m; NaN where the mechanism has none
    double cam_radius = 0.0;         ///< signed, m: > 0 convex, < 0 concave; NaN where it has none
    double regularity = 0.0;
    double contact_offset = 0.0;  ///< m: contact offset of a flat face (profiles/disk/disk_cam.hpp)
};

/// A dimension with its number, as drawings list it.
struct NamedDimension {
    std::string name;  ///< "base_radius"
    double value = 0.0;
    bool is_angle = false;  ///< rad, else m
    bool of_form = false;   ///< of the cam's form (groove, second roller), not of cam and follower
};

/// A part of a drawing of the mechanism in the fixed frame, in its plane, m.
struct MechanismShape {
    enum class Kind { link, circle, pivot, guide, face };
    Kind kind = Kind::link;
    std::string name;  ///< "lever", "roller", …
    /// link: its line; guide: the guided point at output 0 and now; circle, pivot: the centre; face: the
    /// origin of contact offsets, and a point 1 m along in their positive direction. Its length is that of
    /// the contact, or given by the scene.
    std::vector<Eigen::Vector2d> points;
    double radius = 0.0;  ///< circle
};

class CamMechanism {
 public:
    virtual ~CamMechanism() = default;

    [[nodiscard]] virtual std::string type() const = 0;  ///< "remote"
    /// The output swings: the lift is an angle.
    [[nodiscard]] virtual bool swings() const = 0;
    [[nodiscard]] virtual Rotation rotation() const = 0;  ///< of the cam
    [[nodiscard]] virtual int stations() const = 0;
    [[nodiscard]] virtual std::string station_name(int station) const = 0;  ///< empty: there is but one
    /// Whether a limit on the quantity is enforced at this station; false if other stations imply it.
    [[nodiscard]] virtual bool binds(MechanismQuantity /*which*/, int /*station*/) const { return true; }
    /// Whether limits at all stations imply limits everywhere on the cam; false if stations are a selection.
    [[nodiscard]] virtual bool has_all_stations(MechanismQuantity /*which*/) const { return true; }
    /// Index of the roller's radius in the dimensions; -1: there is no roller.
    [[nodiscard]] virtual int roller_radius() const = 0;
    /// The same of the roller at a station.
    [[nodiscard]] virtual int roller_radius_at(int /*station*/) const { return roller_radius(); }
    /// From the roller's centre to the cam's surface at a station, m: the roller's radius, except in a
    /// groove.
    [[nodiscard]] virtual double surface_offset(std::span<const double> dimensions, int /*station*/) const {
        const int roller = roller_radius();
        return roller < 0 ? 0.0 : dimensions[static_cast<std::size_t>(roller)];
    }
    /// Planar: the cam is the outline of a disk with a curvature, and can be drawn.
    [[nodiscard]] virtual bool planar() const = 0;
    /// The cam is the guide of a roller in the body that moves.
    [[nodiscard]] virtual bool has_guide() const { return false; }
    /// A drawing can hold the cam.
    [[nodiscard]] bool is_plane_curve() const { return planar() || has_guide(); }
    /// The cam touches the output directly: its load acts on the cam, and rise and return are strokes of the
    /// cam too.
    [[nodiscard]] virtual bool is_direct() const { return false; }
    /// The radii of the cam follow from those of a pitch curve; a flat face has none.
    [[nodiscard]] virtual bool has_pitch_curve() const { return planar(); }
    /// The contact element: without a roller a flat face, or the edge that moves along the pitch curve.
    [[nodiscard]] ContactKind contact() const {
        if (roller_radius() >= 0) return ContactKind::roller;
        return has_pitch_curve() ? ContactKind::edge : ContactKind::flat;
    }
    /// Direct, with two sides: a force F > 0 along the lift presses on station 0, F < 0 on station 1.
    [[nodiscard]] bool drives_both_ways() const { return is_direct() && stations() > 1; }
    /// Index of the base radius in the dimensions; -1: it follows from them and the motion.
    [[nodiscard]] virtual int base_radius_index() const { return -1; }
    /// m; none if it is not a dimension.
    [[nodiscard]] std::optional<double> base_radius(std::span<const double> dimensions) const {
        const int index = base_radius_index();
        if (index < 0) return std::nullopt;
        return dimensions[static_cast<std::size_t>(index)];
    }
    /// σe of a roller or an edge that is pushed straight, m, with the cam's sense σ and the offset e: tan φ =
    /// (s' − σe)/(s0 + s) with s0 = √(p² − e²), and p = length(dimensions) grows with every dimension but the
    /// offset. None (default): the pressure angle has another formula.
    [[nodiscard]] virtual std::optional<double> pushed_offset(std::span<const double> /*dimensions*/) const {
        return {};
    }
    /// A dimension in a sum: sign · d.
    struct SignedIndex {
        int dimension = 0;
        double sign = 1.0;
    };
    /// The cam can be built at rest if each of these sums is below 0.
    [[nodiscard]] virtual std::vector<std::vector<SignedIndex>> reach() const { return {}; }
    /// Message for undercut with a suggested change: "the cam intersects itself there; … . A smaller roller
    /// helps"; empty: no undercut.
    [[nodiscard]] virtual std::string undercut_words() const;
    /// Description of the forward check: "lever and linkage run over 6000 points of the cam".
    [[nodiscard]] virtual std::string check_words(int points) const;
    /// The unit of length for dimensionless geometry, m.
    [[nodiscard]] virtual double length(std::span<const double> dimensions) const = 0;
    /// Why it cannot be built or cannot move over all s from `least` to `most`; empty: it can.
    [[nodiscard]] virtual std::string fault(std::span<const double> dimensions, double least,
                                            double most) const = 0;
    /// The first fault of a scene's cam of this kind, for every choice of its dimensions within their ranges;
    /// by default: a range that does not ascend, a lift that does not fit, a mechanism that does not reach
    /// with every dimension in its middle.
    [[nodiscard]] virtual std::optional<SceneFault> find_fault(const CamSpec& spec,
                                                               const MotionSpec& motion) const;
    /// active: which dimensions the partials are by.
    [[nodiscard]] virtual MechanismValue quantity(MechanismQuantity which, const MechanismState& state,
                                                  int station, std::span<const int> active) const = 0;
    /// sign · N cos φ − D sin φ with the limit φ of the pressure angle, N and D its numerator and
    /// denominator: <= 0 if the limit is satisfied on that side. A mechanism may extend it differently where
    /// no motion satisfies the limit on both sides at every cam angle.
    [[nodiscard]] virtual MechanismValue pressure_excess(double limit, int sign, const MechanismState& state,
                                                         int station, std::span<const int> active) const;
    /// The shape of pressure_excess over all s from `least` to `most` (±infinity: unknown), all s' and the
    /// active dimensions.
    [[nodiscard]] virtual Curvature pressure_shape(const PressureSide& /*side*/,
                                                   const MechanismSetting& /*setting*/, double /*least*/,
                                                   double /*most*/) const {
        return Curvature::general;
    }
    /// The range of s' allowed by pressure_excess <= 0, for any s.
    [[nodiscard]] virtual Interval pressure_slopes(const PressureSide& /*side*/,
                                                   std::span<const double> /*dimensions*/) const {
        return Interval::everything();
    }
    /// The side sign > 0 of the pressure angle belongs to the rise, the other to the return.
    [[nodiscard]] virtual bool upper_side_rises(int /*station*/) const { return true; }
    /// The pressure angle at rest need not be 0.
    [[nodiscard]] virtual bool leans_at_rest(int /*station*/, const MechanismSetting& /*setting*/) const {
        return false;
    }
    /// The shape of a quantity over all states and the active dimensions.
    [[nodiscard]] virtual Curvature shape(MechanismQuantity /*which*/,
                                          const MechanismSetting& /*setting*/) const {
        return Curvature::general;
    }
    /// σ if 1 + σ s' must stay above 0 for contact of a face on an arm; 0: no reversal.
    [[nodiscard]] virtual double face_turn() const { return 0.0; }
    /// An enclosure of a quantity over a box, with its partials. Unbounded if it may be out of reach
    /// somewhere in the box. Returns nullopt if no enclosure is implemented.
    [[nodiscard]] virtual std::optional<RangeOver> quantity_over(MechanismQuantity /*which*/,
                                                                 const MechanismStateOver& /*state*/,
                                                                 int /*station*/) const {
        return {};
    }
    /// The same of the three limits below, times a positive factor chosen by the mechanism to reduce
    /// curvature. pressure_excess.
    [[nodiscard]] virtual std::optional<RangeOver> pressure_over(double limit, int sign,
                                                                 const MechanismStateOver& state,
                                                                 int station) const;
    /// margin − regularity.
    [[nodiscard]] virtual std::optional<RangeOver> regularity_over(double margin,
                                                                   const MechanismStateOver& state,
                                                                   int station) const;
    /// (roller radius + shift) κ − 1, of cams with a pitch curve; without a roller shift κ − 1.
    [[nodiscard]] virtual std::optional<RangeOver> radius_over(double shift, const MechanismStateOver& state,
                                                               int station) const;
    /// An enclosure of a quantity along a stretch of a motion, with its first and second derivative by the
    /// variable of the motion. Unbounded if it may be out of reach somewhere in the stretch. Returns nullopt
    /// if no enclosure is implemented.
    [[nodiscard]] virtual std::optional<RangeAlong> quantity_along(MechanismQuantity /*which*/,
                                                                   const MechanismStateAlong& /*state*/,
                                                                   int /*station*/) const {
        return {};
    }
    /// The same of pressure_excess.
    [[nodiscard]] virtual std::optional<RangeAlong> pressure_along(double limit, int sign,
                                                                   const MechanismStateAlong& state,
                                                                   int station) const;
    [[nodiscard]] virtual MechanismPoint point(double theta, const MechanismState& state,
                                               int station) const = 0;

    // For drawings of a direct cam. The defaults are for other cams, whose drawings show `shapes`.
    /// "translating_roller"; empty: the follower has no name.
    [[nodiscard]] virtual std::string follower_name() const { return {}; }
    /// How the cam holds its follower, as a scene names it: "grooved"; empty: it is open.
    [[nodiscard]] virtual std::string form_name() const { return {}; }
    /// The same after the name of the follower: "in a groove"; empty: it is open.
    [[nodiscard]] virtual std::string form_words() const { return {}; }
    /// All of them, in their order; empty: drawings list none.
    [[nodiscard]] virtual std::vector<NamedDimension> named_dimensions(
        std::span<const double> /*dimensions*/) const {
        return {};
    }
    /// Pivot of the arm that touches the cam, in the fixed frame, m; none: the follower is pushed along +y.
    [[nodiscard]] virtual std::optional<Eigen::Vector2d> arm_pivot(
        std::span<const double> /*dimensions*/) const {
        return {};
    }
    /// Of a cam whose stations are the flanks of one groove in a disk: wall of the disk beyond the outer
    /// flank at its largest radius, m; none: its stations are outlines.
    [[nodiscard]] virtual std::optional<double> groove_wall(std::span<const double> /*dimensions*/) const {
        return {};
    }
    /// Parts made separately, one for each station, as open cams: their dimensions and words, while the
    /// points are those of the station. The base radius of all but the first follows from its points. Empty:
    /// the cam is made in one piece.
    [[nodiscard]] virtual std::vector<DrivenMechanism> pieces(std::span<const double> dimensions) const;

    /// Rotation of the cam frame in this state of the mechanism, rad: σθ of a cam that rotates uniformly.
    [[nodiscard]] virtual double turned(const MechanismState& state) const {
        return sense_of(rotation()) * state.theta;
    }
    /// Its parts in one state, first the centre of the cam (a pivot); empty if it is not a plane mechanism.
    [[nodiscard]] virtual std::vector<MechanismShape> shapes(const MechanismState& state) const = 0;
    /// The follower for a forward check on the finished points of a station, for output 0. None (default): it
    /// has another check, or none.
    [[nodiscard]] virtual std::optional<FollowerGeometry> follower(std::span<const double> /*dimensions*/,
                                                                   int /*station*/) const {
        return {};
    }
    /// Of a three-dimensional cam: its roller and its flanks (scene/cam_flanks.hpp); none: it has no flanks.
    [[nodiscard]] virtual std::optional<CamFlanks> flanks(std::span<const double> dimensions) const;
    /// Of a cam that has a guide: what its forward check needs (scene/cam_flanks.hpp).
    [[nodiscard]] virtual std::optional<RollerGuide> guide(std::span<const double> dimensions) const;

 protected:
    CamMechanism() = default;
    CamMechanism(const CamMechanism&) = default;
    CamMechanism& operator=(const CamMechanism&) = default;
};

/// A mechanism with its numbers.
struct DrivenMechanism {
    std::shared_ptr<const CamMechanism> formulas;
    std::vector<double> dimensions;
};

}  // namespace camopt

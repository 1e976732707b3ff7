// SPDX-License-Identifier: MIT
// Any mechanism between a cam and its output, as the optimizer and the reports see it: one state of the
// output and the mechanism's dimensions make the quantities that limits are made of, and a point of the cam.
//
// Implemented by the leaves of profiles/ (disk, remote, …); who uses it knows no more. A
// mechanism is a formula: its numbers (dimensions) come with every call, in the order of its CamSpec.
// Stations are places along the contact that each keep the limits by themselves: one in a planar cam, heights
// and flanks of a roller in a spatial one.
//
// SI: m, rad, s' and s'' by the cam angle. A state or dimensions out of the mechanism's reach give NaN, never
// a throw; `fault` says in words what does not reach.
#pragma once

#include "core/curvature.hpp"
#include "core/follower_state.hpp"
#include "core/numbers/range_along.hpp"
#include "core/numbers/range_over.hpp"
#include "core/partials.hpp"
#include "scene/cam_spec.hpp"
#include "scene/follower_geometry.hpp"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct CamFlanks;
struct MotionSpec;
struct RollerGuide;
struct SceneFault;

/// What limits are made of. Each is smooth wherever the mechanism moves (a flat face on an arm: and
/// 1 + σψ' ≠ 0). A mechanism has the first two and the regularity; the others where it says so.
enum class MechanismQuantity {
    pressure_numerator,    ///< tan φ = numerator / denominator; m
    pressure_denominator,  ///< > 0 where the mechanism moves; m
    pitch_curvature,       ///< of the roller centre's path, 1/m, > 0 where the cam is convex; planar cams
    cam_radius,            ///< signed radius of the cam, m; followers with a flat face
    regularity,            ///< <= 0: undercut. Planar: 1 − r κ; spatial: g of the flank
    contact_offset,        ///< where a flat face is touched, m
    normal_lever  ///< force along the normal = F / lever (pushed: cos φ) or M / lever (swinging, m); direct
                  ///< cams
};

/// Throws ModelError: the mechanism has not the quantity that was asked for.
[[noreturn]] void refuse_quantity(std::string_view mechanism);

/// Value with first and second partials by (s, s', s'', the active dimensions in their order); its sums and
/// products: core/partials.hpp.
struct MechanismValue {
    static constexpr int most_active = 24;  ///< dimensions that may move at once
    using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 + most_active, 1>;
    using Hessian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 + most_active,
                                  3 + most_active>;
    double value = 0.0;
    Gradient gradient;
    Hessian hessian;
    double by_angle = 0.0;  ///< partial by MechanismState::theta; 0 where the input turns evenly
};

struct DrivenMechanism;

/// One side of a limit on the pressure angle, at one station.
struct PressureSide {
    double limit = 0.0;  ///< φm, rad
    int sign = 1;
    int station = 0;
};

/// A mechanism whose active dimensions the optimizer moves; the others keep these numbers.
struct MechanismSetting {
    std::span<const double> dimensions;
    std::span<const int> active;
};

/// +1 where a force F > 0 along the lift presses on the station, −1 where F < 0 does, of cams that drive both
/// ways.
[[nodiscard]] constexpr double pressing_sense(int station) {
    return station == 0 ? 1.0 : -1.0;
}

/// One state of one mechanism.
struct MechanismState {
    std::span<const double> dimensions;
    FollowerState output;
    double theta = 0.0;  ///< cam angle, rad: for mechanisms whose input does not turn evenly (inverse)
};

/// A mechanism over a box: each number a function of what the box is of.
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
    double contact_offset = 0.0;  ///< m: where a flat face is touched (profiles/disk/disk_cam.hpp)
};

/// A dimension with its number, as drawings list it.
struct NamedDimension {
    std::string name;  ///< "base_radius"
    double value = 0.0;
    bool is_angle = false;  ///< rad, else m
    bool of_form = false;   ///< of what holds the follower (groove, second roller), not of cam and follower
};

/// A part of a drawing of the mechanism in the frame that stands still, in its plane, m.
struct MechanismShape {
    enum class Kind { link, circle, pivot, guide, face };
    Kind kind = Kind::link;
    std::string name;  ///< "lever", "roller", …
    /// link: its line; guide: where what it guides is at output 0, and where now; circle, pivot: the centre;
    /// face: the place from which contact offsets are counted, and a point 1 m along where they grow. It is
    /// as long as the contact needs, or the scene says.
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
    /// Whether a limit on the quantity has to be kept at this station: not where other stations imply it.
    [[nodiscard]] virtual bool binds(MechanismQuantity which, int station) const {
        static_cast<void>(which);
        static_cast<void>(station);
        return true;
    }
    /// Whether what holds at all stations holds everywhere on the cam: not where stations are a choice of
    /// many.
    [[nodiscard]] virtual bool has_all_stations(MechanismQuantity which) const {
        static_cast<void>(which);
        return true;
    }
    /// Where in the dimensions the roller's radius stands; -1: there is no roller.
    [[nodiscard]] virtual int roller_radius() const = 0;
    /// The same of the roller that runs at a station.
    [[nodiscard]] virtual int roller_radius_at(int station) const {
        static_cast<void>(station);
        return roller_radius();
    }
    /// From the roller's centre to the cam's surface at a station, m: the roller's radius, but in a groove.
    [[nodiscard]] virtual double surface_offset(std::span<const double> dimensions, int station) const {
        static_cast<void>(station);
        const int roller = roller_radius();
        return roller < 0 ? 0.0 : dimensions[static_cast<std::size_t>(roller)];
    }
    /// Planar: the cam is the outline of a disk with a curvature, and can be drawn.
    [[nodiscard]] virtual bool planar() const = 0;
    /// The cam is the guide of a roller in the body that moves.
    [[nodiscard]] virtual bool has_guide() const { return false; }
    /// A drawing can hold the cam.
    [[nodiscard]] bool is_plane_curve() const { return planar() || has_guide(); }
    /// The cam touches the output itself: what that carries presses on the cam, and rise and return are
    /// strokes of the cam too.
    [[nodiscard]] virtual bool is_direct() const { return false; }
    /// The radii of the cam follow from those of a pitch curve; a flat face has none.
    [[nodiscard]] virtual bool has_pitch_curve() const { return planar(); }
    /// What touches the cam: without a roller a flat face, or the edge that moves along the pitch curve.
    [[nodiscard]] ContactKind contact() const {
        if (roller_radius() >= 0) return ContactKind::roller;
        return has_pitch_curve() ? ContactKind::edge : ContactKind::flat;
    }
    /// Direct, with two sides: a force F > 0 along the lift presses on station 0, F < 0 on station 1.
    [[nodiscard]] bool drives_both_ways() const { return is_direct() && stations() > 1; }
    /// Where in the dimensions the base radius of the cam stands; -1: it follows from them and the motion.
    [[nodiscard]] virtual int base_radius_index() const { return -1; }
    /// m; none where it is no dimension.
    [[nodiscard]] std::optional<double> base_radius(std::span<const double> dimensions) const {
        const int index = base_radius_index();
        if (index < 0) return std::nullopt;
        return dimensions[static_cast<std::size_t>(index)];
    }
    /// σe of a roller or an edge that is pushed straight, m, with the cam's sense σ and the offset e:
    /// tan φ = (s' − σe)/(s0 + s) with s0 = √(p² − e²), and p = length(dimensions) grows with every dimension
    /// but the offset. None (default): the pressure angle follows another law.
    [[nodiscard]] virtual std::optional<double> pushed_offset(std::span<const double> dimensions) const {
        static_cast<void>(dimensions);
        return {};
    }
    /// A dimension in a sum: sign · d.
    struct SignedIndex {
        int dimension = 0;
        double sign = 1.0;
    };
    /// The cam can be built at rest where each of these sums is below 0.
    [[nodiscard]] virtual std::vector<std::vector<SignedIndex>> reach() const { return {}; }
    /// What happens where it undercuts, and what helps: "the cam crosses itself there, … . A smaller roller
    /// helps"; empty: nothing undercuts.
    [[nodiscard]] virtual std::string undercut_words() const;
    /// What the forward check did: "lever and linkage run over 6000 points of the cam".
    [[nodiscard]] virtual std::string check_words(int points) const;
    /// A length by which geometry is made dimensionless, m.
    [[nodiscard]] virtual double length(std::span<const double> dimensions) const = 0;
    /// Why it cannot be built or cannot move over all s from `least` to `most`; empty: it can.
    [[nodiscard]] virtual std::string fault(std::span<const double> dimensions, double least,
                                            double most) const = 0;
    /// The first thing wrong with a scene's cam of this kind, for every choice of its dimensions within
    /// their ranges; by default: a range that does not ascend, a lift that does not fit, a mechanism that
    /// does not reach with every dimension in its middle.
    [[nodiscard]] virtual std::optional<SceneFault> find_fault(const CamSpec& spec,
                                                               const MotionSpec& motion) const;
    /// active: which dimensions the partials are by.
    [[nodiscard]] virtual MechanismValue quantity(MechanismQuantity which, const MechanismState& state,
                                                  int station, std::span<const int> active) const = 0;
    /// sign · N cos φ − D sin φ with the limit φ of the pressure angle, N and D its numerator and
    /// denominator:
    /// <= 0 where it is kept to that side. A mechanism may continue it otherwise where no motion comes that
    /// keeps the limit to both sides at every cam angle.
    [[nodiscard]] virtual MechanismValue pressure_excess(double limit, int sign, const MechanismState& state,
                                                         int station, std::span<const int> active) const;
    /// The shape of pressure_excess over all s from `least` to `most` (±infinity: nothing is known), all s'
    /// and the active dimensions.
    [[nodiscard]] virtual Curvature pressure_shape(const PressureSide& side, const MechanismSetting& setting,
                                                   double least, double most) const {
        static_cast<void>(side);
        static_cast<void>(setting);
        static_cast<void>(least);
        static_cast<void>(most);
        return Curvature::general;
    }
    /// The s' that pressure_excess <= 0 allows at all, for any s.
    [[nodiscard]] virtual Interval pressure_slopes(const PressureSide& side,
                                                   std::span<const double> dimensions) const {
        static_cast<void>(side);
        static_cast<void>(dimensions);
        return Interval::everything();
    }
    /// The side sign > 0 of the pressure angle belongs to the rise, the other to the return.
    [[nodiscard]] virtual bool upper_side_rises(int station) const {
        static_cast<void>(station);
        return true;
    }
    /// The pressure angle at standstill need not be 0.
    [[nodiscard]] virtual bool leans_at_rest(int station, const MechanismSetting& setting) const {
        static_cast<void>(station);
        static_cast<void>(setting);
        return false;
    }
    /// The shape of a quantity over all states and the active dimensions.
    [[nodiscard]] virtual Curvature shape(MechanismQuantity which, const MechanismSetting& setting) const {
        static_cast<void>(which);
        static_cast<void>(setting);
        return Curvature::general;
    }
    /// σ where 1 + σ s' must stay above 0 for a face on an arm to touch anything; 0: nothing turns back.
    [[nodiscard]] virtual double face_turn() const { return 0.0; }
    /// What encloses a quantity over a box, with its partials. Everything where it may be out of reach
    /// somewhere in the box. Returns nullopt if no enclosure is implemented.
    [[nodiscard]] virtual std::optional<RangeOver> quantity_over(MechanismQuantity which,
                                                                 const MechanismStateOver& state,
                                                                 int station) const {
        static_cast<void>(which);
        static_cast<void>(state);
        static_cast<void>(station);
        return {};
    }
    /// The same of the three limits below, or of that times something positive: the mechanism's own choice,
    /// one that leaves little that is curved.
    /// pressure_excess.
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
    /// What encloses a quantity along a stretch of a motion, with its first and second derivative by the
    /// variable of the motion. Everything where it may be out of reach somewhere in the stretch. Returns
    /// nullopt if no enclosure is implemented.
    [[nodiscard]] virtual std::optional<RangeAlong> quantity_along(MechanismQuantity which,
                                                                   const MechanismStateAlong& state,
                                                                   int station) const {
        static_cast<void>(which);
        static_cast<void>(state);
        static_cast<void>(station);
        return {};
    }
    /// The same of pressure_excess.
    [[nodiscard]] virtual std::optional<RangeAlong> pressure_along(double limit, int sign,
                                                                   const MechanismStateAlong& state,
                                                                   int station) const;
    [[nodiscard]] virtual MechanismPoint point(double theta, const MechanismState& state,
                                               int station) const = 0;

    // What drawings of a direct cam need. The defaults are for other cams, whose drawings show `shapes`.
    /// "translating_roller"; empty: the follower has no name.
    [[nodiscard]] virtual std::string follower_name() const { return {}; }
    /// How the cam holds its follower, as a scene names it: "grooved"; empty: it is open.
    [[nodiscard]] virtual std::string form_name() const { return {}; }
    /// The same after the name of the follower: "in a groove"; empty: it is open.
    [[nodiscard]] virtual std::string form_words() const { return {}; }
    /// All of them, in their order; empty: drawings list none.
    [[nodiscard]] virtual std::vector<NamedDimension> named_dimensions(
        std::span<const double> dimensions) const;
    /// Pivot of the arm that touches the cam, in the frame that stands still, m; none: the follower is pushed
    /// along +y.
    [[nodiscard]] virtual std::optional<Eigen::Vector2d> arm_pivot(std::span<const double> dimensions) const;
    /// Of a cam whose stations are the flanks of one groove in a disk: what the disk keeps beyond the outer
    /// flank where that reaches farthest, m; none: its stations are outlines.
    [[nodiscard]] virtual std::optional<double> groove_wall(std::span<const double> dimensions) const;
    /// What is made separately, one for each station, as open cams: their dimensions and words, while the
    /// points are those of the station. The base radius of all but the first follows from its points. Empty:
    /// the cam is made in one piece.
    [[nodiscard]] virtual std::vector<DrivenMechanism> pieces(std::span<const double> dimensions) const;

    /// By how much the cam frame has turned where the mechanism is in this state, rad: σθ of a cam that turns
    /// evenly.
    [[nodiscard]] virtual double turned(const MechanismState& state) const {
        return sense_of(rotation()) * state.theta;
    }
    /// Its parts in one state, the centre about which the cam turns first (a pivot); empty where it is no
    /// plane mechanism.
    [[nodiscard]] virtual std::vector<MechanismShape> shapes(const MechanismState& state) const = 0;
    /// What a forward check puts down on the finished points of a station, for output 0. None (default): it
    /// has another check, or none.
    [[nodiscard]] virtual std::optional<FollowerGeometry> follower(std::span<const double> dimensions,
                                                                   int station) const {
        static_cast<void>(dimensions);
        static_cast<void>(station);
        return {};
    }
    /// Of a three-dimensional cam: its roller and its flanks (scene/cam_flanks.hpp); none: it has no flanks.
    [[nodiscard]] virtual std::optional<CamFlanks> flanks(std::span<const double> dimensions) const;
    /// Of a cam that has a guide: what its forward check needs (scene/roller_guide.hpp).
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

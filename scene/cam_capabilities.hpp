// SPDX-License-Identifier: MIT
// What a mechanism may have in addition to the core that every one has (cam_mechanism.hpp): one class for
// each capability. A leaf of profiles/ implements those that it has; a caller asks the mechanism for a
// capability and uses what it returns, whatever the kind of cam. SI units and signs as there.
#pragma once

#include "scene/mechanism_values.hpp"

namespace camopt {

/// What the optimizer may rely on in the limits: at which stations they hold, and their shape. The defaults
/// promise nothing.
class LimitStructure {
 public:
    virtual ~LimitStructure() = default;

    /// Whether a limit on the quantity is enforced at this station; false if other stations imply it.
    [[nodiscard]] virtual bool binds(MechanismQuantity /*which*/, int /*station*/) const { return true; }
    /// Whether limits at all stations imply limits everywhere on the cam; false if stations are a selection.
    [[nodiscard]] virtual bool has_all_stations(MechanismQuantity /*which*/) const { return true; }
    /// The shape of a quantity over all states and the active dimensions.
    [[nodiscard]] virtual Curvature shape(MechanismQuantity /*which*/,
                                          const MechanismSetting& /*setting*/) const {
        return Curvature::general;
    }
    /// The shape of CamMechanism::pressure_excess over all s from `least` to `most` (±infinity: unknown), all
    /// s' and the active dimensions.
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
};

/// Enclosures of quantities and limits, which proofs need: without them maxima are sampled. Nullopt: no
/// enclosure of this quantity is implemented.
class MechanismEnclosures {
 public:
    virtual ~MechanismEnclosures() = default;

    /// Of a quantity over a box, with its partials. Unbounded if it may be out of reach somewhere in the box.
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
    /// radius κ − 1 with the curvature of a pitch curve.
    [[nodiscard]] virtual std::optional<RangeOver> radius_over(const RangeOver& radius,
                                                               const MechanismStateOver& state,
                                                               int station) const;
    /// Of a quantity along a stretch of a motion, with its first and second derivative by the variable of the
    /// motion. Unbounded if it may be out of reach somewhere in the stretch.
    [[nodiscard]] virtual std::optional<RangeAlong> quantity_along(MechanismQuantity /*which*/,
                                                                   const MechanismStateAlong& /*state*/,
                                                                   int /*station*/) const {
        return {};
    }
    /// The same of pressure_excess.
    [[nodiscard]] virtual std::optional<RangeAlong> pressure_along(double limit, int sign,
                                                                   const MechanismStateAlong& state,
                                                                   int station) const;
};

/// A mechanism in one plane with its cam: a drawing can hold them.
class PlaneMechanism {
 public:
    virtual ~PlaneMechanism() = default;

    /// Its parts in one state, first the centre of the cam (a pivot).
    [[nodiscard]] virtual std::vector<MechanismShape> shapes(const MechanismState& state) const = 0;
    /// Where the cam is in this state.
    [[nodiscard]] virtual CamPose pose(const MechanismState& state) const = 0;
    /// It is a plate that slides along x: its outline is the surface from the first to the last point, the
    /// sides below them, and a bottom at y = 0.
    [[nodiscard]] virtual bool is_plate() const { return false; }
};

/// A dimension with its number, as drawings list it.
struct NamedDimension {
    std::string name;  ///< "base_radius"
    double value = 0.0;
    bool is_angle = false;  ///< rad, else m
    bool of_form = false;   ///< of the cam's form (groove, second roller), not of cam and follower
};

/// A dimension in a sum: sign · d.
struct SignedIndex {
    int dimension = 0;
    double sign = 1.0;
};

/// What drawings show of a direct cam, named as scenes name it.
struct DirectCamDrawing {
    std::string follower;                    ///< "translating_roller"; empty: it has no name
    std::string form = {};                   ///< how it holds its follower: "grooved"; empty: it is open
    std::vector<NamedDimension> dimensions;  ///< all of them, in their order; empty: drawings list none
    /// Of a cam whose stations are the flanks of one groove in a disk: wall of the disk beyond the outer
    /// flank at its largest radius, m; none: its stations are outlines.
    std::optional<double> groove_wall = {};
    /// Parts made separately, one for each station, as open cams, while the points are those of the station.
    /// The base radius of all but the first follows from its points. Empty: the cam is made in one piece.
    std::vector<DrivenMechanism> pieces = {};
};

/// A cam that touches the output: its load acts on the cam, and rise and return are strokes of the cam too.
/// With two stations it drives both ways: a force F > 0 along the lift presses on station 0, F < 0 on
/// station 1.
class DirectCam {
 public:
    virtual ~DirectCam() = default;

    /// Index of the base radius in the dimensions; -1: it follows from them and the motion.
    [[nodiscard]] virtual int base_radius_index() const { return -1; }
    /// σe of a roller or an edge that is pushed straight, m, with the cam's sense σ and the offset e: tan φ =
    /// (s' − σe)/(s0 + s) with s0 = √(p² − e²), and p = length(dimensions) grows with every dimension but the
    /// offset. None (default): the pressure angle has another formula.
    [[nodiscard]] virtual std::optional<double> pushed_offset(std::span<const double> /*dimensions*/) const {
        return {};
    }
    /// m that a cam slides for every radian of its angle, > 0: the force that drives it is its torque divided
    /// by this. None (default): it turns.
    [[nodiscard]] virtual std::optional<double> slide(std::span<const double> /*dimensions*/) const {
        return {};
    }
    /// The cam can be built at rest if each of these sums is below 0.
    [[nodiscard]] virtual std::vector<std::vector<SignedIndex>> reach() const { return {}; }
    /// σ if 1 + σ s' must stay above 0 for contact of a face on an arm; 0: no reversal.
    [[nodiscard]] virtual double face_turn() const { return 0.0; }
    [[nodiscard]] virtual DirectCamDrawing drawing(std::span<const double> /*dimensions*/) const {
        return {};
    }
};

}  // namespace camopt

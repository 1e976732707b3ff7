// SPDX-License-Identifier: MIT
// Interface of any mechanism between a cam and its output, for the optimizer and the reports: from one state
// of the output and the mechanism's dimensions it computes the quantities in limits, and a point of the cam.
// What only some mechanisms have is a capability (cam_capabilities.hpp), which a caller asks for.
//
// Implemented by the leaves of profiles/ (disk, remote, …). A mechanism is a formula: its numbers
// (dimensions) are arguments of every call, in the order of its CamSpec. Stations are locations along the
// contact, each with its own limits: one in a planar cam, heights and flanks of a roller in a spatial one.
//
// SI: m, rad, s' and s'' by the cam angle. A state or dimensions out of the mechanism's reach give NaN, never
// an exception; `fault` describes in words what does not reach.
#pragma once

#include "scene/cam_capabilities.hpp"

namespace camopt {

struct CamFlanks;
struct MotionSpec;
struct RollerGuide;
struct SceneFault;

class CamMechanism {
 public:
    virtual ~CamMechanism() = default;

    // The core, of every mechanism.

    [[nodiscard]] virtual std::string type() const = 0;  ///< "remote"
    /// The output swings: the lift is an angle.
    [[nodiscard]] virtual bool swings() const = 0;
    [[nodiscard]] virtual Rotation rotation() const = 0;  ///< of the cam
    [[nodiscard]] virtual int stations() const = 0;
    [[nodiscard]] virtual std::string station_name(int station) const = 0;  ///< empty: there is but one
    /// Index of the radius of the roller at a station in the dimensions; -1: there is no roller.
    [[nodiscard]] virtual int roller_radius_at(int station) const = 0;
    /// From the roller's centre to the cam's surface at a station, m: the roller's radius, except in a
    /// groove.
    [[nodiscard]] virtual double surface_offset(std::span<const double> dimensions, int station) const {
        const int roller = roller_radius_at(station);
        return roller < 0 ? 0.0 : dimensions[static_cast<std::size_t>(roller)];
    }
    /// What the radii of the outline of a plane cam follow from: pitch_curvature, or with a flat face
    /// cam_radius. None: the cam has no outline.
    [[nodiscard]] virtual std::optional<MechanismQuantity> radius_quantity() const { return {}; }
    /// The unit of length for dimensionless geometry, m.
    [[nodiscard]] virtual double length(std::span<const double> dimensions) const = 0;
    /// Why it cannot be built or cannot move over all s from `least` to `most`; empty: it can.
    [[nodiscard]] virtual std::string fault(std::span<const double> dimensions, double least,
                                            double most) const = 0;
    /// The load of the output acts on the cam's surface: its follower is the output.
    [[nodiscard]] virtual bool carries_load() const { return direct() != nullptr; }
    /// Which side of a loaded cam a station lies on. One with two sides drives both ways: a force F > 0 along
    /// the lift presses on side 0, F < 0 on side 1.
    [[nodiscard]] virtual int side_of(int station) const { return station; }
    [[nodiscard]] virtual std::string side_name(int side) const { return station_name(side); }
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
    [[nodiscard]] virtual MechanismPoint point(double theta, const MechanismState& state,
                                               int station) const = 0;

    // Capabilities. Null or none, the default: the mechanism does not have it.

    [[nodiscard]] virtual const LimitStructure& limit_structure() const;
    [[nodiscard]] virtual const MechanismEnclosures* enclosures() const { return nullptr; }
    [[nodiscard]] virtual const PlaneMechanism* plane() const { return nullptr; }
    [[nodiscard]] virtual const DirectCam* direct() const { return nullptr; }
    /// The follower for a forward check on the finished points of a station, for output 0. None: it has
    /// another check, or none.
    [[nodiscard]] virtual std::optional<FollowerGeometry> follower(std::span<const double> /*dimensions*/,
                                                                   int /*station*/) const {
        return {};
    }
    /// Of a three-dimensional cam: its roller and its flanks (scene/cam_flanks.hpp).
    [[nodiscard]] virtual std::optional<CamFlanks> flanks(std::span<const double> dimensions) const;
    /// Of a cam that is the guide of a roller in the body that moves: what its forward check needs
    /// (scene/cam_flanks.hpp).
    [[nodiscard]] virtual std::optional<RollerGuide> guide(std::span<const double> dimensions) const;

    // What follows from these.

    [[nodiscard]] int sides() const {
        int last = 0;
        for (int station = 0; station < stations(); ++station) last = std::max(last, side_of(station));
        return last + 1;
    }
    /// +1 if a force F > 0 along the lift acts on the station, −1 if F < 0 does.
    [[nodiscard]] double pressing_sense(int station) const { return side_of(station) == 0 ? 1.0 : -1.0; }
    /// DirectCam::slide; none of a cam that has no such capability.
    [[nodiscard]] std::optional<double> slide(std::span<const double> dimensions) const {
        const DirectCam* const cam = direct();
        return cam == nullptr ? std::nullopt : cam->slide(dimensions);
    }
    [[nodiscard]] int roller_radius() const { return roller_radius_at(0); }
    /// The contact element: without a roller a flat face, or the edge that moves along the pitch curve.
    [[nodiscard]] ContactKind contact() const {
        if (roller_radius() >= 0) return ContactKind::roller;
        return radius_quantity() == MechanismQuantity::pitch_curvature ? ContactKind::edge
                                                                       : ContactKind::flat;
    }
    /// Index of the base radius in the dimensions; -1: it is none of them.
    [[nodiscard]] int base_radius_index() const {
        const DirectCam* const cam = direct();
        return cam == nullptr ? -1 : cam->base_radius_index();
    }
    /// m; none if it is not a dimension.
    [[nodiscard]] std::optional<double> base_radius(std::span<const double> dimensions) const {
        const int index = base_radius_index();
        if (index < 0) return std::nullopt;
        return dimensions[static_cast<std::size_t>(index)];
    }

 protected:
    CamMechanism() = default;
    CamMechanism(const CamMechanism&) = default;
    CamMechanism& operator=(const CamMechanism&) = default;
};

}  // namespace camopt

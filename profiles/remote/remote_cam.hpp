// SPDX-License-Identifier: MIT
// Disk cam whose roller lever moves an output through a linkage (remote follower): the motion is prescribed
// at the output, limits hold at the cam.
//
// The linkage is followed backwards, from the output s to the lever, dyad by dyad in closed form; ψ(s) and
// its derivatives by implicit differentiation, ψ' = ψ_s s', ψ'' = ψ_ss s'² + ψ_s s''. With u the direction of
// the roller's arm, t = z × u, A the lever's pivot seen from the cam's centre, l the roller's arm and σ the
// cam's sense the roller's centre is C = A + l u, and
//   tan φ = (C·u − σ l ψ') / C·t                 at the roller's centre (the roller turns freely),
//   tan φ = (C·u − σ l ψ' − r |V|/l) / C·t       at the contact point taken as fixed to the lever,
//   |V|² = (C·u − σ l ψ')² + (C·t)²              speed of the roller's centre against the cam.
// φ turns from t, the way of the roller while the lever turns counterclockwise.
// Numerator and denominator are given the sign that makes the denominator positive in this mechanism.
// Frames and signs otherwise as in profiles/disk/disk_cam.hpp; coordinates are those of the scene.
// Linkages, dimensions and branches: profiles/remote/remote_spec.hpp. SI, rad. Out of reach: NaN; `fault` has
// the words. Source: docs/papers/003.md (tappet shedding; the paper prints no formulas).
#pragma once

#include "profiles/remote/remote_layout.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt {

class RemoteCam final : public CamMechanism, public MechanismEnclosures, public PlaneMechanism {
 public:
    /// Takes type, sense and branches from the spec; of the dimensions only their middles, to determine on
    /// which side of the cam the lever works. Throws InputError for an unknown choice.
    explicit RemoteCam(const CamSpec& spec);

    [[nodiscard]] std::string type() const override { return remote_type; }
    [[nodiscard]] bool swings() const override { return output_swings(layout_.linkage); }
    [[nodiscard]] Rotation rotation() const override { return layout_.rotation; }
    [[nodiscard]] int stations() const override { return 1; }
    [[nodiscard]] std::string station_name(int) const override { return {}; }
    [[nodiscard]] int roller_radius_at(int) const override {
        return static_cast<int>(RemoteDimension::roller_radius);
    }
    [[nodiscard]] std::optional<MechanismQuantity> radius_quantity() const override {
        return MechanismQuantity::pitch_curvature;
    }
    [[nodiscard]] const MechanismEnclosures* enclosures() const override { return this; }
    [[nodiscard]] const PlaneMechanism* plane() const override { return this; }
    [[nodiscard]] double length(std::span<const double> dimensions) const override;
    [[nodiscard]] std::string fault(std::span<const double> dimensions, double least,
                                    double most) const override;
    [[nodiscard]] MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                                          std::span<const int> active) const override;
    [[nodiscard]] MechanismValue pressure_excess(double limit, int sign, const MechanismState& state,
                                                 int station, std::span<const int> active) const override;
    [[nodiscard]] std::optional<RangeOver> pressure_over(double limit, int sign,
                                                         const MechanismStateOver& state,
                                                         int station) const override;
    [[nodiscard]] std::optional<RangeOver> regularity_over(double margin, const MechanismStateOver& state,
                                                           int station) const override;
    [[nodiscard]] std::optional<RangeOver> radius_over(const RangeOver& radius,
                                                       const MechanismStateOver& state,
                                                       int station) const override;
    [[nodiscard]] std::optional<RangeAlong> quantity_along(MechanismQuantity which,
                                                           const MechanismStateAlong& state,
                                                           int station) const override;
    [[nodiscard]] std::optional<RangeAlong> pressure_along(double limit, int sign,
                                                           const MechanismStateAlong& state,
                                                           int station) const override;
    [[nodiscard]] MechanismPoint point(double theta, const MechanismState& state, int station) const override;
    [[nodiscard]] std::vector<MechanismShape> shapes(const MechanismState& state) const override;
    [[nodiscard]] CamPose pose(const MechanismState& state) const override {
        return {sense_of(layout_.rotation) * state.theta};
    }

    [[nodiscard]] std::optional<FollowerGeometry> follower(std::span<const double> dimensions,
                                                           int station) const override;

    /// Of the roller's arm: its angle from +x in (−π, π], and its derivatives by the cam angle.
    struct LeverState {
        double angle = 0.0, velocity = 0.0, acceleration = 0.0;
    };
    [[nodiscard]] LeverState lever(const MechanismState& state) const;

    [[nodiscard]] RemoteLinkage linkage() const { return layout_.linkage; }
    [[nodiscard]] PressurePoint pressure_point() const { return layout_.pressure_point; }
    [[nodiscard]] const RemoteLayout& layout() const { return layout_; }

 private:
    RemoteLayout layout_;
};

/// The linkage run forwards, by positions alone: lever -> output. For checks independent of ψ(s).
class RemoteLinkageForward {
 public:
    /// The branches are those of `cam` at output s = 0.
    RemoteLinkageForward(const RemoteCam& cam, std::span<const double> dimensions);

    /// s for an angle of the roller's arm from +x; NaN if the linkage does not reach.
    [[nodiscard]] double output(double angle) const;

 private:
    RemoteLinkage linkage_;
    std::vector<double> dimensions_;
    double far_branch_ = 1.0, slider_branch_ = 1.0;

    [[nodiscard]] Eigen::Vector2d lever_joint(double angle) const;
    [[nodiscard]] double slid(const Eigen::Vector2d& joint, double coupler) const;
};

/// CamSpec::make of such a cam. Throws InputError for an unknown choice.
[[nodiscard]] std::shared_ptr<const CamMechanism> remote_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every dimension at 0 and every choice at its default, complete.
[[nodiscard]] CamSpec remote_spec(RemoteLinkage linkage);

}  // namespace camopt

// SPDX-License-Identifier: MIT
//
// The whole machine: the roller pushes, the guide swings the body, the rocker moves the feeder; and the guide
// required for a given motion of the feeder.
//
//   theta = -psi(L),  theta' = -psi' L',  theta'' = -(psi'' L'² + psi' L'')    (psi by L, the rest by time)
//   inverse: psi = -theta,  psi' = -theta'/L',  psi'' = -(theta'' + psi' L'') / L'²
// Lengths m, angles rad, time s.
#pragma once

#include "profiles/inverse/feeder_linkage.hpp"
#include "profiles/inverse/guide.hpp"
#include "profiles/inverse/roller_law.hpp"

namespace camopt {

struct InverseState {
    InverseFault fault = InverseFault::none;
    RollerState roller;
    double pressure_angle = 0.0;  ///< mu, of the guide on the roller
    double curvature = 0.0;       ///< of the guide
    BodyMotion body;
    FeederMotion feeder;
};

/// At a joint of the guide the piece on `guide_side`, in the sense of growing L.
[[nodiscard]] InverseState inverse_state(const Guide& guide, const FeederLinkage& linkage,
                                         const RollerState& roller, Side guide_side = Side::right);

/// The body alone; the roller must be within the guide's reach (InputError).
[[nodiscard]] BodyMotion body_on_guide(const Guide& guide, const RollerState& roller,
                                       Side guide_side = Side::right);

/// The node of the guide for this motion of the feeder and that of the roller.
struct GuideNode {
    InverseFault fault = InverseFault::none;
    PolarNode node;
};
[[nodiscard]] GuideNode wanted_guide(const FeederLinkage& linkage, const RollerState& roller,
                                     const FollowerState& feeder);

}  // namespace camopt

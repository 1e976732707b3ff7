// SPDX-License-Identifier: MIT
// The mechanism and the motions of paper 003, tappet shedding of a loom: lever, coupler, rocker, coupler,
// heald frame. The angles and the lift are the paper's; every dimension of the mechanism is chosen, it gives
// none.
#pragma once

#include "profiles/remote/remote_cam.hpp"
#include "scene/scene.hpp"
#include "splines/motion_chain.hpp"
#include "studies/delivered/driven_mechanism.hpp"

namespace camopt {

/// farther: the cam's axis 10 mm lower, our reading of the paper's cams whose name ends in 2.
[[nodiscard]] CamSpec tappet_spec(bool farther, PressurePoint where = PressurePoint::roller_center);

/// Of the motions below: x in deg of the cam angle, lift 80 mm.
[[nodiscard]] MotionScale tappet_scale();

/// Dwell at the bottom from 0, rise by the law to 180, dwell at the top, fall; both dwells of dwell_deg.
[[nodiscard]] MotionChain tappet_motion(const std::string& law, double dwell_deg);

/// The scene of scenes/tappet_75.toml for any dwell: the motion of the frame free but for the dwells, the
/// pressure angle at most limit_deg.
[[nodiscard]] Scene tappet_scene(double dwell_deg, double limit_deg);

}  // namespace camopt

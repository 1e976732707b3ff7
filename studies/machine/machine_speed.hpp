// SPDX-License-Identifier: MIT
// The scenes of a machine's axes at a speed of the master, and what of them depends on it.
#pragma once

#include "scene/machine_spec.hpp"

namespace camopt {

/// The scene at another speed: everything written in units of time says what it said.
[[nodiscard]] Scene at_speed(const Scene& scene, double speed);

/// The scenes of the axes at a speed of the master.
[[nodiscard]] std::vector<Scene> scenes_at(const MachineSpec& machine, double speed);
/// The same without what counts in time: the machine as its speed approaches 0.
[[nodiscard]] std::vector<Scene> scenes_at_standstill(const MachineSpec& machine);
/// Whether what is impossible at standstill is so at every speed. Not where viscous friction may relieve the
/// torque of an advancing axis on average, nor with points in time.
[[nodiscard]] bool standstill_is_any_speed(const Scene& scene);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A machine of several axes on one master (scene/machine_spec.hpp): at a given speed the motions of least
// total objective; over a range of speeds the largest one at which motions exist, with a proof that none do
// a little above it.
//
// Limits in time only tighten as the speed ω grows, |y^{(k)}| ≤ L_k / (h ω^k), and clearances do not depend
// on it: the feasible speeds are an interval from 0. Its end is searched (studies/least/feasible_edge.hpp) by
// the logarithm of 1 + the least common violation, nearly linear in log ω. At the lower end motions are
// delivered, at the upper one the multipliers of the elastic program prove that there are none. Limits that
// do not only tighten (residual vibration, forces, drive torque, numbers in time at set points) are tried at
// speeds over the whole range: between these nothing is claimed, and the result says so.
#pragma once

#include "studies/machine/machine_solution.hpp"
#include "studies/machine/machine_speed.hpp"
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

/// Throws InputError for wrong options, SceneError with a member of the machine ("axis[1].phase",
/// "axis[0].scene.limits.cam_radius_min_mm") for a wrong machine.
[[nodiscard]] MachineSolution solve_machine(const MachineSpec& machine, const MachineOptions& options = {},
                                            const SolveControl& control = {});

/// What a machine's solution says, as a row of a sweep; `settings` as of SweepRow.
[[nodiscard]] SweepRow machine_row(int number, std::span<const double> settings,
                                   const MachineSolution& solution);

}  // namespace camopt

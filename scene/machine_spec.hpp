// SPDX-License-Identifier: MIT
// A machine: several axes on one master, and clearances between them. SI and radians.
//
// Axis i is at displacement s_i(θ − phase_i) at master angle θ, its cam angle counted over the cycle 2π. A
// clearance holds at every master angle of its stretch:
//
//     Σ_k factor_k · s_k(θ − phase_k) ≥ at_least.
//
// Every axis is a program over the whole cycle with its own limits, cam and objective. Its own speed is
// replaced by the machine's: a number, or a range whose largest feasible speed is searched.
#pragma once

#include "scene/key_row.hpp"
#include "scene/scene.hpp"

namespace camopt {

struct AxisSpec {
    std::string name;    ///< letters, digits, '_' and '-': its result folder has this name
    std::string file;    ///< of the scene, for messages; empty: none
    Scene scene;         ///< with any speed
    double phase = 0.0;  ///< rad of the master, in (−2π, 2π): its motion starts there
    std::vector<std::string> settings = {};  ///< "KEY=VALUE" that were put on top of the file
};

struct Clearance {
    std::vector<int> axes;                ///< indices, each once
    std::vector<double> factors;          ///< one for each axis
    double at_least = 0.0;                ///< m where the axes translate, rad where they swing
    double from = 0.0, to = units::turn;  ///< rad of the master, in [0, 2π]; from > to passes 2π
    std::string key = {};                 ///< as written: "clearance[0].at_least_mm"; empty: in C++
    std::string unit = {};                ///< "mm"; empty: SI
    double unit_value = 1.0;              ///< SI value of one unit
};

struct MachineSpec {
    std::string title;
    double least_speed = 0.0, most_speed = 0.0;  ///< rad/s of the master, > 0; equal: one given speed
    std::vector<AxisSpec> axes;
    std::vector<Clearance> clearances;

    [[nodiscard]] bool searches_speed() const { return most_speed > least_speed; }
};

/// The first thing wrong with a machine: "axis[1].phase", what was found, what is allowed. Members of an
/// axis's scene follow its name: "axis[1].scene.spline.knots". What needs the formulas of an axis (limits
/// that are not convex) is refused by solve_machine.
[[nodiscard]] std::optional<SceneFault> find_fault(const MachineSpec& machine);

/// The same of the name of one axis, which differs from those of the axes before it.
[[nodiscard]] std::optional<SceneFault> find_name_fault(const MachineSpec& machine, std::size_t index);

/// The keys of a machine file.
[[nodiscard]] const std::vector<KeyRow>& machine_rows();

/// "clearance[0]".
[[nodiscard]] std::string name_of_clearance(int index);

}  // namespace camopt

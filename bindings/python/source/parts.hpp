// SPDX-License-Identifier: MIT
// The parts of the extension module _camopt; each adds its classes and functions. In the order of module.cpp.
#pragma once

#include "bindings/python/source/read_scene.hpp"

#include <camopt/laws.hpp>
#include <camopt/motion.hpp>
#include <camopt/solution.hpp>
#include <memory>
#include <pybind11/pybind11.h>
#include <utility>

namespace camopt::python {

void add_errors(pybind11::module_& module);
void add_own_rules(pybind11::module_& module);
void add_motions(pybind11::module_& module);
void add_scenes(pybind11::module_& module);
void add_solutions(pybind11::module_& module);
void add_solving(pybind11::module_& module);
void add_sweeps(pybind11::module_& module);
void add_comparisons(pybind11::module_& module);

// A solution with the scene it belongs to, as Python holds it.
struct SolvedScene {
    std::shared_ptr<const Solution> solution;
    RunOrigin origin;
};

// Motions as Python holds them: shared with the solution they come from, constant.
struct MotionValue {
    std::shared_ptr<const Motion> motion;
};

struct LawValue : MotionValue {
    std::shared_ptr<const Law> law;
    explicit LawValue(std::shared_ptr<const Law> made) : MotionValue{made}, law(std::move(made)) {}
};

}  // namespace camopt::python

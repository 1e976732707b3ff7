// SPDX-License-Identifier: MIT
// The parts of the extension module _camopt; each adds its classes and functions. In the order of module.cpp.
#pragma once

#include <pybind11/pybind11.h>

namespace camopt::python {

void add_errors(pybind11::module_& module);
void add_own_rules(pybind11::module_& module);
void add_motions(pybind11::module_& module);
void add_scenes(pybind11::module_& module);
void add_solutions(pybind11::module_& module);
void add_solving(pybind11::module_& module);
void add_sweeps(pybind11::module_& module);
void add_comparisons(pybind11::module_& module);

}  // namespace camopt::python

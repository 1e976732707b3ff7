// SPDX-License-Identifier: MIT
// The extension module _camopt: the C++ library as Python sees it. What people call is the package around it
// (bindings/python/camopt); its stubs are _camopt.pyi.
#include "bindings/python/source/parts.hpp"

#include <camopt/version.hpp>
#include <string>

PYBIND11_MODULE(_camopt, module) {
    module.doc() = "The C++ library camopt. The package `camopt` is its face; see help(camopt).";
    module.attr("__version__") = std::string(camopt::version());
    camopt::python::add_errors(module);
    camopt::python::add_own_rules(module);
    camopt::python::add_motions(module);
    camopt::python::add_scenes(module);
    camopt::python::add_solutions(module);
    camopt::python::add_solving(module);
    camopt::python::add_sweeps(module);
    camopt::python::add_comparisons(module);
}

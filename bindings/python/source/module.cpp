// SPDX-License-Identifier: MIT
// The extension module _camopt: the C++ library as Python sees it. What people call is the package around it
// (bindings/python/camopt); its stubs are _camopt.pyi.
#include "bindings/python/source/parts.hpp"

#include <camopt/errors.hpp>
#include <camopt/licenses.hpp>
#include <camopt/version.hpp>
#include <string>

namespace camopt::python {

namespace py = pybind11;

/// The exceptions of the library as exceptions of Python, with the same words; under what terms the module
/// may be passed on.
void add_errors(py::module_& module) {
    module.def(
        "licenses",
        [] {
            std::string text = terms_of_binary();
            for (const LicensedPart& part : licensed_parts())
                text += "\n" + part.name + ": " + part.license + " (" + part.use + ")";
            return text;
        },
        "The terms for distributing this module, and the licences of its libraries.");
    // The last one registered is asked first: what is derived comes after its base.
    auto& input_error = py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
    input_error.attr("__doc__") = "Invalid input: the message says what was found and what is allowed.";
    auto& unavailable = py::register_exception<UnavailableError>(module, "UnavailableError", input_error);
    unavailable.attr("__doc__") =
        "A capability that this build of camopt does not have; the message names the package to install.";
    auto& model_error = py::register_exception<ModelError>(module, "ModelError", PyExc_ValueError);
    model_error.attr("__doc__") =
        "A user-defined rule is invalid: a wrong shape, a value that is not finite.";
}

}  // namespace camopt::python

PYBIND11_MODULE(_camopt, module) {
    module.doc() = "The C++ library camopt, used through the package `camopt`; see help(camopt).";
    module.attr("__version__") = std::string(camopt::version());
    camopt::python::add_errors(module);
    camopt::python::add_own_rules(module);
    camopt::python::add_motions(module);
    camopt::python::add_scenes(module);
    camopt::python::add_solutions(module);
    camopt::python::add_solving(module);
    camopt::python::add_machines(module);
    camopt::python::add_sweeps(module);
    camopt::python::add_comparisons(module);
}

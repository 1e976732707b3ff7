// SPDX-License-Identifier: MIT
// Functions of Python as cost terms and limits of a scene.
//
// A function is called as f(x, y, v, a, j) with y and its three derivatives by x. Its partials come in one of
// two ways: it is called with numbers that carry first and second partials (Number), or functions for its
// gradient and Hessian stand beside it, and all three are called with plain numbers.
#pragma once

#include <camopt/own_rules.hpp>
#include <camopt/scene.hpp>
#include <pybind11/pybind11.h>
#include <vector>

namespace camopt::python {

namespace py = pybind11;

/// x, y, y', y'', y''': what a Number has partials by, in this order.
inline constexpr int number_variables = 5;
using Number = SecondOrder<number_variables>;

/// The formula of a rule (attributes f, gradient, hessian; the latter two may be None). It takes the
/// interpreter's lock for every call and may be copied and destroyed without it. Exceptions of the function
/// come out as py::error_already_set; ModelError for a value of the wrong kind or shape, or not finite.
[[nodiscard]] MotionFormula formula_of(const py::object& rule);

/// From the attributes of camopt.OwnTerm, camopt.OwnLimit.
[[nodiscard]] OwnTerm own_term(const py::object& rule);
[[nodiscard]] OwnLimit own_limit(const py::object& rule);

}  // namespace camopt::python

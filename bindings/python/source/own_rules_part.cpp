// SPDX-License-Identifier: MIT
// Numbers with partials, which functions of Python are called with, and the check of what they give.
#include "bindings/python/source/parts.hpp"

#include <fmt/format.h>

#include <array>
#include <camopt/errors.hpp>
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

namespace camopt::python {

namespace {

void add_arithmetic(py::class_<Number>& type) {
    using Value = const Number&;
    const auto add = [&](const char* name, const auto& made) { type.def(name, made, py::is_operator()); };
    add("__add__", [](Value a, Value b) { return a + b; });
    add("__add__", [](Value a, double b) { return a + b; });
    add("__radd__", [](Value a, double b) { return b + a; });
    add("__sub__", [](Value a, Value b) { return a - b; });
    add("__sub__", [](Value a, double b) { return a - b; });
    add("__rsub__", [](Value a, double b) { return b - a; });
    add("__mul__", [](Value a, Value b) { return a * b; });
    add("__mul__", [](Value a, double b) { return a * b; });
    add("__rmul__", [](Value a, double b) { return b * a; });
    add("__truediv__", [](Value a, Value b) { return a / b; });
    add("__truediv__", [](Value a, double b) { return a / b; });
    add("__rtruediv__", [](Value a, double b) { return b / a; });
    add("__pow__", [](Value a, Value b) { return pow(a, b); });
    add("__pow__", [](Value a, double b) { return pow(a, b); });
    add("__rpow__", [](Value a, double b) { return pow(b, a); });
    type.def("__neg__", [](Value a) { return -a; })
        .def("__pos__", [](Value a) { return a; })
        .def("__abs__", [](Value a) { return abs(a); });
}

void add_order(py::class_<Number>& type) {
    using Value = const Number&;
    const auto add = [&](const char* name, const auto& made) { type.def(name, made, py::is_operator()); };
    add("__lt__", [](Value a, Value b) { return a < b; });
    add("__lt__", [](Value a, double b) { return a < b; });
    add("__le__", [](Value a, Value b) { return a <= b; });
    add("__le__", [](Value a, double b) { return a <= b; });
    add("__gt__", [](Value a, Value b) { return a > b; });
    add("__gt__", [](Value a, double b) { return a > b; });
    add("__ge__", [](Value a, Value b) { return a >= b; });
    add("__ge__", [](Value a, double b) { return a >= b; });
    type.def("__bool__", [](Value a) { return a.value != 0.0; });
}

/// Under the names by which NumPy asks an object for them: np.sin(number) calls number.sin().
void add_functions(py::class_<Number>& type) {
    using Value = const Number&;
    const auto add = [&](const char* name, const char* words, const auto& made) {
        type.def(name, made, words);
    };
    add("sqrt", "Square root.", [](Value u) { return sqrt(u); });
    add("exp", "e to this power.", [](Value u) { return exp(u); });
    add("log", "Natural logarithm.", [](Value u) { return log(u); });
    add("sin", "Sine.", [](Value u) { return sin(u); });
    add("cos", "Cosine.", [](Value u) { return cos(u); });
    add("tan", "Tangent.", [](Value u) { return tan(u); });
    add("arcsin", "Arc sine.", [](Value u) { return asin(u); });
    add("arccos", "Arc cosine.", [](Value u) { return acos(u); });
    add("arctan", "Arc tangent.", [](Value u) { return atan(u); });
    add("sinh", "Hyperbolic sine.", [](Value u) { return sinh(u); });
    add("cosh", "Hyperbolic cosine.", [](Value u) { return cosh(u); });
    add("tanh", "Hyperbolic tangent.", [](Value u) { return tanh(u); });
    type.def(
            "arctan2", [](Value y, Value x) { return atan2(y, x); }, py::arg("other"),
            "Angle of the point (other, self).")
        .def(
            "arctan2", [](Value y, double x) { return atan2(y, Number(x)); }, py::arg("other"));
}

/// Value, (by x, y, v, a, j) first and (by y, v, a, j) second partials of a rule at a point (x, y, v, a, j).
py::tuple evaluated(const py::object& rule, const std::array<double, number_variables>& point) {
    const FormulaValue found = formula_of(rule)({point[0], {point[1], point[2], point[3], point[4]}});
    Eigen::Matrix<double, number_variables, 1> gradient;
    gradient << found.by_x, found.gradient;
    return py::make_tuple(found.value, gradient, found.hessian);
}

}  // namespace

void add_own_rules(py::module_& module) {
    py::class_<Number> type(
        module, "Number",
        "A number with its partials by x, y, v, a and j: the argument of a user-defined function.\n\n"
        "It takes + - * / **, abs, comparisons (by its value) and NumPy's sqrt, exp, log, sin, cos, tan, "
        "arcsin,\n"
        "arccos, arctan, arctan2, sinh, cosh and tanh.");
    type.def_property_readonly(
        "value", [](const Number& number) { return number.value; }, "Without its partials.");
    add_arithmetic(type);
    add_order(type);
    add_functions(type);
    type.def("__repr__", [](const Number& number) { return fmt::format("Number({})", number.value); });
    module.def("evaluate_rule", &evaluated, py::arg("rule"), py::arg("point"),
               "Value, gradient by (x, y, v, a, j) and Hessian by (y, v, a, j) of a rule at such a point.");
}

}  // namespace camopt::python

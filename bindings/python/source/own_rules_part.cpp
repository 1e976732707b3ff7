// SPDX-License-Identifier: MIT
// Numbers with partials, which functions of Python are called with, and the check of what they give.
#include "bindings/python/source/parts.hpp"

#include <fmt/format.h>

#include <array>
#include <camopt/errors.hpp>
#include <cmath>
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

namespace camopt::python {

namespace {

using First = FirstOrder<number_variables>;

/// A function of one number by its value and its first two derivatives there.
struct Outer {
    double value, first, second;
};

Number chained(const Number& inner, const Outer& outer) {
    const First& u = inner.value();
    First slope(outer.first);
    slope.derivatives() = outer.second * u.derivatives();
    Number result;
    result.value() = First(outer.value);
    result.value().derivatives() = outer.first * u.derivatives();
    for (int i = 0; i < number_variables; ++i) result.derivatives()(i) = slope * inner.derivatives()(i);
    return result;
}

double value_of(const Number& number) {
    return number.value().value();
}

Number plain(double value) {
    return constant<number_variables>(value);
}

Number inverse(const Number& number) {
    const double u = value_of(number);
    return chained(number, {1.0 / u, -1.0 / (u * u), 2.0 / (u * u * u)});
}

/// u to the power n; for n = 0, 1, 2, … everywhere.
Number power(const Number& number, double n) {
    const double u = value_of(number);
    return chained(number, {std::pow(u, n), n == 0.0 ? 0.0 : n * std::pow(u, n - 1.0),
                            n == 0.0 || n == 1.0 ? 0.0 : n * (n - 1.0) * std::pow(u, n - 2.0)});
}

Number exponential(const Number& number) {
    const double e = std::exp(value_of(number));
    return chained(number, {e, e, e});
}

Number logarithm(const Number& number) {
    const double u = value_of(number);
    return chained(number, {std::log(u), 1.0 / u, -1.0 / (u * u)});
}

Number arc_tangent_2(const Number& y, const Number& x) {
    // Its partials are those of atan(y / x), or of −atan(x / y) where x is the smaller one.
    const bool steep = std::abs(value_of(y)) > std::abs(value_of(x));
    const double u = steep ? value_of(x) / value_of(y) : value_of(y) / value_of(x);
    const double d = 1.0 + u * u, sign = steep ? -1.0 : 1.0;
    return chained(steep ? Number(x * inverse(y)) : Number(y * inverse(x)),
                   {std::atan2(value_of(y), value_of(x)), sign / d, -2.0 * sign * u / (d * d)});
}

Number magnitude(const Number& number) {
    return value_of(number) < 0.0 ? Number(-number) : number;
}

void add_arithmetic(py::class_<Number>& type) {
    type.def(
            "__add__", [](const Number& a, const Number& b) { return Number(a + b); }, py::is_operator())
        .def(
            "__add__", [](const Number& a, double b) { return Number(a + plain(b)); }, py::is_operator())
        .def(
            "__radd__", [](const Number& a, double b) { return Number(plain(b) + a); }, py::is_operator())
        .def(
            "__sub__", [](const Number& a, const Number& b) { return Number(a - b); }, py::is_operator())
        .def(
            "__sub__", [](const Number& a, double b) { return Number(a - plain(b)); }, py::is_operator())
        .def(
            "__rsub__", [](const Number& a, double b) { return Number(plain(b) - a); }, py::is_operator())
        .def(
            "__mul__", [](const Number& a, const Number& b) { return Number(a * b); }, py::is_operator())
        .def(
            "__mul__", [](const Number& a, double b) { return Number(a * plain(b)); }, py::is_operator())
        .def(
            "__rmul__", [](const Number& a, double b) { return Number(plain(b) * a); }, py::is_operator())
        .def(
            "__truediv__", [](const Number& a, const Number& b) { return Number(a * inverse(b)); },
            py::is_operator())
        .def(
            "__truediv__", [](const Number& a, double b) { return Number(a * plain(1.0 / b)); },
            py::is_operator())
        .def(
            "__rtruediv__", [](const Number& a, double b) { return Number(plain(b) * inverse(a)); },
            py::is_operator())
        .def(
            "__pow__", [](const Number& a, const Number& b) { return exponential(b * logarithm(a)); },
            py::is_operator())
        .def("__pow__", &power, py::is_operator())
        .def(
            "__rpow__", [](const Number& a, double b) { return exponential(a * plain(std::log(b))); },
            py::is_operator())
        .def("__neg__", [](const Number& a) { return Number(-a); })
        .def("__pos__", [](const Number& a) { return a; })
        .def("__abs__", &magnitude);
}

void add_order(py::class_<Number>& type) {
    type.def(
            "__lt__", [](const Number& a, const Number& b) { return value_of(a) < value_of(b); },
            py::is_operator())
        .def(
            "__lt__", [](const Number& a, double b) { return value_of(a) < b; }, py::is_operator())
        .def(
            "__le__", [](const Number& a, const Number& b) { return value_of(a) <= value_of(b); },
            py::is_operator())
        .def(
            "__le__", [](const Number& a, double b) { return value_of(a) <= b; }, py::is_operator())
        .def(
            "__gt__", [](const Number& a, const Number& b) { return value_of(a) > value_of(b); },
            py::is_operator())
        .def(
            "__gt__", [](const Number& a, double b) { return value_of(a) > b; }, py::is_operator())
        .def(
            "__ge__", [](const Number& a, const Number& b) { return value_of(a) >= value_of(b); },
            py::is_operator())
        .def(
            "__ge__", [](const Number& a, double b) { return value_of(a) >= b; }, py::is_operator())
        .def("__bool__", [](const Number& a) { return value_of(a) != 0.0; });
}

/// Under the names by which NumPy asks an object for them: np.sin(number) calls number.sin().
void add_functions(py::class_<Number>& type) {
    const auto add = [&](const char* name, const char* words, Outer (*outer)(double)) {
        type.def(
            name, [outer](const Number& number) { return chained(number, outer(value_of(number))); }, words);
    };
    add("sqrt", "Square root.", [](double u) {
        const double root = std::sqrt(u);
        return Outer{root, 0.5 / root, -0.25 / (root * u)};
    });
    type.def("exp", &exponential, "e to this power.").def("log", &logarithm, "Natural logarithm.");
    add("sin", "Sine.", [](double u) { return Outer{std::sin(u), std::cos(u), -std::sin(u)}; });
    add("cos", "Cosine.", [](double u) { return Outer{std::cos(u), -std::sin(u), -std::cos(u)}; });
    add("tan", "Tangent.", [](double u) {
        const double t = std::tan(u), d = 1.0 + t * t;
        return Outer{t, d, 2.0 * t * d};
    });
    add("arcsin", "Arc sine.", [](double u) {
        const double d = 1.0 - u * u, root = std::sqrt(d);
        return Outer{std::asin(u), 1.0 / root, u / (d * root)};
    });
    add("arccos", "Arc cosine.", [](double u) {
        const double d = 1.0 - u * u, root = std::sqrt(d);
        return Outer{std::acos(u), -1.0 / root, -u / (d * root)};
    });
    add("arctan", "Arc tangent.", [](double u) {
        const double d = 1.0 + u * u;
        return Outer{std::atan(u), 1.0 / d, -2.0 * u / (d * d)};
    });
    add("sinh", "Hyperbolic sine.", [](double u) { return Outer{std::sinh(u), std::cosh(u), std::sinh(u)}; });
    add("cosh", "Hyperbolic cosine.", [](double u) {
        return Outer{std::cosh(u), std::sinh(u), std::cosh(u)};
    });
    add("tanh", "Hyperbolic tangent.", [](double u) {
        const double t = std::tanh(u), d = 1.0 - t * t;
        return Outer{t, d, -2.0 * t * d};
    });
    type.def("arctan2", &arc_tangent_2, py::arg("other"), "Angle of the point (other, self).")
        .def(
            "arctan2", [](const Number& y, double x) { return arc_tangent_2(y, plain(x)); },
            py::arg("other"));
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
    type.def_property_readonly("value", &value_of, "Without its partials.");
    add_arithmetic(type);
    add_order(type);
    add_functions(type);
    type.def("__repr__", [](const Number& number) { return fmt::format("Number({})", value_of(number)); });
    module.def("evaluate_rule", &evaluated, py::arg("rule"), py::arg("point"),
               "Value, gradient by (x, y, v, a, j) and Hessian by (y, v, a, j) of a rule at such a point.");
}

}  // namespace camopt::python

// SPDX-License-Identifier: MIT
#include "bindings/python/source/parts.hpp"

#include <fmt/format.h>

#include <camopt/errors.hpp>
#include <memory>
#include <pybind11/eigen.h>
#include <string>

namespace camopt::python {

namespace {

/// An object of Python that is shared and let go of without the interpreter's lock.
using Shared = std::shared_ptr<const py::object>;

Shared shared(py::object object) {
    return {new py::object(std::move(object)), [](const py::object* held) {
                const py::gil_scoped_acquire lock;
                delete held;
            }};
}

struct Functions {
    std::string name;
    Shared value, gradient, hessian;  ///< the last two: none, or None
};

py::object called(const Shared& function, const MotionPoint& point) {
    const auto& y = point.derivative;
    return (*function)(point.x, y[0], y[1], y[2], y[3]);
}

[[noreturn]] void fail(const Functions& rule, const std::string& found, const char* allowed) {
    throw ModelError(fmt::format("{}: found {}; allowed: {}", rule.name, found, allowed));
}

std::string shown(const py::object& object) {
    return py::repr(object).cast<std::string>();
}

double number_of(const Functions& rule, const py::object& given) {
    if (PyNumber_Check(given.ptr()) == 0) fail(rule, shown(given), "a number");
    return given.cast<double>();
}

/// `count` numbers in a row, or so many rows of them, as an array of NumPy.
Eigen::MatrixXd array_of(const Functions& rule, const py::object& given, const char* allowed) {
    try {
        return py::module_::import("numpy")
            .attr("atleast_2d")(given)
            .attr("astype")("float64")
            .cast<Eigen::MatrixXd>();
    } catch (const py::error_already_set&) {
        fail(rule, shown(given), allowed);
    } catch (const py::cast_error&) {
        fail(rule, shown(given), allowed);
    }
}

FormulaValue by_hand(const Functions& rule, const MotionPoint& point) {
    constexpr const char* gradient_allowed =
        "a gradient of 4 numbers, the partials by y, v, a, j, or of 5, and by x";
    constexpr const char* hessian_allowed = "a Hessian of 4 x 4 numbers, the second partials by y, v, a, j";
    FormulaValue found;
    found.value = number_of(rule, called(rule.value, point));
    const py::object gradient = called(rule.gradient, point), hessian = called(rule.hessian, point);
    const Eigen::MatrixXd first = array_of(rule, gradient, gradient_allowed);
    if (first.rows() != 1 || (first.cols() != 4 && first.cols() != 5))
        fail(rule, shown(gradient), gradient_allowed);
    const Eigen::MatrixXd second = array_of(rule, hessian, hessian_allowed);
    if (second.rows() != 4 || second.cols() != 4) fail(rule, shown(hessian), hessian_allowed);
    found.gradient = first.row(0).head<4>().transpose();
    if (first.cols() == 5) found.by_x = first(0, 4);
    found.hessian = 0.5 * (second + second.transpose());
    return found;
}

FormulaValue automatic(const Functions& rule, const MotionPoint& point) {
    const auto& y = point.derivative;
    const py::object result =
        (*rule.value)(variable<number_variables>(point.x, 0), variable<number_variables>(y[0], 1),
                      variable<number_variables>(y[1], 2), variable<number_variables>(y[2], 3),
                      variable<number_variables>(y[3], 4));
    FormulaValue found;
    if (!py::isinstance<Number>(result)) {  // it depends on nothing here
        found.value = number_of(rule, result);
        return found;
    }
    const auto& number = result.cast<const Number&>();
    found.value = number.value;
    found.by_x = number.first[0];
    found.gradient = number.gradient().tail<4>();
    found.hessian = number.hessian().bottomRightCorner<4, 4>();
    return found;
}

Curvature shape_of(const std::string& name, const std::string& shape) {
    if (shape == "linear") return Curvature::linear;
    if (shape == "convex") return Curvature::convex;
    if (shape == "general") return Curvature::general;
    throw InputError(
        fmt::format("{}: shape: found \"{}\"; allowed: \"linear\", \"convex\" or \"general\"", name, shape));
}

}  // namespace

MotionFormula formula_of(const py::object& rule) {
    const Functions functions{rule.attr("name").cast<std::string>(), shared(rule.attr("f")),
                              shared(rule.attr("gradient")), shared(rule.attr("hessian"))};
    const bool has_partials = !functions.gradient->is_none();
    return [functions, has_partials](const MotionPoint& point) {
        const py::gil_scoped_acquire lock;
        return has_partials ? by_hand(functions, point) : automatic(functions, point);
    };
}

OwnTerm own_term(const py::object& rule) {
    OwnTerm term;
    term.name = rule.attr("name").cast<std::string>();
    term.weight = rule.attr("weight").cast<double>();
    term.reference = rule.attr("reference").cast<double>();
    term.formula = formula_of(rule);
    term.shape = shape_of(term.name, rule.attr("shape").cast<std::string>());
    term.highest_order = rule.attr("highest_order").cast<int>();
    return term;
}

OwnLimit own_limit(const py::object& rule) {
    OwnLimit limit;
    limit.name = rule.attr("name").cast<std::string>();
    limit.limit = rule.attr("limit").cast<double>();
    limit.formula = formula_of(rule);
    limit.shape = shape_of(limit.name, rule.attr("shape").cast<std::string>());
    limit.highest_order = rule.attr("highest_order").cast<int>();
    limit.unit = rule.attr("unit").cast<std::string>();
    limit.size = rule.attr("size").cast<double>();
    return limit;
}

}  // namespace camopt::python

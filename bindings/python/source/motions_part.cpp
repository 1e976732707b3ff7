// SPDX-License-Identifier: MIT
// Motions, laws and peaks in Python.
#include "bindings/python/source/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <camopt/errors.hpp>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace camopt::python {

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

Side side_of(const std::string& side) {
    if (side == "left") return Side::left;
    if (side == "right") return Side::right;
    throw InputError(fmt::format("side: found \"{}\"; allowed: \"left\" or \"right\"", side));
}

/// One derivative of a motion, 0 … 3, seen from one side.
class Derivative {
 public:
    Derivative(const Motion& motion, int order, Side side) : motion_(motion), order_(order), side_(side) {
        if (order < 0 || order > 3)
            throw InputError(
                fmt::format("order: found {}; allowed: 0, 1, 2 or 3, the derivative of y", order));
    }

    [[nodiscard]] double at(double x) const {
        const double begin = motion_.begin(), end = motion_.end();
        if (!(x >= begin - rounding && x <= end + rounding))
            throw InputError(fmt::format("x: found {}; allowed: {} to {}", x, begin, end));
        return motion_.at(std::clamp(x, begin, end), side_).derivative[static_cast<std::size_t>(order_)];
    }

 private:
    static constexpr double rounding = 1e-12;  // of an x that was computed

    const Motion& motion_;
    int order_;
    Side side_;
};

py::object evaluate(const MotionValue& value, const Numbers& x, int order, const std::string& side) {
    const Derivative derivative(*value.motion, order, side_of(side));
    if (x.ndim() == 0) return py::float_(derivative.at(*x.data()));
    py::array_t<double> result(std::vector<py::ssize_t>(x.shape(), x.shape() + x.ndim()));
    const double* const from = x.data();
    double* const to = result.mutable_data();
    const py::ssize_t count = x.size();
    {
        const py::gil_scoped_release others_run;
        for (py::ssize_t i = 0; i < count; ++i) to[i] = derivative.at(from[i]);
    }
    return result;
}

py::array_t<double> array_of(const std::vector<double>& numbers) {
    return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

void add_peaks(py::module_& module) {
    py::class_<Extremum>(module, "Peak", "A largest magnitude and where it is reached.")
        .def_readonly("value", &Extremum::value, "The magnitude, without units; may be infinite.")
        .def_readonly("at", &Extremum::at, "x, the cam angle over that of the rise.")
        .def("__float__", [](const Extremum& peak) { return peak.value; })
        .def("__repr__",
             [](const Extremum& peak) { return fmt::format("Peak(value={}, at={})", peak.value, peak.at); });
    py::class_<Peaks>(
        module, "Peaks",
        "V, A, J = max |y'|, |y''|, |y'''| over x, the torque figure max |y' y''|, and root mean squares.\n\n"
        "Exact, also between samples; no units.")
        .def_readonly("velocity", &Peaks::velocity, "V, a Peak.")
        .def_readonly("acceleration", &Peaks::acceleration, "A, a Peak.")
        .def_readonly("jerk", &Peaks::jerk, "J, a Peak.")
        .def_readonly("torque", &Peaks::torque, "max |y' y''|, a Peak.")
        .def_readonly("rms_velocity", &Peaks::rms_velocity, "Square root of the mean of y'².")
        .def_readonly("rms_acceleration", &Peaks::rms_acceleration, "Square root of the mean of y''².")
        .def_readonly("rms_jerk", &Peaks::rms_jerk, "Square root of the mean of y'''².")
        .def("__repr__", [](const Peaks& peaks) {
            return fmt::format("Peaks(V={:.6g}, A={:.6g}, J={:.6g})", peaks.velocity.value,
                               peaks.acceleration.value, peaks.jerk.value);
        });
}

}  // namespace

void add_motions(py::module_& module) {
    add_peaks(module);
    py::class_<MotionValue>(
        module, "Motion",
        "A motion y(x) with its first three derivatives.\n\n"
        "x = cam angle / rise angle, y = displacement / lift; no units. Call it with numbers or arrays.")
        .def("__call__", &evaluate, py::arg("x"), py::arg("order") = 0, py::arg("side") = "right",
             "The derivative of that order (0 … 3) at x, in the shape of x.\n\n"
             "side: where a derivative jumps, its limit from the \"left\" or the \"right\". Raises "
             "InputError for an x\n"
             "outside [begin, end].")
        .def_property_readonly(
            "begin", [](const MotionValue& value) { return value.motion->begin(); }, "The least x.")
        .def_property_readonly(
            "end", [](const MotionValue& value) { return value.motion->end(); },
            "The largest x: 1 for DRD, 1 + return / rise for RR.")
        .def_property_readonly(
            "breakpoints", [](const MotionValue& value) { return array_of(value.motion->breakpoints()); },
            "Ascending x where a derivative may jump or change its formula, both ends included.");
    py::class_<LawValue, MotionValue>(module, "Law", "A classical motion law: a rise of 1 over 0 <= x <= 1.")
        .def_property_readonly(
            "key", [](const LawValue& law) { return law.law->key(); },
            "Its name in scenes: \"modified_sine\".")
        .def_property_readonly(
            "title", [](const LawValue& law) { return law.law->title(); }, "Its name in reports.")
        .def_property_readonly(
            "source", [](const LawValue& law) { return law.law->info().source; }, "Who described it.")
        .def_property_readonly(
            "continuity", [](const LawValue& law) { return law.law->continuity(); },
            "The highest derivative that is continuous everywhere, both ends included.")
        .def_property_readonly(
            "peaks", [](const LawValue& law) { return law.law->peaks(); },
            "Its exact Peaks; an impulse is an infinite jerk.")
        .def("__repr__", [](const LawValue& law) { return fmt::format("<camopt law {}>", law.law->key()); });
    module.def(
        "laws",
        [] {
            std::vector<std::string> keys;
            for (const LawInfo& law : law_catalogue()) keys.push_back(law.key);
            return keys;
        },
        "The names of all classical laws, in the order of the catalogue.");
    module.def(
        "law", [](const std::string& name) { return LawValue(make_law(name)); }, py::arg("name"),
        "The law of that name, with its customary parameters. Raises InputError for an unknown name.");
}

}  // namespace camopt::python

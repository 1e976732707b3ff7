// SPDX-License-Identifier: MIT
// Solving from Python: one scene, or neighbours one after another.
#include "bindings/python/source/parts.hpp"
#include "bindings/python/source/solved_scene.hpp"
#include "bindings/python/source/watch.hpp"
#include "studies/solve/solve_sequence.hpp"

#include <camopt/errors.hpp>
#include <camopt/solve.hpp>
#include <functional>
#include <mutex>
#include <pybind11/stl.h>
#include <string>
#include <utility>

namespace camopt::python {

namespace {

using Solve = std::function<Solution(const Scene&, const SolveControl&)>;

SolvedScene watched(const ReadScene& given, py::object progress, const Solve& solve_it) {
    Watch watch(std::move(progress));
    SolvedScene solved;
    solved.origin = given.origin();
    {
        const py::gil_scoped_release others_run;
        solved.solution = std::make_shared<const Solution>(solve_it(given.scene, watch.control()));
        watch.look_for_signals();
    }
    watch.raise_what_came("solution", py::cast(solved));
    return solved;
}

/// A warm sequence; one thread at a time.
class Sequence {
 public:
    SolvedScene solve(const ReadScene& given, py::object progress) {
        const std::unique_lock<std::mutex> turn(busy_, std::try_to_lock);
        if (!turn)
            throw InputError("this Solver is solving in another thread; allowed: one thread at a time");
        return watched(given, std::move(progress), [this](const Scene& scene, const SolveControl& control) {
            return sequence_.solve(scene, control);
        });
    }

 private:
    std::mutex busy_;
    SolveSequence sequence_;
};

}  // namespace

void add_solving(py::module_& module) {
    py::class_<ProgressValue>(module, "Progress", "How far a solve is. str() of it is its line.")
        .def_readonly("message", &ProgressValue::message, "One short line.")
        .def_readonly("round", &ProgressValue::round,
                      "Of the exchange of cam angles, from 1; None where unknown.")
        .def_readonly("incumbent", &ProgressValue::incumbent, "Objective of the best motion so far, or None.")
        .def_readonly("bound", &ProgressValue::bound, "Proved so far: no motion can pass it; or None.")
        .def_readonly("violation", &ProgressValue::violation,
                      "Of the incumbent, relative to each limit; <= 0: all are kept.")
        .def("__str__", [](const ProgressValue& now) { return now.message; })
        .def("__repr__", [](const ProgressValue& now) { return "Progress(" + now.message + ")"; });
    module.def(
        "solve",
        [](const ReadScene& given, py::object progress) {
            return watched(given, std::move(progress), [](const Scene& scene, const SolveControl& control) {
                return solve(scene, control);
            });
        },
        py::arg("scene"), py::arg("progress") = py::none(),
        "Solves a scene that was read. progress: called with a Progress now and then. Other threads run "
        "meanwhile.");
    py::class_<Sequence>(module, "Sequence",
                         "Neighbouring scenes one after another, each solved from what the last one found.")
        .def(py::init<>())
        .def("solve", &Sequence::solve, py::arg("scene"), py::arg("progress") = py::none(),
             "As solve(), but an infeasible scene is not explained: no relaxation is sought.");
}

}  // namespace camopt::python

// SPDX-License-Identifier: MIT
// Machines of several axes on one master, from Python.
#include "bindings/python/source/parts.hpp"
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "report/document/document_text.hpp"
#include "report/exports/workshop.hpp"
#include "report/json/certificate_json.hpp"
#include "report/machine/machine_document.hpp"
#include "report/machine/machine_folder.hpp"
#include "report/machine/machine_json.hpp"

#include <fmt/format.h>

#include <camopt/errors.hpp>
#include <camopt/units.hpp>
#include <filesystem>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace camopt::python {

namespace {

/// A machine's solution with the files it was read from, as Python holds it.
struct SolvedMachine {
    std::shared_ptr<const MachineSolution> solution;
    MachineRun run;
};

const MachineSolution& of(const SolvedMachine& machine) {
    return *machine.solution;
}

SolvedMachine solved_machine(const std::string& file, const std::vector<std::string>& settings,
                             std::optional<double> speed_gap, std::optional<double> max_seconds,
                             py::object progress) {
    MachineOptions options;
    options.speed_gap = speed_gap.value_or(options.speed_gap);
    options.max_seconds = max_seconds.value_or(options.max_seconds);
    const MachineSpec machine = input::read_machine(file, load_scene, settings);
    Watch watch(std::move(progress));
    SolvedMachine solved;
    try {
        const py::gil_scoped_release others_run;
        solved.solution =
            std::make_shared<const MachineSolution>(solve_machine(machine, options, watch.control()));
        watch.look_for_signals();
    } catch (const SceneError& error) {
        input::fail_in_machine(file, settings, machine, error.fault());
    }
    solved.run = machine_run(file, settings, "", *solved.solution);
    watch.raise_what_came("solution", py::cast(solved));
    return solved;
}

std::optional<double> rpm(std::optional<double> speed) {
    if (speed) *speed /= units::revolution_per_minute;
    return speed;
}

py::dict axis_solutions(const SolvedMachine& machine) {
    py::dict solutions;
    for (std::size_t b = 0; b < of(machine).axes.size(); ++b) {
        const RunOrigin& origin = machine.run.axes[b];
        SolvedScene axis{std::shared_ptr<const Solution>(machine.solution, &machine.solution->axes[b]),
                         origin};
        axis.given = py::cast(ReadScene(origin.scene_text, origin.scene_file, {}, {}));
        solutions[of(machine).spec.axes[b].name.c_str()] = py::cast(std::move(axis));
    }
    return solutions;
}

std::string machine_json_text(const SolvedMachine& machine) {
    return machine_json(of(machine), machine.run.machine, machine.run.axes);
}

/// None where nothing is delivered: there is nothing to draw.
std::optional<std::string> timing_picture(const SolvedMachine& machine) {
    const Document document = machine_document(of(machine));
    return document.curves() ? std::optional(curves_svg(document, *document.curves())) : std::nullopt;
}

void write_machine(const SolvedMachine& machine, const std::string& folder,
                   const std::vector<std::string>& plc) {
    write_machine_folder(folder, machine.run, *machine.solution,
                         controller_files(machine.solution->axes, plc));
}

}  // namespace

void add_machines(py::module_& module) {
    using Self = const SolvedMachine&;
    py::class_<SolvedMachine>(
        module, "MachineSolution",
        "What was found for a machine of several axes: its speed with the proof of what "
        "stops it, the motions.")
        .def_property_readonly(
            "verdict", [](Self self) { return name_of(of(self).certificate.verdict); },
            "\"optimal\", \"local\", \"feasible\", \"infeasible\" or \"failed\".")
        .def_property_readonly(
            "speed_rpm",
            [](Self self) {
                return rpm(of(self).axes.empty() ? std::nullopt : std::optional(of(self).speed));
            },
            "The speed of the motions delivered; None without any.")
        .def_property_readonly(
            "impossible_above_rpm", [](Self self) { return rpm(of(self).impossible_above); },
            "The speed at which it is proved that no motions exist; None without a proof.")
        .def_property_readonly(
            "at_standstill", [](Self self) { return of(self).at_standstill; },
            "Whether the machine contradicts itself at any speed.")
        .def_property_readonly(
            "fun",
            [](Self self) {
                return of(self).axes.empty() ? std::nullopt : std::optional(of(self).certificate.objective);
            },
            "The total objective; None where nothing is delivered.")
        .def_property_readonly("axes", &axis_solutions,
                               "A dict of one Solution an axis, by name; empty where there is none.")
        .def_property_readonly(
            "notes", [](Self self) { return of(self).notes; }, "Notes on the result.")
        .def_property_readonly(
            "seconds", [](Self self) { return of(self).seconds_total; }, "Wall time of the whole solve, s.")
        .def("to_json", &machine_json_text, "What `camopt machine --json` prints.")
        .def(
            "to_dict",
            [](Self self) {
                return py::module_::import("json").attr("loads")(machine_json_text(self)).cast<py::dict>();
            },
            "The same as a dict: limited_by, clearances, timing, the result of every axis.")
        .def(
            "summary", [](Self self) { return console_text(machine_document(of(self))); },
            "What `camopt machine` prints.")
        .def("svg", &timing_picture, "The timing diagram as SVG text; None where nothing is delivered.")
        .def("write", &write_machine, py::arg("folder"), py::arg("plc") = std::vector<std::string>{},
             "Writes the folder that `camopt machine --out` writes. plc: formats of electronic cams, for "
             "every axis.")
        .def("_repr_svg_", &timing_picture, "For notebooks: the timing diagram.")
        .def("__str__", [](Self self) { return console_text(machine_document(of(self))); })
        .def("__repr__", [](Self self) {
            return fmt::format("<camopt machine: {}>", name_of(of(self).certificate.verdict));
        });
    module.def(
        "solve_machine", &solved_machine, py::arg("file"), py::arg("settings"),
        py::arg("speed_gap") = py::none(), py::arg("max_seconds") = py::none(),
        py::arg("progress") = py::none(),
        "Solves a machine file with settings \"KEY=VALUE\", or \"AXIS.KEY=VALUE\" of the scene of an axis.");
}

}  // namespace camopt::python

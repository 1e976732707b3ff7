// SPDX-License-Identifier: MIT
// The classical laws beside the optimum, in Python.
#include "bindings/python/source/parts.hpp"
#include "bindings/python/source/watch.hpp"
#include "output/chart/studies/study_svg.hpp"
#include "output/json/study_json.hpp"

#include <fmt/format.h>

#include <camopt/comparison.hpp>
#include <camopt/words.hpp>
#include <pybind11/stl.h>
#include <utility>

namespace camopt::python {

namespace {

struct ComparedScene {
    Comparison comparison;
    RunOrigin origin;
};

ComparedScene compared(const ReadScene& given, py::object progress) {
    Watch watch(std::move(progress));
    ComparedScene result;
    result.origin = given.origin();
    {
        const py::gil_scoped_release others_run;
        result.comparison = compare(given.scene, watch.control());
        watch.look_for_signals();
    }
    watch.raise_what_came("comparison", py::cast(result));
    return result;
}

SolvedScene optimum(const ComparedScene& compared) {
    return {std::make_shared<const Solution>(compared.comparison.optimum), compared.origin};
}

}  // namespace

void add_comparisons(py::module_& module) {
    py::class_<ComparisonRow>(module, "ComparisonRow", "One law on the scene, or the optimum (an empty key).")
        .def_readonly("key", &ComparisonRow::key, "Of the law; empty: the optimum.")
        .def_readonly("title", &ComparisonRow::title, "For people.")
        .def_readonly("misfit", &ComparisonRow::misfit,
                      "Why the law cannot make this motion at all; mostly empty.")
        .def_property_readonly(
            "motion",
            [](const ComparisonRow& row) -> py::object {
                if (!row.motion) return py::none();
                return py::cast(MotionValue{row.motion});
            },
            "Its Motion on this scene; None where it does not fit.")
        .def_readonly("peaks", &ComparisonRow::peaks, "Its Peaks on this scene.")
        .def_readonly("fun", &ComparisonRow::objective, "The scene's objective of it; may be infinite.")
        .def_readonly("loss_percent", &ComparisonRow::loss_percent,
                      "Against the optimum; None where infinite.")
        .def_readonly("feasible", &ComparisonRow::feasible, "Whether it satisfies every limit.")
        .def("__repr__", [](const ComparisonRow& row) {
            return fmt::format("ComparisonRow({}, fun={:.6g})", row.is_optimum() ? "optimum" : row.key,
                               row.objective);
        });
    py::class_<ComparedScene>(module, "Comparison",
                              "Every classical law on one scene, compared with its optimum.")
        .def_property_readonly("optimum", &optimum, "The Solution.")
        .def_property_readonly(
            "rows", [](const ComparedScene& compared) { return compared.comparison.rows; },
            "A list of ComparisonRow, best first; laws that violate a limit come last.")
        .def(
            "to_json",
            [](const ComparedScene& compared) {
                return comparison_json(compared.comparison, compared.origin);
            },
            "What `camopt compare --json` prints.")
        .def(
            "summary", [](const ComparedScene& compared) { return comparison_text(compared.comparison); },
            "What `camopt compare` prints.")
        .def(
            "_repr_svg_", [](const ComparedScene& compared) { return comparison_svg(compared.comparison); },
            "For notebooks: a bar a law.")
        .def("__str__", [](const ComparedScene& compared) { return comparison_text(compared.comparison); });
    module.def("compare", &compared, py::arg("scene"), py::arg("progress") = py::none(),
               "Every classical law on a scene that was read, compared with its optimum.");
}

}  // namespace camopt::python

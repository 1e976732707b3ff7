// SPDX-License-Identifier: MIT
// Solving from Python: one scene, or neighbours one after another.
#include "bindings/python/source/parts.hpp"
#include "report/compare/comparison_document.hpp"
#include "report/document/document_text.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

#include <camopt/comparison.hpp>
#include <camopt/errors.hpp>
#include <camopt/scene_file.hpp>
#include <camopt/solve.hpp>
#include <camopt/words.hpp>
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
    solved.given = py::cast(given);  // the object of Python that it is
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
            return solve_without_explaining(scene, control, &known_);
        });
    }

 private:
    std::mutex busy_;
    KnownSolutions known_;
};

struct ComparedScene {
    Comparison comparison;
    RunOrigin origin;
    py::object given = py::none();
};

ComparedScene compared(const ReadScene& given, py::object progress) {
    Watch watch(std::move(progress));
    ComparedScene result;
    result.origin = given.origin();
    result.given = py::cast(given);
    {
        const py::gil_scoped_release others_run;
        result.comparison = compare(given.scene, watch.control());
        watch.look_for_signals();
    }
    watch.raise_what_came("comparison", py::cast(result));
    return result;
}

SolvedScene optimum(const ComparedScene& compared) {
    return {std::make_shared<const Solution>(compared.comparison.optimum), compared.origin, compared.given};
}

}  // namespace

ReadScene read_of(std::string text, std::string source, std::vector<std::string> settings,
                  const py::list& terms, const py::list& limits, bool alone) {
    OwnRules own;
    for (const py::handle term : terms)
        own.terms.push_back(own_term(py::reinterpret_borrow<py::object>(term)));
    for (const py::handle limit : limits)
        own.limits.push_back(own_limit(py::reinterpret_borrow<py::object>(limit)));
    own.alone = alone;
    ReadScene read(std::move(text), std::move(source), std::move(settings), std::move(own));
    read.terms = terms;
    read.limits = limits;
    return read;
}

void add_solving(py::module_& module) {
    py::class_<ProgressValue>(module, "Progress", "How far a solve is. str() of it is its line.")
        .def_readonly("message", &ProgressValue::message, "One short line.")
        .def_readonly("round", &ProgressValue::round,
                      "Of the exchange of cam angles, from 1; None where unknown.")
        .def_readonly("incumbent", &ProgressValue::incumbent, "Objective of the best motion so far, or None.")
        .def_readonly("bound", &ProgressValue::bound, "Lower bound proved so far, or None.")
        .def_readonly("violation", &ProgressValue::violation,
                      "Of the incumbent, relative to each limit; <= 0: all are satisfied.")
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
             "As solve(), but an infeasible scene is not explained: no relaxation is searched.");
}

// Scenes in Python: texts with settings, read and checked, and the keys they may have.
void add_scenes(py::module_& module) {
    py::class_<ReadScene>(module, "ReadScene",
                          "A scene that was read and checked; a constant. See camopt.Scene.")
        .def(py::init(&read_of), py::arg("text"), py::arg("source"), py::arg("settings"),
             py::arg("terms") = py::list(), py::arg("limits") = py::list(), py::arg("alone") = false,
             "Reads TOML and applies settings \"KEY=VALUE\" on top; terms, limits: camopt.OwnTerm,\n"
             "camopt.OwnLimit. alone: no built-in weight counts. Raises InputError where anything is wrong.")
        .def_readonly("text", &ReadScene::text, "The text as given.")
        .def_readonly("source", &ReadScene::source, "Its name in messages.")
        .def_readonly("settings", &ReadScene::settings, "What was set on top of it.")
        .def(py::pickle(
            [](const ReadScene& read) {
                return py::make_tuple(read.text, read.source, read.settings, read.terms, read.limits,
                                      read.own.alone);
            },
            [](const py::tuple& state) {
                return read_of(state[0].cast<std::string>(), state[1].cast<std::string>(),
                               state[2].cast<std::vector<std::string>>(), state[3], state[4],
                               state[5].cast<bool>());
            }))
        .def("toml", &ReadScene::toml, "One TOML text that reads back as this scene, bit for bit.");
    module.def(
        "settled_text",
        [](const std::string& text, const std::string& source, const std::vector<std::string>& settings) {
            return input::scene_with_overrides(text, source, settings);
        },
        py::arg("text"), py::arg("source"), py::arg("settings"),
        "The TOML of a text with settings on top; keys and values are not validated.");
    module.def(
        "read_text", [](const std::string& path) { return input::whole_scene_text(path); }, py::arg("path"),
        "The text of a scene file. Raises InputError where it cannot be read.");
    module.def(
        "scene_keys", [](const std::string& table) { return input::written_keys(table); },
        py::arg("table") = "",
        "Every key that a table of a scene (\"motion\", \"limits\", …; \"\" the top level) may have, as "
        "written.");
    module.def("scene_keys_markdown", &input::scene_keys_markdown,
               "Every key of a scene with its unit, range, default and meaning, as Markdown.");
}

// The classical laws beside the optimum, in Python.

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
    const auto text = [](const ComparedScene& compared) {
        return console_text(comparison_document(compared.comparison));
    };
    py::class_<ComparedScene>(module, "Comparison",
                              "Every classical law on one scene, compared with its optimum.")
        .def_property_readonly("optimum", &optimum, "The Solution.")
        .def_property_readonly(
            "rows", [](const ComparedScene& compared) { return compared.comparison.rows; },
            "A list of ComparisonRow, best first; laws that violate a limit come last.")
        .def(
            "to_json",
            [](const ComparedScene& compared) {
                return document_json(comparison_document(compared.comparison, compared.origin));
            },
            "What `camopt compare --json` prints.")
        .def("summary", text, "What `camopt compare` prints.")
        .def(
            "_repr_svg_",
            [](const ComparedScene& compared) {
                return chart_svg(*comparison_document(compared.comparison).pictures().front()->chart);
            },
            "For notebooks: a bar a law.")
        .def("__str__", text);
    module.def("compare", &compared, py::arg("scene"), py::arg("progress") = py::none(),
               "Every classical law on a scene that was read, compared with its optimum.");
}

}  // namespace camopt::python

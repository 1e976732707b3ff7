// SPDX-License-Identifier: MIT
// Scenes in Python: texts with settings, read and checked, and the keys they may have.
#include "bindings/python/source/own_rules.hpp"
#include "bindings/python/source/parts.hpp"
#include "bindings/python/source/read_scene.hpp"

#include <camopt/scene_file.hpp>
#include <pybind11/stl.h>
#include <utility>

namespace camopt::python {

namespace py = pybind11;

namespace {

ReadScene read_of(std::string text, std::string source, std::vector<std::string> settings,
                  const std::vector<py::object>& terms, const std::vector<py::object>& limits, bool alone) {
    OwnRules own;
    for (const py::object& term : terms) own.terms.push_back(own_term(term));
    for (const py::object& limit : limits) own.limits.push_back(own_limit(limit));
    own.alone = alone;
    return {std::move(text), std::move(source), std::move(settings), std::move(own)};
}

}  // namespace

void add_scenes(py::module_& module) {
    py::class_<ReadScene>(module, "ReadScene",
                          "A scene that was read and checked; a constant. See camopt.Scene.")
        .def(py::init(&read_of), py::arg("text"), py::arg("source"), py::arg("settings"),
             py::arg("terms") = py::list(), py::arg("limits") = py::list(), py::arg("alone") = false,
             "Reads TOML and applies settings \"KEY=VALUE\" on top; terms, limits: camopt.OwnTerm,\n"
             "camopt.OwnLimit. alone: no built-in weight counts. Raises InputError where anything is "
             "wrong.")
        .def_readonly("text", &ReadScene::text, "The text as given.")
        .def_readonly("source", &ReadScene::source, "Its name in messages.")
        .def_readonly("settings", &ReadScene::settings, "What was set on top of it.")
        .def("toml", &ReadScene::toml, "One TOML text that reads back as this scene, bit for bit.");
    module.def(
        "settled_text",
        [](const std::string& text, const std::string& source, const std::vector<std::string>& settings) {
            return input::scene_with_overrides(text, source, settings);
        },
        py::arg("text"), py::arg("source"), py::arg("settings"),
        "The TOML of a text with settings on top; keys and values are not looked at.");
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

}  // namespace camopt::python

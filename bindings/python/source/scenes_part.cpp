// SPDX-License-Identifier: MIT
// Scenes in Python: texts with settings, read and checked, and the keys they may have.
#include "bindings/python/source/parts.hpp"
#include "bindings/python/source/read_scene.hpp"

#include <camopt/scene_file.hpp>
#include <pybind11/stl.h>

namespace camopt::python {

namespace py = pybind11;

void add_scenes(py::module_& module) {
    py::class_<ReadScene>(module, "ReadScene",
                          "A scene that was read and checked; a constant. See camopt.Scene.")
        .def(py::init<std::string, std::string, std::vector<std::string>>(), py::arg("text"),
             py::arg("source"), py::arg("settings"),
             "Reads TOML and applies settings \"KEY=VALUE\" on top. Raises InputError where anything is "
             "wrong.")
        .def_readonly("text", &ReadScene::text, "The text as given.")
        .def_readonly("source", &ReadScene::source, "Its name in messages.")
        .def_readonly("settings", &ReadScene::settings, "What was set on top of it.")
        .def("toml", &ReadScene::toml, "One TOML text that reads back as this scene, bit for bit.");
    module.def(
        "read_text", [](const std::string& path) { return input::scene_file_text(path); }, py::arg("path"),
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

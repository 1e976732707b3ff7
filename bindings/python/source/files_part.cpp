// SPDX-License-Identifier: MIT
// The files of a solution in Python: drawings, solids, NC programs, electronic cams, reports.
#include "bindings/python/source/parts.hpp"
#include "core/text/list_text.hpp"
#include "input/keys/scene_keys.hpp"
#include "report/exports/exports.hpp"
#include "report/exports/workshop.hpp"

#include <fmt/format.h>

#include <camopt/errors.hpp>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace camopt::python {

namespace {

std::span<const KeyRow> option_rows() {
    return workshop() != nullptr ? workshop()->option_rows() : std::span<const KeyRow>();
}

/// Keywords as options.
ExportOptions options_of(const SolvedScene& solved, const py::kwargs& given) {
    ExportOptions options{.origin = solved.origin, .settings = {}};
    if (!given.empty()) (void)needed_workshop("options of files");
    for (const auto& [name, value] : given) {
        const auto key = name.cast<std::string>();
        if (input::match_key("", key, option_rows()).row == nullptr)
            throw py::type_error(
                fmt::format("found the option {}; allowed: {}", key,
                            listed(option_rows(), ", ", [](const KeyRow& row) { return row.first_key(); })));
        if (value.is_none()) continue;
        const bool is_word = py::isinstance<py::bool_>(value);
        options.settings.emplace_back(
            key, is_word ? (value.cast<bool>() ? "true" : "false") : py::str(value).cast<std::string>());
    }
    return options;
}

py::bytes file(const SolvedScene& solved, const std::string& name, const py::kwargs& given) {
    const ExportOptions options = options_of(solved, given);
    std::string bytes;
    {
        const py::gil_scoped_release others_run;
        bytes = exported_file(*solved.solution, name, options);
    }
    return bytes;
}

py::str text(const SolvedScene& solved, const std::string& name, const py::kwargs& given) {
    return file(solved, name, given).attr("decode")("utf-8");
}

std::vector<std::string> export_files(const SolvedScene& solved, const py::object& folder,
                                      const std::vector<std::string>& names, const py::kwargs& given) {
    const ExportOptions options = options_of(solved, given);
    const auto place = py::str(folder).cast<std::string>();
    const py::gil_scoped_release others_run;
    std::vector<std::string> written;
    for (const auto& path : write_exports(place, *solved.solution, names, options))
        written.push_back(path.string());
    return written;
}

/// report.html, report.md.
py::str report(const SolvedScene& solved, const std::string& format) {
    if (format != "md" && format != "html")
        throw InputError(fmt::format(R"(report: found "{}"; allowed: "md" or "html")", format));
    return text(solved, "report." + format, {});
}

std::string with_options(const char* words) {
    constexpr const char* more =
        "\n\nOptions are those of `camopt export` with _ for -: cutter_mm=12, direction=\"conventional\", "
        "bore_mm, post (a\nfile), points, … (`camopt list keys` lists them all). None is the default; "
        "lengths end in _mm, _in or _m.";
    return std::string(words) + more;
}

}  // namespace

void add_files(py::class_<SolvedScene>& type) {
    type.def(
            "files", [](const SolvedScene& s) { return export_names(*s.solution); },
            "The names of the files that file() and export() make of this solution: \"report.html\", "
            "\"codesys.st\",\n\"drawing.pdf\", \"cam.step\", \"cam.nc\", …")
        .def("file", &file, py::arg("name"),
             with_options(
                 "The bytes of one of files().\n\nRaises InputError for another name, an NC program "
                 "that its check refuses, a cam that is open or\nundercut; UnavailableError for STEP or "
                 "PDF in a build without the library.")
                 .c_str())
        .def("export", &export_files, py::arg("folder"), py::arg("names"),
             with_options("Writes some of files() into a folder, all or none; returns the paths. Raises as "
                          "file().")
                 .c_str())
        .def(
            "drawing",
            [](const SolvedScene& s, const std::string& format, const py::kwargs& options) {
                return file(s, "drawing." + format, options);
            },
            py::arg("format") = "pdf",
            "The workshop drawing of a disk cam or drum as bytes: \"pdf\", \"svg\" or \"dxf\", to scale, mm. "
            "Options "
            "bore_mm, thickness_mm.\n\nOf the second disk of a conjugate cam: file(\"drawing_second.pdf\").")
        .def(
            "nc", [](const SolvedScene& s, const py::kwargs& options) { return text(s, "cam.nc", options); },
            with_options(
                "The NC program of the cam as text (G-code), after its check. Raises InputError where the "
                "check finds a fault;\nfile(\"cam_nc_check.txt\") says what it found.")
                .c_str())
        .def(
            "step",
            [](const SolvedScene& s, const py::kwargs& options) {
                return text(s, step_name(*s.solution), options);
            },
            "STEP, as text, mm: a disk cam as a solid, the flanks of a three-dimensional cam as surfaces. "
            "Options bore_mm,\nthickness_mm. Raises UnavailableError in a build without Open CASCADE.")
        .def(
            "plc",
            [](const SolvedScene& s, const std::string& controller, const py::kwargs& options) {
                const std::string name = needed_workshop("electronic cams").controller(controller).file;
                return text(s, name, options);
            },
            py::arg("controller"),
            "The motion as an electronic cam, as text: of \"codesys\", \"twincat\", \"twincat7\", "
            "\"siemens\", \"br\", "
            "\"rockwell\", \"omron\",\n\"lenze\" or \"csv\". Master in deg, slave in mm or deg. Option "
            "points: evenly over the revolution; default: the joints of\nthe motion.")
        .def("report", &report, py::arg("format") = "md",
             "The report as text: \"md\" is report.md, Markdown, \"html\" is report.html, a page that needs "
             "nothing else.");
}

}  // namespace camopt::python

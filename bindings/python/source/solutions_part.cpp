// SPDX-License-Identifier: MIT
// What was found: the class Solution of Python.
#include "bindings/python/source/parts.hpp"
#include "report/exports/exports.hpp"
#include "report/exports/workshop.hpp"
#include "report/folders/result_folder.hpp"
#include "report/page/result_page.hpp"
#include "report/view/number_text.hpp"
#include "report/view/shown_units.hpp"

#include <fmt/format.h>

#include <camopt/drawings.hpp>
#include <camopt/errors.hpp>
#include <camopt/pictures.hpp>
#include <camopt/result_folder.hpp>
#include <camopt/result_json.hpp>
#include <camopt/tables.hpp>
#include <camopt/units.hpp>
#include <camopt/words.hpp>
#include <limits>
#include <optional>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <string>

namespace camopt::python {

namespace py = pybind11;

namespace {

const Solution& of(const SolvedScene& solved) {
    return *solved.solution;
}

/// A limit with the angle in degrees that people read it by.
struct ConstraintValue : ConstraintReport {
    double at_deg = 0.0;
};

std::vector<ConstraintValue> constraints(const SolvedScene& solved) {
    const double degrees = file_units(of(solved).scene).degrees_per_x;
    std::vector<ConstraintValue> rows;
    for (const ConstraintReport& row : of(solved).constraints) rows.push_back({row, row.at * degrees});
    return rows;
}

py::object dictionary(const SolvedScene& solved) {
    return py::module_::import("json").attr("loads")(result_json(of(solved), solved.origin));
}

const SplineCurve& curve(const SolvedScene& solved) {
    if (!of(solved).motion) throw InputError("a spline needs a motion, and this solution has none");
    if (!of(solved).curve)
        throw InputError(
            "one spline: found a program, whose segments have their own; allowed: DRD and RR. Its segments "
            "stand in to_dict()[\"segments\"]");
    return *of(solved).curve;
}

py::object bspline(const SolvedScene& solved) {
    const SplineCurve& spline = curve(solved);
    const std::vector<double> knots = spline.knots();
    return py::module_::import("scipy.interpolate")
        .attr("BSpline")(py::array_t<double>(static_cast<py::ssize_t>(knots.size()), knots.data()),
                         py::cast(spline.coefficients()), spline.degree(), false);
}

py::object value_of(const std::shared_ptr<const MotionChain>& motion) {
    if (!motion) return py::none();
    return py::cast(MotionValue{motion});
}

py::dict table(const SolvedScene& solved) {
    return columns_of_csv(motion_csv(of(solved)), std::numeric_limits<double>::infinity());
}

std::string profile_text(const SolvedScene& solved, std::optional<int> points) {
    return cam_view(of(solved), CamView::table, {.points = points});
}

py::dict profile(const SolvedScene& solved, std::optional<int> points) {
    return columns_of_csv(profile_text(solved, points), std::numeric_limits<double>::infinity());
}

std::string dxf(const SolvedScene& solved, double tolerance_mm) {
    return exported_file(of(solved), drawn_profile,
                         {.origin = {}, .settings = {{"tolerance_mm", round_trip_text(tolerance_mm)}}});
}

bool has_plane_cam(const SolvedScene& solved) {
    return has_cam_table(of(solved));
}

std::string cam_picture(const SolvedScene& solved) {
    return cam_view(of(solved), CamView::picture);
}

std::string picture(const SolvedScene& solved, const std::string& what) {
    if (what == "motion") return motion_svg(of(solved));
    if (what == "cam") return cam_picture(solved);
    throw InputError(fmt::format("svg: found \"{}\"; allowed: \"motion\" or \"cam\"", what));
}

py::object motion_picture(const SolvedScene& solved) {
    if (!of(solved).motion) return py::none();
    return py::str(motion_svg(of(solved)));
}

/// As its own image: the styles of two pictures in one page would meet.
std::string image(const std::string& svg) {
    const py::object encoded = py::module_::import("base64").attr("b64encode")(py::bytes(svg));
    return fmt::format("<img style=\"max-width:100%\" src=\"data:image/svg+xml;base64,{}\">",
                       encoded.attr("decode")("ascii").cast<std::string>());
}

std::string html(const SolvedScene& solved) {
    const py::object escape = py::module_::import("html").attr("escape");
    std::string text = fmt::format("<pre style=\"white-space:pre-wrap\">{}</pre>",
                                   escape(summary_text(of(solved))).cast<std::string>());
    if (of(solved).motion) text += image(motion_svg(of(solved)));
    if (has_plane_cam(solved)) text += image(cam_picture(solved));
    return text;
}

std::vector<std::string> write(const SolvedScene& solved, const std::string& folder,
                               std::optional<int> points, bool with_dxf) {
    std::vector<std::string> written;
    const View view(of(solved));
    WriteOptions options{.points = points};
    if (with_dxf) options.also = needed_workshop("profile.dxf").dxf_files(view);
    std::ranges::move(result_extras(view, solved.origin), std::back_inserter(options.also));
    for (const auto& path : write_result_folder(folder, view, solved.origin, options))
        written.push_back(path.string());
    return written;
}

std::optional<double> objective(const SolvedScene& solved) {
    if (!of(solved).motion) return {};
    return of(solved).certificate.objective;
}

void add_rows(py::module_& module) {
    py::class_<OwnTermReport>(module, "OwnTermValue", "The value of a user-defined cost term.")
        .def_readonly("name", &OwnTermReport::name, "Of the term.")
        .def_readonly("weight", &OwnTermReport::weight, "As given.")
        .def_readonly("reference", &OwnTermReport::reference, "As given.")
        .def_readonly("value", &OwnTermReport::value,
                      "Its largest along the motion, in its own unit; 0 where it is nowhere above.")
        .def_readonly("at", &OwnTermReport::at, "x.")
        .def("__repr__", [](const OwnTermReport& row) {
            return fmt::format("OwnTermValue({}={:.6g} at {:.4g})", row.name, row.value, row.at);
        });
    py::class_<ConstraintValue>(module, "Constraint",
                                "A limit of the scene, as written, and the value reached.")
        .def_readonly("name", &ConstraintValue::name, "\"velocity\", \"pressure_angle\", …")
        .def_readonly("key", &ConstraintValue::key, "As written: \"limits.velocity_mm_s\".")
        .def_readonly("limit", &ConstraintValue::limit, "In `unit`.")
        .def_readonly("worst", &ConstraintValue::worst, "The worst value over all cam angles, in `unit`.")
        .def_readonly("unit", &ConstraintValue::unit, "\"deg\", \"mm\", …; empty: none.")
        .def_readonly("at", &ConstraintValue::at, "x of the worst value.")
        .def_readonly("at_deg", &ConstraintValue::at_deg,
                      "The same as a cam angle from the start of the scene, in degrees.")
        .def_readonly("active", &ConstraintValue::active, "Whether the limit is reached.")
        .def_readonly("no_contact", &ConstraintValue::no_contact,
                      "There is no figure: the follower cannot touch the cam.")
        .def("__repr__", [](const ConstraintValue& row) {
            return fmt::format("Constraint({}: {:.6g} of {:.6g}{}{}{})", row.key, row.worst, row.limit,
                               row.unit.empty() ? "" : " ", row.unit, row.active ? ", active" : "");
        });
    py::class_<CompanionChange>(
        module, "CompanionChange",
        "A number that changes together with another one: the dwell that becomes shorter.")
        .def_readonly("key", &CompanionChange::key, "Of the scene.")
        .def_readonly("given", &CompanionChange::given, "As it is, in the unit of the key.")
        .def_readonly("solved", &CompanionChange::solved, "In the solve that found a motion.");
    py::class_<Relaxation>(module, "Relaxation",
                           "The least change of one number that makes an infeasible scene feasible.")
        .def_readonly("key", &Relaxation::key, "Of the scene.")
        .def_readonly("given", &Relaxation::given, "As it is, in the unit of the key.")
        .def_readonly("needed", &Relaxation::needed, "The boundary of feasibility; None if none was found.")
        .def_readonly("solved", &Relaxation::solved,
                      "`needed` rounded to the feasible side: a solve with it found a motion.")
        .def_readonly("ruled_out", &Relaxation::ruled_out, "It is proved that no value helps.")
        .def_readonly("also", &Relaxation::also, "What changes along with it: a list of CompanionChange.")
        .def("__repr__", [](const Relaxation& row) { return relaxation_sentence(row); });
    py::class_<SplineCurve>(module, "Spline", "The motion as one spline over x. See Solution.bspline.")
        .def_property_readonly("degree", &SplineCurve::degree, "3, 5 or 7.")
        .def_property_readonly("continuity", &SplineCurve::continuity, "The highest continuous derivative.")
        .def_property_readonly(
            "breakpoints",
            [](const SplineCurve& spline) { return py::array_t<double>(py::cast(spline.breakpoints())); },
            "Ascending x, both ends included.")
        .def_property_readonly(
            "knots", [](const SplineCurve& spline) { return py::array_t<double>(py::cast(spline.knots())); },
            "Clamped: degree + 1 fold at both ends.")
        .def_property_readonly("coefficients", &SplineCurve::coefficients, "Control points over `knots`.");
}

/// What the certificate says, and the search.
void add_verdict(py::class_<SolvedScene>& type) {
    type.def_property_readonly(
            "verdict", [](const SolvedScene& s) { return name_of(of(s).certificate.verdict); },
            "\"optimal\", \"local\", \"feasible\", \"infeasible\" or \"failed\".")
        .def_property_readonly(
            "success", [](const SolvedScene& s) { return of(s).motion != nullptr; },
            "Whether there is a motion that satisfies every limit.")
        .def_property_readonly(
            "message", [](const SolvedScene& s) { return verdict_sentence(of(s)); },
            "The verdict as a sentence.")
        .def_property_readonly(
            "reason", [](const SolvedScene& s) { return name_of(of(s).certificate.reason); },
            "Why the verdict is not better, one word; empty if there is no reason.")
        .def_property_readonly("fun", &objective, "The objective of the motion found; None without one.")
        .def_property_readonly(
            "bound", [](const SolvedScene& s) { return of(s).certificate.lower_bound; },
            "A proved lower bound of the objective; None without a proof.")
        .def_property_readonly(
            "gap", [](const SolvedScene& s) { return of(s).certificate.gap; },
            "(fun − bound) / max(1, |fun|); None without a proof.")
        .def_property_readonly(
            "proof", [](const SolvedScene& s) { return name_of(of(s).certificate.proof_kind); },
            "The kind of proof of the bound: \"duality\", \"any_curve_limit\", \"boxes\" or \"none\".")
        .def_property_readonly(
            "any_curve_limit",
            [](const SolvedScene& s) -> std::optional<double> {
                if (!of(s).any_curve_limit) return {};
                return of(s).any_curve_limit->objective;
            },
            "A lower bound for curves of any kind; None if unknown.")
        .def_property_readonly(
            "worst_violation", [](const SolvedScene& s) { return of(s).certificate.worst_violation; },
            "Of all limits over all cam angles, relative; <= 0: all are satisfied.")
        .def_property_readonly(
            "stationarity", [](const SolvedScene& s) { return of(s).certificate.stationarity; },
            "Norm of the gradient of the Lagrangian with the best multipliers; None where not computed.")
        .def_property_readonly(
            "solver", [](const SolvedScene& s) { return of(s).solver.name; }, "The backend that ran.")
        .def_property_readonly(
            "iterations", [](const SolvedScene& s) { return of(s).solver.iterations; }, "Of the backend.")
        .def_property_readonly(
            "convex", [](const SolvedScene& s) { return of(s).solver.convex; },
            "Whether the problem is convex: the optimum is then the global one.")
        .def_property_readonly(
            "seconds", [](const SolvedScene& s) { return of(s).seconds_total; },
            "Wall time of the whole solve, s.")
        .def_property_readonly(
            "notes", [](const SolvedScene& s) { return of(s).notes; }, "Notes on the result.")
        .def_property_readonly(
            "relaxation", [](const SolvedScene& s) { return of(s).relaxation; },
            "Of an infeasible scene: for each limit the least change of it alone that helps.");
}

void add_motion_of(py::class_<SolvedScene>& type) {
    type.def_property_readonly(
            "motion", [](const SolvedScene& s) { return value_of(of(s).motion); },
            "The Motion found, callable; None where nothing was found. Where the output is prescribed, the "
            "cam's.")
        .def_property_readonly(
            "output", [](const SolvedScene& s) { return value_of(of(s).output); },
            "The Motion of the output where dynamics.prescribe = \"output\"; None: it is `motion`.")
        .def_property_readonly(
            "peaks",
            [](const SolvedScene& s) -> std::optional<Peaks> {
                if (!of(s).motion) return {};
                return of(s).peaks;
            },
            "The exact Peaks of the motion, normalised as the scene's limits; None without a motion.")
        .def_property_readonly(
            "spline", [](const SolvedScene& s) { return of(s).curve; },
            "The motion as one Spline; None for a program and without a motion.")
        .def("bspline", &bspline,
             "The motion as a scipy.interpolate.BSpline of y over x. Needs SciPy; raises InputError for a "
             "program.")
        .def_property_readonly(
            "own_terms", [](const SolvedScene& s) { return of(s).own_terms; },
            "The user-defined terms, a list of OwnTermValue.")
        .def_property_readonly("constraints", &constraints, "Every limit of the scene, a list of Constraint.")
        .def_property_readonly(
            "drive",
            [](const SolvedScene& s) -> py::object {
                if (!of(s).drive) return py::none();
                return dictionary(s)["drive"];
            },
            "Torque, speed and power of the motor of [drive] as result.json has them; None without a motor.")
        .def_property_readonly(
            "valve",
            [](const SolvedScene& s) -> py::object {
                const auto all = py::cast<py::dict>(dictionary(s));
                return all.contains("valve") ? py::object(all["valve"]) : py::none();
            },
            "Events, durations, areas and accelerations of a valve lobe as result.json has them; None for "
            "other "
            "motions.")
        .def_property_readonly(
            "least",
            [](const SolvedScene& s) -> py::object {
                if (!of(s).least) return py::none();
                return py::cast<py::dict>(dictionary(s))["least"];
            },
            "How far the number of objective.least or largest went, as result.json has it: key, value,\n"
            "impossible, verdict, …; None where the scene seeks none.")
        .def("table", &table,
             "The motion as columns {name: array}: those of motion.csv, the unit in the name. 361 even cam "
             "angles, the\n"
             "breakpoints and the peaks; where the jerk jumps an angle stands twice.")
        .def("profile", &profile, py::arg("points") = py::none(),
             "The cam as columns {name: array}: those of profile.csv (cam_x_mm, pitch_x_mm, normal_x, …), in "
             "the frame of\n"
             "the cam.\n\n"
             "points: about so many, evenly by cam angle; None: a polyline through them is within 1 µm of "
             "the cam. A radius\n"
             "is infinite where the cam is straight. Raises InputError without a plane cam.");
}

void add_texts(py::class_<SolvedScene>& type) {
    type.def(
            "to_json", [](const SolvedScene& s) { return result_json(of(s), s.origin); },
            "The text of result.json: what `camopt solve --json` prints.")
        .def("to_dict", &dictionary,
             "The same as a dict: peaks and dimensions with units, segments, design, evaluations.")
        .def(
            "certificate", [](const SolvedScene& s) { return certificate_json(of(s).certificate); },
            "The text of certificate.json: the proof, from which the bound can be recomputed.")
        .def(
            "summary", [](const SolvedScene& s) { return summary_text(of(s)); },
            "What `camopt solve` prints.")
        .def("dxf", &dxf, py::arg("tolerance_mm") = 1e-3,
             "The cam as DXF text: arcs within the tolerance of the exact curve. Raises InputError without a "
             "plane cam.")
        .def("svg", &picture, py::arg("what") = "motion",
             "A picture as SVG text: of the \"motion\" or of the \"cam\".")
        .def("write", &write, py::arg("folder"), py::arg("points") = py::none(), py::arg("dxf") = false,
             "Writes the result folder that `camopt solve --out` writes; returns the paths.")
        .def("_repr_svg_", &motion_picture, "For notebooks: the picture of the motion.")
        .def("_repr_html_", &html, "For notebooks: the summary, the motion, the cam.")
        .def("__str__", [](const SolvedScene& s) { return summary_text(of(s)); })
        .def("__repr__", [](const SolvedScene& s) {
            return fmt::format("<camopt solution: {}>", objective_line(of(s), ", "));
        });
}

}  // namespace

void add_solutions(py::module_& module) {
    add_rows(module);
    py::class_<SolvedScene> type(
        module, "Solution",
        "What was found for a scene: the verdict, the proof, the motion, the cam, the files.");
    add_verdict(type);
    add_motion_of(type);
    add_texts(type);
    add_files(type);
    add_pickles(type);
}

}  // namespace camopt::python

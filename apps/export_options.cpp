// SPDX-License-Identifier: MIT
// Options of camopt export, and those that several commands share.
#include "apps/command_line.hpp"
#include "shop/plc/plc_format.hpp"

#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

/// Roughing, direction, ways in and out, words for the control.
void add_milling(CLI::App& command, CLI::Option& nc, ExportRequest& request) {
    const auto optional_number = [&](const char* name, std::optional<double>& target, const char* what) {
        add_option(command, name, target, "NUMBER", what)->needs(&nc);
    };
    const auto whole = [&](const char* name, std::optional<int>& target, const char* what) {
        add_option(command, name, target, "N", what)->needs(&nc);
    };
    const auto choice = [&](const char* name, std::string& target, const std::vector<std::string>& allowed,
                            const char* what) {
        add_option(command, name, target, "NAME", what)->needs(&nc)->check(CLI::IsMember(allowed));
    };
    optional_number("--rough-step-over-mm", request.rough_step_over_mm,
                    "Largest distance between two roughing passes; default: half the cutter's diameter");
    optional_number("--rough-step-down-mm", request.rough_step_down_mm,
                    "Largest depth of a roughing layer; default: half the cutter's diameter");
    optional_number(
        "--finish-allowance-mm", request.finish_allowance_mm,
        "What roughing leaves for the finishing pass, in addition to --stock-mm; default: 0.3, in a "
        "groove at most the clearance of the cutter");
    command
        .add_flag("--full-depth", request.full_depth,
                  "No roughing: the finishing pass cuts the full depth, and the program warns of the slot")
        ->needs(&nc);
    choice("--direction", request.direction, {"climb", "conventional"},
           "climb or conventional; default: climb; a cutter as large as a drum's roller cuts both");
    choice(
        "--spindle", request.spindle, {"clockwise", "counterclockwise"},
        "Direction of rotation, seen from the spindle: clockwise (M3, the default) or counterclockwise (M4)");
    choice("--compensation", request.compensation, {"none", "control"},
           "none (the default): the program is the path of the cutter's centre; control: of a plane cam, the "
           "contour with G41 or G42 and D");
    whole("--compensation-register", request.compensation_register,
          "D of G41 and G42; default: the tool's number, or 1");
    whole("--tool-number", request.tool_number,
          "Calls the tool (T, M6); default: no tool call, and the program notes this");
    optional_number(
        "--lead-mm", request.lead_mm,
        "Radius of the quarter circles into and out of a plane cam's contour; of a closed groove the "
        "length of the move to its flank; default: the cutter's radius");
    add_option(command, "--ramp-deg", request.ramp_deg, "NUMBER",
               "Ramp angle of the cutter along a drum's groove; 90: straight")
        ->needs(&nc)
        ->capture_default_str();
}

void add_nc(CLI::App& command, ExportRequest& request) {
    CLI::Option* const nc =
        command.add_flag("--nc", request.nc,
                         "Write the NC program, cam.nc, and what its check found; a program that "
                         "fails the check is not written, exit code 1");
    add_option(command, "--post", request.post, "FILE",
               "Post-processor (TOML, docs/nc.md); default: a generic one")
        ->needs(nc);
    const auto number = [&](const char* name, double& target, const char* what) {
        add_option(command, name, target, "NUMBER", what)->needs(nc)->capture_default_str();
    };
    add_option(command, "--cutter-mm", request.cutter_mm, "NUMBER",
               "Diameter of the cutter; default: the roller's, for plane cams 16")
        ->needs(nc);
    const auto optional_number = [&](const char* name, std::optional<double>& target, const char* what) {
        add_option(command, name, target, "NUMBER", what)->needs(nc);
    };
    optional_number("--blank-diameter-mm", request.blank_diameter_mm,
                    "Diameter of the blank; default: the cam's and the allowance on either side");
    optional_number("--blank-from-mm", request.blank_from_mm,
                    "Where the blank begins along the cam's axis, from the origin; default: where the cam "
                    "does, drums less the allowance");
    optional_number("--blank-to-mm", request.blank_to_mm, "Where the blank ends, likewise");
    number("--blank-allowance-mm", request.blank_allowance_mm,
           "Allowance of the blank over the cam where its size is not given: around it, for drums also at "
           "the ends");
    number("--clearance-mm", request.clearance_mm,
           "Height of the plane of rapids above the blank, at any angle of the table");
    number("--safe-mm", request.safe_mm, "Least distance of rapids from the blank; closer moves are feeds");
    number("--gouge-mm", request.gouge_mm,
           "A program that enters the finished cam deeper (apart from chords and printed digits) is refused");
    number("--stock-mm", request.stock_mm, "Left on the flanks for the next pass");
    number("--z-offset-mm", request.z_offset_mm, "Subtracted from Z on a machine with five axes");
    number("--chord-mm", request.chord_mm,
           "Largest deviation of the cutter from its path between two blocks");
    number("--feed-mm-min", request.feed_mm_min, "Feed of the cutter's tip in the cam");
    number("--rotary-deg-s", request.rotary_deg_s, "Largest speed of a rotary axis; 0: no limit");
    number("--spindle-rpm", request.spindle_rpm,
           "Spindle speed; 0: none is written, and the program notes this");
    add_milling(command, *nc, request);
}

}  // namespace

CLI::App& add_export(CLI::App& program, ExportRequest& request) {
    CLI::App& command = *program.add_subcommand("export",
                                                "Write the cam of a scene, which is solved, or of a result "
                                                "folder, which is used as it is, for CAD, CAM and machine");
    add_option(command, "WHAT", request.scene, "",
               "Scene file (TOML), or the folder that `camopt solve SCENE --out DIR` wrote: nothing is "
               "solved again");
    add_option(command, "--out", request.out, "DIR", "Write the files here")->required();
    CLI::Option* const csv =
        command.add_flag("--csv", request.csv,
                         "table.csv: the motion evenly by cam angle, with or without a cam; and points of "
                         "the cam: profile.csv, "
                         "guide.csv, of three-dimensional cams flanks.csv, both flanks with normals");
    add_option(command, "--lobe", request.lobe, "UNIT",
               "lobe.csv: a valve lobe by cam and crank angle from its nose, lifts in this unit")
        ->check(CLI::IsMember({"mm", "in"}));
    add_option(command, "--step-deg", request.step_deg, "NUMBER",
               "Step of table.csv, where --points is for the rest then, and of lobe.csv (default: 1)");
    add_option(
        command, "--columns", request.columns, "COLUMNS",
        "Columns of table.csv between commas, for example theta_deg,s_mm,v_mm_s,a_m_s2; default: angle, "
        "displacement, velocity, acceleration, jerk and, of plane cams, the pressure angle")
        ->needs(csv);
    constexpr int most_digits = 17;
    add_option(
        command, "--digits", request.digits, "N",
        "Significant digits in table.csv and lobe.csv; default: as many as read back to the same number")
        ->check(CLI::Range(1, most_digits));
    add_plc(command, request.plc);
    command.add_flag("--dxf", request.dxf, "profile.dxf: a plane cam for CAD, as arcs");
    add_option(command, "--drawing", request.sheet, "FORMAT",
               "drawing.svg, drawing.pdf, drawing.dxf: the workshop drawing of a plane cam, to scale "
               "on A4 or A3, with what [drawing] says")
        ->check(one_of(drawing_formats()));
    command.add_flag("--step", request.step,
                     "Solid of a plane cam, cam.step; both flanks of a three-dimensional cam as B-spline "
                     "surfaces, flanks.step");
    command.add_flag("--stl", request.stl,
                     "Solids: cam.stl of a plane cam; groove.stl and, of an indexing cam, cam.stl");
    command.add_flag("--picture", request.picture,
                     "cam.svg: a shaded picture; of plane cams profile.svg, mechanism.svg or guide.svg");
    constexpr int most_sections = 1000, most_angles = 100'000;
    add_option(command, "--sections", request.sections, "N", "Points of a flank along the roller; default: 9")
        ->check(CLI::Range(2, most_sections));
    add_option(command, "--points", request.points, "N",
               "Points over one revolution: of table.csv (default 361), of a cam's points (as many as "
               "it needs), of an electronic cam (the joints of the motion)")
        ->check(CLI::Range(least_points, most_angles));
    add_option(command, "--thickness-mm", request.thickness_mm, "NUMBER",
               "Thickness of a plane cam; default: drawing.thickness_mm, else 20")
        ->check(CLI::PositiveNumber);
    add_option(command, "--bore-mm", request.bore_mm, "NUMBER",
               "Diameter of a plane cam's bore; default: drawing.bore_mm, else no bore")
        ->check(CLI::PositiveNumber);
    add_nc(command, request);
    add_solving(command, request);
    add_units(command, request.units);
    return command;
}

CLI::Option* add_plc(CLI::App& command, std::vector<std::string>& formats) {
    return add_option(
               command, "--plc", formats, "FORMAT",
               fmt::format("Electronic cam for a controller, read back and judged, and plc.json: {}; several "
                           "between commas",
                           fmt::join(plc_format_keys(), ", ")))
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(one_of(plc_format_keys()));
}

}  // namespace camopt::apps

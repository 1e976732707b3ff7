// SPDX-License-Identifier: MIT
// The options of camopt export.
#include "apps/command_line.hpp"
#include "apps/shop/shop_commands.hpp"
#include "shop/exports/workshop_options.hpp"

#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

/// In the first unit of the row; in the others it is understood and not listed.
void add_row(CLI::App& command, const KeyRow& row, ExportRequest& request, CLI::Option* needed) {
    for (const Spelling& spelling : row.spellings) {
        const std::string key = row.key(spelling);
        std::string& target = request.options[key];
        CLI::Option* option = nullptr;
        if (row.type == KeyType::boolean)
            option = command.add_flag_callback(
                flag_of(key), [&target] { target = "true"; }, std::string(row.meaning));
        else
            option = command
                         .add_option(flag_of(key), target,
                                     fmt::format("{}; default: {}", row.meaning, row.default_text))
                         ->type_name(row.type == KeyType::integer  ? "N"
                                     : row.type == KeyType::number ? "NUMBER"
                                     : row.choices.empty()         ? "FILE"
                                                                   : "NAME");
        if (!row.choices.empty()) option->check(one_of({row.choices.begin(), row.choices.end()}));
        if (needed != nullptr) option->needs(needed);
        if (&spelling != &row.spellings.front()) option->group("");
    }
}

void add_nc(CLI::App& command, ExportRequest& request) {
    CLI::Option* const nc =
        command.add_flag("--nc", request.nc,
                         "Write the NC program, cam.nc, and what its check found; a program that "
                         "fails the check is not written, exit code 1");
    for (const KeyRow& row : workshop_rows(WorkGroup::program)) add_row(command, row, request, nc);
}

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
    constexpr int most_angles = 100'000;
    add_option(command, "--points", request.points, "N",
               "Points over one revolution: of table.csv (default 361), of a cam's points (as many as "
               "it needs), of an electronic cam (the joints of the motion)")
        ->check(CLI::Range(least_points, most_angles));
    for (const KeyRow& row : workshop_rows(WorkGroup::plate)) add_row(command, row, request, nullptr);
    add_nc(command, request);
    add_solving(command, request);
    add_units(command, request.units);
    return command;
}

}  // namespace

std::string flag_of(std::string key) {
    std::ranges::replace(key, '_', '-');
    return "--" + key;
}

void add_shop_commands(Commands& commands) {
    commands.add(add_export, export_command);
    commands.add_examples(
        "  camopt export drum.toml --out cam --stl --nc    surfaces, solids and the checked NC program\n"
        "  camopt export result --out cam --nc          the same from a result folder, without a solve\n"
        "  camopt export result --out cam --csv --columns theta_deg,s_mm,v_mm_s --points 721  a uniform "
        "table\n"
        "  camopt export result --out cam --plc codesys,siemens  electronic cams with their stated loss\n");
}

}  // namespace camopt::apps

// SPDX-License-Identifier: MIT
// The commands that every program has: solve, check, table.
#include "apps/command_line.hpp"
#include "apps/program_parts.hpp"

namespace camopt::apps {

namespace {

constexpr int most_points = 1'000'000;  // more is a slip of the keyboard: some hundred megabytes

CLI::App& add_solve(CLI::App& program, SolveRequest& request) {
    CLI::App& command = *program.add_subcommand("solve", "Find the best motion of a scene, with its proof");
    add_scene(command, request.scene);
    CLI::Option* const out = add_option(command, "--out", request.out, "DIR", "Write the result folder here");
    if (program_parts().dxf_files != nullptr)
        command.add_flag("--dxf", request.dxf, "Write the cam as profile.dxf too; with --out")->needs(out);
    add_option(command, "--points", request.points, "N",
               "Points of profile.csv, evenly by cam angle; default: as many as keep the chords within 1 "
               "micrometre of the cam; with --out")
        ->check(CLI::Range(least_points, most_points))
        ->needs(out);
    add_solving(command, request);
    add_units(command, request.units);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    return command;
}

CLI::App& add_check(CLI::App& program, CheckRequest& request) {
    CLI::App& command =
        *program.add_subcommand("check", "Parse and validate a scene and check its derivatives; no solve");
    add_scene(command, request.scene);
    add_settings(command, request.settings);
    add_option(command, "--write", request.write, "FILE",
               "Write the scene here, settings included: each key that differs from its default; a new file");
    add_units(command, request.units);
    command.add_flag("--json", request.json, "Print what was found as JSON and nothing else");
    return command;
}

CLI::App& add_table(CLI::App& program, TableRequest& request) {
    CLI::App& command =
        *program.add_subcommand("table", "Compute a published table again and prove every optimum");
    add_option(command, "WHAT", request.what, "", "spline-vs-modified-sine")
        ->required()
        ->check(one_of({"spline-vs-modified-sine"}));
    add_option(command, "--out", request.out, "DIR", "Write JSON, CSV, Markdown and the pictures here");
    command.add_flag("--json", request.json, "Print the table as JSON and nothing else");
    return command;
}

}  // namespace

void add_first_commands(Commands& commands) {
    commands.add(add_solve, solve_command);
    commands.add(add_check, check_command);
    commands.add(add_table, table_command);
    commands.add_examples(
        "  camopt solve scene.toml                      print the verdict, the objective and the peaks\n"
        "  camopt solve scene.toml --out results        and write the result folder\n");
    if (program_parts().dxf_files != nullptr)
        commands.add_examples(
            "  camopt solve scene.toml --out results --dxf  and the cam for CAD; --points 720 sets "
            "profile.csv\n");
    commands.add_examples(
        "  camopt solve scene.toml --json               print result.json and nothing else\n"
        "  camopt solve scene.toml --set spline.segments=24 --set limits.velocity=1.7\n"
        "  camopt solve scene.toml --solver ipopt       another backend; `camopt list solvers`\n"
        "  camopt check scene.toml                      validate the scene; no solve\n"
        "  camopt check scene.toml --write short.toml   and write it without what is default\n"
        "  camopt table spline-vs-modified-sine         the published table and the proved optima\n");
}

}  // namespace camopt::apps

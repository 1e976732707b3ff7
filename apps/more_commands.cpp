// SPDX-License-Identifier: MIT
// The commands of the whole program beside the first ones, and what shells and the build ask of it.
#include "apps/command_line.hpp"
#include "apps/program_parts.hpp"
#include "apps/shop/shop_commands.hpp"
#include "apps/studio/studio_page.hpp"
#include "apps/terminal.hpp"
#include "core/platform/console.hpp"
#include "core/text/text_file.hpp"
#include "report/exports/workshop.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

CLI::App& add_studio(CLI::App& program, StudioRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "studio", "A scene in a browser of this machine, with sliders and results to download");
    add_option(command, "SCENE", request.scene, "", "Scene file (TOML); default: a rise between two dwells");
    constexpr int first_free_port = 1024, last_port = 65535;
    CLI::Option* const port = add_option(command, "--port", request.port, "N",
                                         "Port of 127.0.0.1 to serve it on; default: any free one");
    port->check(CLI::Range(first_free_port, last_port));
    command
        .add_flag("--offline", request.offline,
                  "No server: open the page that holds the solver too, with the scene in it")
        ->excludes(port);
    add_settings(command, request.settings);
    return command;
}

CLI::App& add_compare(CLI::App& program, CompareRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "compare",
        "Every classical law on the same scene, compared with its optimum: losses and violated limits");
    add_scene(command, request.scene);
    add_option(command, "--out", request.out, "DIR",
               "Write comparison.csv, .json, .svg, .html and report.md here");
    add_solving(command, request);
    add_units(command, request.units);
    command.add_flag("--json", request.json, "Print the comparison as JSON and nothing else");
    return command;
}

CLI::App& add_dynamics(CLI::App& program, DynamicsRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "dynamics", "The elastic follower train over speed, under the optimum and under every classical law");
    add_option(command, "SCENE", request.scene, "", "Scene file (TOML) with a [dynamics] table");
    add_option(command, "--speeds", request.speeds, "RANGE",
               "FROM:TO:COUNT in rpm; default: about the scene's speeds");
    add_option(command, "--out", request.out, "DIR",
               "Write dynamics.csv, .json, .html, history.csv, report.md and pictures here");
    add_solving(command, request);
    command.add_flag("--json", request.json, "Print the table as JSON and nothing else");
    return command;
}

CLI::App& add_machine(CLI::App& program, MachineRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "machine", "Several axes on one master: the largest speed at which motions exist, with its proof");
    add_option(command, "FILE", request.scene, "", "Machine file (TOML)");
    CLI::Option* const out = add_option(command, "--out", request.out, "DIR",
                                        "Write machine.json and a result folder for each axis here");
    if (CLI::Option* const plc = add_plc(command, request.plc)) plc->needs(out);
    add_option(command, "--speed-gap", request.speed_gap, "G",
               "Relative gap of the largest speed; default: 0.001")
        ->check(CLI::Range(1e-7, 0.5));
    add_option(command, "--max-seconds", request.max_seconds, "S", "Time for everything; default: 60");
    add_settings(command, request.settings);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    return command;
}

CLI::App& add_inspect(CLI::App& program, InspectRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "inspect", "Compare a measured cam with its nominal one: deviations, best alignment, tolerance");
    add_option(command, "NOMINAL", request.scene, "", "Scene file (TOML) or result folder");
    add_option(command, "TABLE", request.table, "",
               "CSV file: theta_deg and s_mm of the follower; of a disk cam also x_mm and y_mm or r_mm and "
               "theta_deg")
        ->required();
    add_option(
        command, "--columns", request.columns, "NAMES",
        "Names of the columns in the order of the file, such as theta_deg,s_mm; default: in its first line");
    add_option(command, "--scale", request.scale, "NUMBERS",
               "What one unit of a cell is, of each column in the unit of its name; default: 1")
        ->delimiter(',');
    add_option(command, "--offset", request.offset, "NUMBERS",
               "Added to each column after --scale, in the unit of its name; default: 0")
        ->delimiter(',');
    add_option(command, "--tolerance-um", request.tolerance_um, "T",
               "Largest deviation allowed after alignment")
        ->check(CLI::PositiveNumber);
    add_option(command, "--probe-radius-mm", request.probe_radius_mm, "R",
               "Points are centres of a ball; default: 0")
        ->check(CLI::NonNegativeNumber);
    add_option(command, "--out", request.out, "DIR", "Write the report, the figures and the rows here");
    add_settings(command, request.settings);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    command.footer("Exit codes: 0 in tolerance, or none given; 1 out of tolerance; 2 wrong input.\n");
    return command;
}

CLI::App& add_valves(CLI::App& program, ValvesRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "valves", "Intake and exhaust lobe on one crankshaft: overlap, lobe separation, clearance");
    for (const auto& [name, target] : {std::pair{"INTAKE", &request.intake}, {"EXHAUST", &request.exhaust}})
        add_option(command, name, *target, "",
                   "Result folder, or scene file of a valve lobe with its centerline")
            ->required();
    CLI::Option* const gap =
        add_option(command, "--gap-mm", request.gap_mm, "G",
                   "Distance of the nearest edges of the shut valves: say the least clearance")
            ->check(CLI::PositiveNumber);
    add_option(command, "--included-deg", request.included_deg, "A",
               "Angle between the valves' axes; default: 0")
        ->check(CLI::Range(0.0, 179.0))
        ->needs(gap);
    add_option(command, "--out", request.out, "DIR",
               "Write the report, the lifts and the clearance over the crank angle here");
    add_units(command, request.units);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    command.footer("Exit codes: 0; 1 the valves touch; 2 wrong input.\n");
    return command;
}

CLI::App& add_report(CLI::App& program, ReportRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "report", "Write report.html, report.md and tables.csv of a result folder again; nothing is solved");
    add_option(command, "DIR", request.folder, "", "The folder that `camopt solve SCENE --out DIR` wrote")
        ->required();
    return command;
}

CLI::App& add_list(CLI::App& program, ListRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "list", "List laws, followers, solvers, keys of a scene, columns of a table or controllers");
    add_option(command, "WHAT", request.what, "",
               "The classical laws, the kinds of followers, the solvers, every key of a scene file, the "
               "columns of a uniform table, or the controllers of electronic cams")
        ->required()
        ->check(one_of(list_topics()));
    command.add_flag("--json", request.json, "Print the list as JSON and nothing else");
    return command;
}

constexpr const char* sweep_examples =
    "Examples:\n"
    "  camopt sweep scene.toml --weights simplex:20 --out map\n"
    "  camopt sweep scene.toml --weights weights.csv --vary spline.segments=8,16,32 --out map\n"
    "  camopt sweep scene.toml --vary cam.base_radius_mm=30:60:7 --vary limits.pressure_angle_deg=25:35:3 "
    "--out map\n"
    "  camopt sweep scene.toml --weights simplex:20 --out map --resume        continue after Ctrl-C\n"
    "  camopt sweep scene.toml --weights simplex:20 --out part1 --shard 1/2   on one machine\n"
    "  camopt sweep scene.toml --weights simplex:20 --out part2 --shard 2/2   on another\n"
    "  camopt sweep merge part1 part2 --out map                               and joined\n"
    "  mpirun camopt sweep scene.toml --weights simplex:20 --out map          by all ranks of a cluster\n"
    "  camopt sweep scene.toml --pareto velocity,acceleration --out front     a front by limits\n"
    "  camopt sweep scene.toml --surface 1e-4 --out surface                   all weights, proved to 1e-4\n"
    "  camopt sweep surface --at 0.4,0.4,0.2                                  looked up there\n"
    "\n"
    "Exit codes: 0 every row solved or infeasible; 1 a row failed, or standard output not written; 2 wrong "
    "input; 130 interrupted.\n";

void add_sweep_work(CLI::App& command, SweepRequest& request) {
    constexpr int most_workers = 1024;
    add_option(command, "--workers", request.workers, "N",
               "Threads that solve at the same time; default: one per core, under mpirun one per rank")
        ->check(CLI::Range(1, most_workers));
    add_option(command, "--chunk", request.chunk, "N",
               "Rows solved in sequence, each started from the previous result; the unit of --resume; "
               "default: 25, up to 500 where weights of a convex scene move fastest, fewer where that "
               "makes fewer than 16 chunks")
        ->check(CLI::Range(1, most_sweep_rows));
    add_option(command, "--shard", request.shard, "i/N", "Only every N-th chunk, from the i-th on");
    command.add_flag("--resume", request.resume, "Continue the sweep in the folder, or start a new one");
    command.add_flag(
        "--results", request.results,
        "Keep a result folder for every row too: rows/000017 in the folder, for the other commands and "
        "scripts/verify-certificate");
}

std::vector<std::string> traded_names() {
    std::vector<std::string> names;
    for (const CostTerm& term : cost_terms())
        if (term.traded) names.emplace_back(term.name());
    return names;
}

void add_pareto(CLI::App& command, ParetoWords& words) {
    CLI::Option* const pareto =
        add_option(command, "--pareto", words.goals, "FIRST,SECOND",
                   fmt::format("Trace the front of two goals by limits instead of weights: {}, or a variable "
                               "dimension",
                               fmt::join(traded_names(), ", ")));
    CLI::Option* const points = add_option(command, "--points", words.points, "N",
                                           "Points of the front, evenly spaced along it; default: 21")
                                    ->needs(pareto);
    add_option(command, "--spacing", words.spacing, "PART",
               "As many points as keep neighbours this close, in parts of the front's box, for example 0.05")
        ->needs(pareto)
        ->excludes(points);
    add_option(command, "--cut-off", words.cut_off, "TIMES",
               "End the front where one goal is this many times its minimum; default: 10")
        ->needs(pareto);
    command
        .add_flag("--keep-weights", words.keep_weights,
                  "Keep the scene's other weights together with the first goal")
        ->needs(pareto);
}

void add_surface(CLI::App& command, SurfaceWords& words) {
    CLI::Option* const surface =
        add_option(command, "--surface", words.error, "ERROR",
                   "All weights of velocity, acceleration and jerk: solve until the least "
                   "objective is proved to this error for all of them, for example 1e-4");
    add_option(command, "--most", words.most, "N", "Solves of the surface at most; default: 5000")
        ->needs(surface);
    add_option(command, "--at", words.at, "V,A,J",
               "SCENE is a folder of --surface: the objective at these weights, without a solve")
        ->excludes(surface);
}

ExitCode sweep_of(const SweepRequest& request) {
    if (!request.surface.at.empty()) return surface_look_up(request);
    if (request.surface.error) return surface_run(request);
    return request.pareto.goals.empty() ? sweep_command(request) : pareto_run(request);
}

CLI::App& add_sweep(CLI::App& program, SweepRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "sweep",
        "Many solves of one scene: weights, or any keys of it; into sweep.csv, with the Pareto front");
    add_scene(command, request.scene);
    add_option(command, "--weights", request.weights, "WEIGHTS",
               "simplex:N, all weights i/N, j/N, k/N of velocity, acceleration and jerk; or a CSV file "
               "whose first line names the weights");
    add_option(command, "--vary", request.vary, "KEY=VALUES",
               "Vary a key of the scene: KEY=a:b:count, KEY=a:b:count:log or KEY=v1,v2,…; several give "
               "the full grid")
        ->allow_extra_args(false);
    add_option(command, "--out", request.out, "DIR", "The folder of the sweep");
    add_solving(command, request);
    add_units(command, request.units);
    add_sweep_work(command, request);
    add_pareto(command, request.pareto);
    add_surface(command, request.surface);
    command.footer(sweep_examples);
    return command;
}

CLI::App& add_sweep_merge(CLI::App& sweep, SweepMergeRequest& request) {
    CLI::App& command = *sweep.add_subcommand("merge", "Join the folders of all shards of a sweep");
    add_option(command, "DIRS", request.parts, "", "Folders of the shards")->required();
    add_option(command, "--out", request.out, "DIR", "The folder of the whole sweep");
    return command;
}

}  // namespace

CLI::Option* add_plc(CLI::App& command, std::vector<std::string>& formats) {
    const std::vector<std::string> keys = controller_keys();
    if (keys.empty()) return nullptr;
    return add_option(
               command, "--plc", formats, "FORMAT",
               fmt::format("Electronic cam for a controller, read back and judged, and plc.json: {}; several "
                           "between commas",
                           fmt::join(keys, ", ")))
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(one_of(keys));
}

void add_more_commands(Commands& commands) {
    commands.add(add_studio, studio_command);
    commands.add(add_compare, compare_command);
    commands.add(add_dynamics, dynamics_command);
    commands.add(add_machine, machine_command);
    add_shop_commands(commands);
    commands.add(add_inspect, inspect_command);
    commands.add(add_valves, valves_command);
    commands.add(add_report, report_command);
    commands.add(add_list, list_command);
    CLI::App& sweep = commands.add(add_sweep, sweep_of);
    commands.add(add_sweep_merge, sweep_merge_command, &sweep);
    commands.add_examples(
        "  camopt compare scene.toml                    every classical law compared with the optimum\n"
        "  camopt dynamics scene.toml --speeds 100:600:101  the elastic follower over speed, optimum and "
        "laws\n"
        "  camopt sweep scene.toml --weights simplex:20 --out map    all weights of velocity, acceleration, "
        "jerk\n"
        "  camopt sweep scene.toml --vary cam.base_radius_mm=30:60:7 --out radii --resume\n"
        "  camopt machine cartoner.toml --out machine   the largest speed of several axes, with its proof\n"
        "  camopt inspect result measured.csv --tolerance-um 20    a measured cam against its nominal one\n"
        "  camopt studio scene.toml                     the scene in a browser, solved again for each "
        "slider\n"
        "  camopt report result                         its reports and tables.csv again, from the result "
        "folder\n"
        "  camopt list laws                             the classical laws with their peaks\n");
    commands.add_hidden("__complete", completion_text);
    commands.add_hidden("__manual", [](const CLI::App& program, auto) { return manual_page(program); });
    // scripts/offline_page
    commands.add_hidden("__offline_page", [](const CLI::App&, std::span<const char* const> words) {
        if (words.size() != 3)
            throw InputError("__offline_page: allowed: a page, its licences and the solver's module");
        return make_offline_page(read_text_file(words[0]), read_text_file(words[1]), words[2],
                                 [](const std::string& why) { print_error("no example: " + why + "\n"); });
    });
}

}  // namespace camopt::apps

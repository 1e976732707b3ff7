// SPDX-License-Identifier: MIT
#include "apps/command_line.hpp"

#include "apps/scene_loading.hpp"
#include "apps/studio/studio_page.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/ranges.h>

#include <exception>
#include <sstream>
#include <system_error>

namespace camopt::apps {

namespace {

const char* examples =
    "Examples:\n"
    "  camopt solve scene.toml                      print the verdict, the objective and the peaks\n"
    "  camopt solve scene.toml --out results        and write the result folder\n"
    "  camopt solve scene.toml --out results --dxf  and the cam for CAD; --points 720 sets profile.csv\n"
    "  camopt solve scene.toml --json               print result.json and nothing else\n"
    "  camopt solve scene.toml --set spline.segments=24 --set limits.velocity=1.7\n"
    "  camopt solve scene.toml --solver ipopt       another backend; `camopt list solvers`\n"
    "  camopt check scene.toml                      validate the scene; no solve\n"
    "  camopt compare scene.toml                    every classical law compared with the optimum\n"
    "  camopt dynamics scene.toml --speeds 100:600:101  the elastic follower over speed, optimum and laws\n"
    "  camopt sweep scene.toml --weights simplex:20 --out map    all weights of velocity, acceleration, "
    "jerk\n"
    "  camopt sweep scene.toml --vary cam.base_radius_mm=30:60:7 --out radii --resume\n"
    "  camopt machine cartoner.toml --out machine   the largest speed of several axes, with its proof\n"
    "  camopt export drum.toml --out cam --stl --nc    surfaces, solids and the checked NC program\n"
    "  camopt export result --out cam --nc          the same from a result folder, without a solve\n"
    "  camopt export result --out cam --csv --columns theta_deg,s_mm,v_mm_s --points 721  a uniform table\n"
    "  camopt export result --out cam --plc codesys,siemens  electronic cams with their stated loss\n"
    "  camopt inspect result measured.csv --tolerance-um 20    a measured cam against its nominal one\n"
    "  camopt studio scene.toml                     the scene in a browser, solved again for each slider\n"
    "  camopt report result                         report.html and report.md again, from the result folder\n"
    "  camopt list laws                             the classical laws with their peaks\n"
    "  camopt table spline-vs-modified-sine         the published table and the proved optima\n"
    "\n"
    "Exit codes: 0 optimal, local or feasible, interrupted or not; 1 failed, interrupted before a motion "
    "was found, or standard output not written (a full disk); 2 wrong input; 3 proved infeasible; 130 a "
    "sweep was interrupted.\n";

constexpr int most_points = 1'000'000;  // more is a slip of the keyboard: some hundred megabytes

struct Words {
    SolveRequest solve;
    StudioRequest studio;
    CompareRequest compare;
    DynamicsRequest dynamics;
    CheckRequest check;
    ExportRequest export_cam;
    InspectRequest inspect;
    ValvesRequest valves;
    ReportRequest report;
    ListRequest list;
    TableRequest table;
    SweepRequest sweep;
    SweepMergeRequest sweep_merge;
    MachineRequest machine;
};

void add_scene(CLI::App& command, std::string& scene) {
    add_option(command, "SCENE", scene, "", "Scene file (TOML)");
}

CLI::App& add_solve(CLI::App& program, SolveRequest& request) {
    CLI::App& command = *program.add_subcommand("solve", "Find the best motion of a scene, with its proof");
    add_scene(command, request.scene);
    CLI::Option* const out = add_option(command, "--out", request.out, "DIR", "Write the result folder here");
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
    add_option(command, "--out", request.out, "DIR", "Write comparison.csv, .json and .svg here");
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
               "Write dynamics.csv, .json, history.csv and pictures here");
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
    add_plc(command, request.plc)->needs(out);
    add_option(command, "--speed-gap", request.speed_gap, "G",
               "Relative gap of the largest speed; default: 0.001")
        ->check(CLI::Range(1e-7, 0.5));
    add_option(command, "--max-seconds", request.max_seconds, "S", "Time for everything; default: 60");
    add_settings(command, request.settings);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    return command;
}

CLI::App& add_check(CLI::App& program, CheckRequest& request) {
    CLI::App& command =
        *program.add_subcommand("check", "Parse and validate a scene and check its derivatives; no solve");
    add_scene(command, request.scene);
    add_settings(command, request.settings);
    add_units(command, request.units);
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
    add_option(command, "--tolerance-um", request.tolerance_um, "T",
               "Largest deviation allowed after alignment")
        ->check(CLI::PositiveNumber);
    add_option(command, "--probe-radius-mm", request.probe_radius_mm, "R",
               "Points are centres of a ball; default: 0")
        ->check(CLI::NonNegativeNumber);
    add_option(command, "--out", request.out, "DIR", "Write inspection.json, .csv, .svg and .html here");
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
    add_units(command, request.units);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    command.footer("Exit codes: 0; 1 the valves touch; 2 wrong input.\n");
    return command;
}

CLI::App& add_report(CLI::App& program, ReportRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "report", "Write report.html and report.md of a result folder again; nothing is solved");
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
               "Processes that solve at the same time; default: one per core, under mpirun one per rank")
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

/// The scene file of the command that runs, and the settings on top of it.
struct SceneWords {
    std::string file;
    std::vector<std::string> settings;
};

/// `--set a=1 b=2 scene.toml` is understood too: what has no '=' is the scene.
template <class Request>
void find_scene(Request& request, SceneWords& asked) {
    const auto plain = std::ranges::find_if(
        request.settings, [](const std::string& setting) { return setting.find('=') == std::string::npos; });
    if (request.scene.empty() && plain != request.settings.end()) {
        request.scene = *plain;
        request.settings.erase(plain);
    }
    if (request.scene.empty())
        throw InputError("the scene file is missing: camopt COMMAND SCENE; see camopt --help");
    asked = {request.scene, request.settings};
}

/// The command as it could be typed into a shell again.
std::string joined(int count, const char* const* words) {
    std::string line = "camopt";
    for (int i = 1; i < count; ++i) {
        std::string word = words[i];
        if (word.empty() || word.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#!~") != std::string::npos) {
            for (std::size_t place = 0; (place = word.find('\'', place)) != std::string::npos; place += 4)
                word.replace(place, 1, "'\\''");
            word.insert(0, 1, '\'');
            word += '\'';
        }
        line += ' ';
        line += word;
    }
    return line;
}

ExitCode complain(std::string_view what, ExitCode code) {
    print_error(fmt::format("camopt: {}\n", what));
    return code;
}

/// "camopt MAJOR.MINOR.PATCH" and under what terms this binary may be passed on.
std::string version_text() {
    std::string with;
    for (const LicensedPart& part : licensed_parts())
        if (part.name != "camopt")
            with += fmt::format("{}{} ({})", with.empty() ? "" : ", ", part.name, part.license);
    return fmt::format("camopt {}\nMIT license. With {}.\n{}", version(), with, terms_of_binary());
}

ExitCode parse_and_run(int count, const char* const* words, SceneWords& asked) {
    CLI::App program("camopt: the best motion curve for a cam, found and proved", "camopt");
    program.set_version_flag("--version", version_text());
    program.footer(examples);
    program.allow_windows_style_options(
        false);  // words are the same on every system; a path may begin with /
    program.require_subcommand(1);
    Words parsed;
    const CLI::App& solve = add_solve(program, parsed.solve);
    const CLI::App& studio = add_studio(program, parsed.studio);
    const CLI::App& compare = add_compare(program, parsed.compare);
    const CLI::App& dynamics = add_dynamics(program, parsed.dynamics);
    const CLI::App& machine = add_machine(program, parsed.machine);
    const CLI::App& check = add_check(program, parsed.check);
    const CLI::App& export_cam = add_export(program, parsed.export_cam);
    const CLI::App& inspect = add_inspect(program, parsed.inspect);
    const CLI::App& valves = add_valves(program, parsed.valves);
    const CLI::App& report = add_report(program, parsed.report);
    add_list(program, parsed.list);
    const CLI::App& table = add_table(program, parsed.table);
    CLI::App& sweep = add_sweep(program, parsed.sweep);
    const CLI::App& sweep_merge = add_sweep_merge(sweep, parsed.sweep_merge);
    // Not commands of people. The shells ask what could stand where the cursor is; the build writes the
    // manual, scripts/offline_page camopt.html.
    const std::string_view first = count > 1 ? words[1] : "";
    if (first == "__complete" || first == "__manual") {
        print(first == "__manual"
                  ? manual_page(program)
                  : completion_text(program, std::span(words + 2, static_cast<std::size_t>(count - 2))));
        return success;
    }
    if (first == "__offline_page" && count == 5) {
        print(make_offline_page(read_text_file(words[2]), read_text_file(words[3]), words[4],
                                [](const std::string& why) { print_error("no example: " + why + "\n"); }));
        return success;
    }
    try {
        program.parse(count, words);
    } catch (const CLI::Success& asked_for_help) {
        std::ostringstream text;
        const int status = program.exit(asked_for_help, text, text);
        print(text.str());
        return status == 0 ? success : failure;
    } catch (const CLI::ParseError& error) {
        const std::string unknown =
            count > 1 ? unknown_word(program, std::span(words + 1, static_cast<std::size_t>(count - 1))) : "";
        return complain(fmt::format("{} (see camopt --help)", unknown.empty() ? error.what() : unknown),
                        wrong_input);
    }
    refuse_empty_values(program);
    const auto run = [&](auto& request, const auto& command) {
        find_scene(request, asked);
        if constexpr (requires { request.command; }) request.command = joined(count, words);
        return command(request);
    };
    if (solve.parsed()) return run(parsed.solve, solve_command);
    if (studio.parsed() && parsed.studio.settings.empty()) return studio_command(parsed.studio);
    if (studio.parsed()) return run(parsed.studio, studio_command);
    if (compare.parsed()) return run(parsed.compare, compare_command);
    if (dynamics.parsed()) return run(parsed.dynamics, dynamics_command);
    if (machine.parsed()) return run(parsed.machine, machine_command);
    if (check.parsed()) return run(parsed.check, check_command);
    if (export_cam.parsed()) return run(parsed.export_cam, export_command);
    if (inspect.parsed()) return run(parsed.inspect, inspect_command);
    if (valves.parsed()) return valves_command(parsed.valves);
    if (report.parsed()) return report_command(parsed.report);
    if (table.parsed()) return table_command(parsed.table);
    if (sweep_merge.parsed()) return sweep_merge_command(parsed.sweep_merge);
    if (sweep.parsed()) return run(parsed.sweep, sweep_of);
    return list_command(parsed.list);
}

}  // namespace

ExitCode run_command_line(int count, const char* const* words) noexcept {
    SceneWords asked;
    try {
        return parse_and_run(count, words, asked);
    } catch (const SceneError& error) {
        return complain(placed_words(error, asked.file, asked.settings), wrong_input);
    } catch (const InputError& error) {
        return complain(error.what(), wrong_input);
    } catch (const std::system_error& error) {
        return complain(error.what(), failure);
    } catch (const std::exception& error) {
        return complain(fmt::format("internal error: {}", error.what()), failure);
    }
}

}  // namespace camopt::apps

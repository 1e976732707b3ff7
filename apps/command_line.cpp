// SPDX-License-Identifier: MIT
#include "apps/command_line.hpp"

#include "apps/commands.hpp"
#include "core/errors.hpp"
#include "output/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

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
    "  camopt check scene.toml                      is the scene right? No solve\n"
    "  camopt compare scene.toml                    every classical law beside the optimum\n"
    "  camopt list laws                             the classical laws with their peaks\n"
    "  camopt table spline-vs-modified-sine         the published table beside the proved optima\n"
    "\n"
    "Exit codes: 0 optimal, local or feasible; 1 failed; 2 wrong input; 3 proved infeasible.\n";

// Fewer do not make a cam; more than a file of some hundred megabytes holds is a slip of the keyboard.
constexpr int least_points = 16, most_points = 1'000'000;

struct Words {
    SolveRequest solve;
    CompareRequest compare;
    CheckRequest check;
    ListRequest list;
    TableRequest table;
};

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
    command
        .add_option("--set", settings,
                    "Replace one key of the scene: KEY=VALUE, for example spline.segments=24")
        ->type_name("KEY=VALUE");
}

CLI::App& add_solve(CLI::App& program, SolveRequest& request) {
    CLI::App& command = *program.add_subcommand("solve", "Find the best motion of a scene, with its proof");
    command.add_option("SCENE", request.scene, "Scene file (TOML)")->type_name("");
    CLI::Option* const out =
        command.add_option("--out", request.out, "Write the result folder here")->type_name("DIR");
    command.add_flag("--dxf", request.dxf, "Write the cam as profile.dxf too; with --out")->needs(out);
    command
        .add_option(
            "--points", request.points,
            "Points of profile.csv, evenly by cam angle; default: as many as keep the chords within 1 "
            "micrometre of the cam; with --out")
        ->type_name("N")
        ->check(CLI::Range(least_points, most_points))
        ->needs(out);
    command.add_option("--solver", request.solver, "Backend to use instead of the scene's")
        ->type_name("NAME");
    add_settings(command, request.settings);
    command.add_flag("--json", request.json, "Print the result as JSON and nothing else");
    return command;
}

CLI::App& add_compare(CLI::App& program, CompareRequest& request) {
    CLI::App& command = *program.add_subcommand(
        "compare", "Every classical law on the same scene, beside its optimum: losses and broken limits");
    command.add_option("SCENE", request.scene, "Scene file (TOML)")->type_name("");
    command.add_option("--out", request.out, "Write comparison.csv, .json and .svg here")->type_name("DIR");
    command.add_option("--solver", request.solver, "Backend to use instead of the scene's")
        ->type_name("NAME");
    add_settings(command, request.settings);
    command.add_flag("--json", request.json, "Print the comparison as JSON and nothing else");
    return command;
}

CLI::App& add_check(CLI::App& program, CheckRequest& request) {
    CLI::App& command =
        *program.add_subcommand("check", "Parse and validate a scene and check its derivatives; no solve");
    command.add_option("SCENE", request.scene, "Scene file (TOML)")->type_name("");
    add_settings(command, request.settings);
    return command;
}

CLI::App& add_list(CLI::App& program, ListRequest& request) {
    CLI::App& command = *program.add_subcommand("list", "What this camopt knows: laws, followers or solvers");
    command.add_option("WHAT", request.what, "laws, followers or solvers")
        ->type_name("")
        ->required()
        ->check(CLI::IsMember({"laws", "followers", "solvers"}));
    command.add_flag("--json", request.json, "Print the list as JSON and nothing else");
    return command;
}

CLI::App& add_table(CLI::App& program, TableRequest& request) {
    CLI::App& command =
        *program.add_subcommand("table", "A published table computed again, every optimum proved");
    command.add_option("WHAT", request.what, "spline-vs-modified-sine")
        ->type_name("")
        ->required()
        ->check(CLI::IsMember({"spline-vs-modified-sine"}));
    command.add_option("--out", request.out, "Write JSON, CSV, Markdown and the picture here")
        ->type_name("DIR");
    command.add_flag("--json", request.json, "Print the table as JSON and nothing else");
    return command;
}

/// `--set a=1 b=2 scene.toml` is understood too: what has no '=' is the scene.
void find_scene(std::string& scene, std::vector<std::string>& settings) {
    const auto plain = std::find_if(settings.begin(), settings.end(), [](const std::string& setting) {
        return setting.find('=') == std::string::npos;
    });
    if (scene.empty() && plain != settings.end()) {
        scene = *plain;
        settings.erase(plain);
    }
    if (scene.empty()) throw InputError("the scene file is missing: camopt COMMAND SCENE; see camopt --help");
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
    std::fputs(fmt::format("camopt: {}\n", what).c_str(), stderr);
    return code;
}

ExitCode parse_and_run(int count, const char* const* words) {
    CLI::App program("camopt: the best motion curve for a cam, found and proved", "camopt");
    program.set_version_flag("--version", fmt::format("camopt {}", version()));
    program.footer(examples);
    program.require_subcommand(1);
    Words parsed;
    const CLI::App& solve = add_solve(program, parsed.solve);
    const CLI::App& compare = add_compare(program, parsed.compare);
    const CLI::App& check = add_check(program, parsed.check);
    add_list(program, parsed.list);
    const CLI::App& table = add_table(program, parsed.table);
    try {
        program.parse(count, words);
    } catch (const CLI::Success& asked_for_help) {
        return program.exit(asked_for_help) == 0 ? success : failure;
    } catch (const CLI::ParseError& error) {
        return complain(fmt::format("{} (see camopt --help)", error.what()), wrong_input);
    }
    if (solve.parsed()) {
        find_scene(parsed.solve.scene, parsed.solve.settings);
        parsed.solve.command = joined(count, words);
        return solve_command(parsed.solve);
    }
    if (compare.parsed()) {
        find_scene(parsed.compare.scene, parsed.compare.settings);
        parsed.compare.command = joined(count, words);
        return compare_command(parsed.compare);
    }
    if (check.parsed()) {
        find_scene(parsed.check.scene, parsed.check.settings);
        return check_command(parsed.check);
    }
    if (table.parsed()) return table_command(parsed.table);
    return list_command(parsed.list);
}

}  // namespace

ExitCode run_command_line(int count, const char* const* words) noexcept {
    try {
        const ExitCode code = parse_and_run(count, words);
        if (std::fflush(stdout) != 0) return complain("cannot write to standard output", failure);
        return code;
    } catch (const InputError& error) {
        return complain(error.what(), wrong_input);
    } catch (const std::exception& error) {
        return complain(fmt::format("internal error: {}", error.what()), failure);
    }
}

}  // namespace camopt::apps

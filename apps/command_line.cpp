// SPDX-License-Identifier: MIT
#include "apps/command_line.hpp"

#include "apps/program_parts.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/text/list_text.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <exception>
#include <sstream>
#include <system_error>

namespace camopt::apps {

namespace {

const char* exit_codes =
    "Exit codes: 0 optimal, local or feasible, interrupted or not; 1 failed, interrupted before a motion "
    "was found, or standard output not written (a full disk); 2 wrong input; 3 proved infeasible; 130 a "
    "sweep was interrupted.\n";

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
        if (part.name != "camopt") append_item(with, fmt::format("{} ({})", part.name, part.license));
    return fmt::format("camopt {}\nMIT license. With {}.\n{}", version(), with, terms_of_binary());
}

/// A program that was built without some commands says so; empty: it has all.
std::string left_out(std::string_view before, std::string_view after) {
    const std::string_view words = program_parts().left_out;
    return words.empty() ? "" : fmt::format("{}{}{}", before, words, after);
}

/// The lines of the examples that call this command.
std::string examples_of(const std::string& command, const std::string& examples) {
    std::string found;
    std::istringstream lines(examples);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(fmt::format("  camopt {} ", command))) found += line + '\n';
    return found.empty() ? "" : fmt::format("Examples:\n{}\n", found);
}

void describe(CLI::App& program, const Commands& commands) {
    program.set_version_flag("--version", version_text());
    program.footer(
        fmt::format("Examples:\n{}\n{}{}", commands.examples(), exit_codes, left_out("Note: ", ".\n")));
    program.require_subcommand(1);
    for (CLI::App* const command : program.get_subcommands([](const CLI::App*) { return true; }))
        if (command->get_footer().empty())
            command->footer(examples_of(command->get_name(), commands.examples()) + exit_codes);
}

ExitCode parse_and_run(CLI::App& program, Commands& commands, int count, const char* const* words) {
    // Words are the same on every system, and a path may begin with /; commands take this over when they are
    // added.
    program.allow_windows_style_options(false);
    for (const auto add_group : program_parts().groups) add_group(commands);
    describe(program, commands);
    if (const auto* const text = count > 1 ? commands.hidden(words[1]) : nullptr) {
        print((*text)(program, std::span(words + 2, static_cast<std::size_t>(count - 2))));
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
        return complain(fmt::format("{} (see camopt --help){}", unknown.empty() ? error.what() : unknown,
                                    unknown.empty() ? "" : left_out("; ", "")),
                        wrong_input);
    }
    refuse_empty_values(program);
    return commands.run();
}

}  // namespace

// Options that several commands share.

void add_scene(CLI::App& command, std::string& scene) {
    add_option(command, "SCENE", scene, "", "Scene file (TOML)");
}

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
    add_option(command, "--set", settings, "KEY=VALUE",
               "Replace one key of the scene: KEY=VALUE, for example spline.segments=24");
}

void add_units(CLI::App& command, std::string& units) {
    add_option(command, "--units", units, "UNIT",
               "Lengths in reports: mm or in; default: as the scene is written. Data files keep "
               "the units in their columns")
        ->check(one_of({name_of(LengthUnit::millimetre), name_of(LengthUnit::inch)}));
}

ExitCode run_command_line(int count, const char* const* words) noexcept {
    CLI::App program("camopt: the best motion curve for a cam, found and proved", "camopt");
    Commands commands(program, joined(count, words));
    try {
        return parse_and_run(program, commands, count, words);
    } catch (const SceneError& error) {
        return complain(placed_words(error, commands.scene_file(), commands.settings()), wrong_input);
    } catch (const InputError& error) {
        return complain(error.what(), wrong_input);
    } catch (const std::system_error& error) {
        return complain(error.what(), failure);
    } catch (const std::exception& error) {
        return complain(fmt::format("internal error: {}", error.what()), failure);
    }
}

}  // namespace camopt::apps

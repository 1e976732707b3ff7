// SPDX-License-Identifier: MIT
// From the words of the command line to one command, what is wrong with them, completions and the manual
// page.
#pragma once

#include "apps/commands.hpp"

#include <CLI/CLI.hpp>

namespace camopt::apps {

/// Prints one line "camopt: …" to stderr and returns the code where something is wrong. Never throws.
[[nodiscard]] ExitCode run_command_line(int count, const char* const* words) noexcept;

// What is wrong with the words of a command line, told with what was probably meant.

/// "unknown command 'solv'; did you mean 'solve'?", "unknown option '--point' of camopt solve; did you mean
/// '--points'?"; empty where every word is known. Words after "--" are not looked at.
[[nodiscard]] std::string unknown_word(const CLI::App& program, std::span<const char* const> words);

/// Throws InputError for an option that was given an empty text: --out "" is a variable of a script that was
/// never set, not the wish for no folder.
void refuse_empty_values(const CLI::App& program);

/// For CLI::Option::check: one of these words, else an error with what was probably meant.
[[nodiscard]] CLI::Validator one_of(std::vector<std::string> words);

/// `type`: what stands for the value in the help; "": nothing.
template <class Value>
CLI::Option* add_option(CLI::App& command, const char* name, Value& target, const char* type,
                        const std::string& help) {
    return command.add_option(name, target, help)->type_name(type);
}

// Options that several commands share.

void add_settings(CLI::App& command, std::vector<std::string>& settings);
/// --plc.
CLI::Option* add_plc(CLI::App& command, std::vector<std::string>& formats);
void add_units(CLI::App& command, std::string& units);
/// How a command that solves may depart from the scene.
template <class Request>
void add_solving(CLI::App& command, Request& request) {
    add_option(command, "--solver", request.solver, "NAME", "Backend to use instead of the scene's");
    add_settings(command, request.settings);
}

/// Fewer do not make a cam.
inline constexpr int least_points = 16;

/// The command export.
CLI::App& add_export(CLI::App& program, ExportRequest& request);

// What could stand where the cursor is: `camopt __complete WORD …`, which the completions of bash, zsh and
// fish beside this file ask. The last word is the one being typed, empty where none is begun.
//
// The answer is lines: the words that fit, then at most one directive: ":folders", ":files", ":scenes" (files
// *.toml and folders), ":results" (those and result folders). A word that ends in '=' is to be typed on
// without a space.

/// Never throws for what is typed: where nothing fits the text is empty.
[[nodiscard]] std::string completion_text(const CLI::App& program, std::span<const char* const> words);

// The manual page camopt.1, from the commands and options themselves and the table of keys: `camopt __manual`
// prints it, the build writes it to a file.

/// In the man macros of roff, UTF-8.
[[nodiscard]] std::string manual_page(const CLI::App& program);

}  // namespace camopt::apps

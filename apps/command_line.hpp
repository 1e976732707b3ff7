// SPDX-License-Identifier: MIT
// From the words of the command line to one command, what is wrong with them, completions and the manual
// page. What commands there are says the program (apps/program_parts.hpp).
#pragma once

#include "apps/commands.hpp"
#include "core/errors.hpp"

#include <CLI/CLI.hpp>

#include <type_traits>

namespace camopt::apps {

/// The studio begins with a scene of its own.
template <class Request>
inline constexpr bool needs_scene = !std::is_same_v<Request, StudioRequest>;

/// The commands of a program, as its groups add them.
class Commands {
 public:
    /// line: the whole command as it could be typed again.
    Commands(CLI::App& program, std::string line) : program_(program), line_(std::move(line)) {}

    /// describe: adds the command with its options to the program, or to `inside`, and returns it; run: what
    /// it does. A command of a scene gets its file and its settings checked first.
    template <class Request>
    CLI::App& add(CLI::App& (*describe)(CLI::App&, Request&), ExitCode (*run)(const Request&),
                  CLI::App* inside = nullptr) {
        const auto request = std::make_shared<Request>();
        CLI::App& command = describe(inside != nullptr ? *inside : program_, *request);
        // The inner command is asked first: the outer one counts as given with it.
        commands_.insert(commands_.begin(),
                         {&command, [this, request, run] { return fill_and_run(*request, run); }});
        return command;
    }
    /// Lines of the examples in the help: "  camopt check scene.toml   validate the scene; no solve".
    void add_examples(std::string_view lines) { examples_ += lines; }
    /// A word in the place of a command that is not for people: it prints what `text` makes of the words
    /// behind it. A shell asks what could stand where the cursor is, the build what is in the manual.
    using HiddenText =
        std::function<std::string(const CLI::App& program, std::span<const char* const> words)>;
    void add_hidden(std::string_view word, HiddenText text) { hidden_.emplace(word, std::move(text)); }

    [[nodiscard]] const std::string& examples() const { return examples_; }
    /// Null where the word is none.
    [[nodiscard]] const HiddenText* hidden(std::string_view word) const {
        const auto found = hidden_.find(word);
        return found == hidden_.end() ? nullptr : &found->second;
    }
    /// Of the command that was given, once the words are parsed.
    [[nodiscard]] ExitCode run() const {
        for (const auto& [command, run] : commands_)
            if (command->parsed()) return run();
        return wrong_input;
    }

    // Of the command that runs, for what is found wrong with its scene later.
    [[nodiscard]] const std::string& scene_file() const { return scene_file_; }
    [[nodiscard]] const std::vector<std::string>& settings() const { return settings_; }

 private:
    template <class Request>
    ExitCode fill_and_run(Request& request, ExitCode (*run)(const Request&)) {
        if constexpr (requires { request.settings; }) find_scene(request);
        if constexpr (requires { request.command; }) request.command = line_;
        return run(request);
    }

    CLI::App& program_;
    std::string line_, examples_, scene_file_;
    std::vector<std::string> settings_;
    std::vector<std::pair<const CLI::App*, std::function<ExitCode()>>> commands_;
    std::map<std::string, HiddenText, std::less<>> hidden_;

    /// `--set a=1 b=2 scene.toml` is understood too: what has no '=' is the scene.
    template <class Request>
    void find_scene(Request& request) {
        const auto plain = std::ranges::find_if(request.settings, [](const std::string& setting) {
            return setting.find('=') == std::string::npos;
        });
        if (request.scene.empty() && plain != request.settings.end()) {
            request.scene = *plain;
            request.settings.erase(plain);
        }
        if (request.scene.empty() && (needs_scene<Request> || !request.settings.empty()))
            throw InputError("the scene file is missing: camopt COMMAND SCENE; see camopt --help");
        scene_file_ = request.scene;
        settings_ = request.settings;
    }
};

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

void add_scene(CLI::App& command, std::string& scene);
void add_settings(CLI::App& command, std::vector<std::string>& settings);
/// --plc; null in a build without controllers.
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

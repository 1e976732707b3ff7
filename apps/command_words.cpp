// SPDX-License-Identifier: MIT
#include "apps/command_line.hpp"
#include "core/errors.hpp"

#include <fmt/ranges.h>

namespace camopt::apps {

namespace {

std::vector<std::string> commands_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(inner->get_name());
    return names;
}

/// "--out", … of a command.
std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::string full_name(const CLI::App& command) {
    const CLI::App* const parent = command.get_parent();
    return parent ? full_name(*parent) + " " + command.get_name() : command.get_name();
}

const CLI::App* command_named(const CLI::App& command, const std::string& word) {
    for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; }))
        if (inner->get_name() == word) return inner;
    return nullptr;
}

}  // namespace

std::string unknown_word(const CLI::App& program, std::span<const char* const> words) {
    const CLI::App* command = &program;
    for (const char* const raw : words) {
        const std::string word = raw;
        if (word == "--") break;
        if (word.starts_with("--")) {
            const std::string name = word.substr(0, word.find('='));
            const std::vector<std::string> known = options_of(*command);
            if (std::ranges::find(known, name) != known.end()) continue;
            return fmt::format("unknown option '{}' of {}{}", name, full_name(*command),
                               spelling_hint(name, known));
        }
        if (const CLI::App* const inner = command_named(*command, word)) {
            command = inner;
            continue;
        }
        if (command != &program || word.starts_with('-')) continue;
        const std::vector<std::string> known = commands_of(program);
        return fmt::format("unknown command '{}'; allowed: {}{}", word, fmt::join(known, ", "),
                           spelling_hint(word, known));
    }
    return "";
}

void refuse_empty_values(const CLI::App& program) {
    for (const CLI::Option* option : program.get_options())
        for (const std::string& value : option->results())
            if (value.empty() && !option->get_lnames().empty())
                throw InputError(fmt::format(
                    "--{}: found an empty text; allowed: a value, or leave the option out (see {} --help)",
                    option->get_lnames().front(), full_name(program)));
    for (const CLI::App* inner : program.get_subcommands()) refuse_empty_values(*inner);
}

CLI::Validator one_of(std::vector<std::string> words) {
    const std::string list = fmt::format("{}", fmt::join(words, ", "));
    return {[words, list](std::string& word) {
                if (std::ranges::find(words, word) != words.end()) return std::string();
                return fmt::format("found '{}'; allowed: {}{}", word, list, spelling_hint(word, words));
            },
            list};
}

}  // namespace camopt::apps

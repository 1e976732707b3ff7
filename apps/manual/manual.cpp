// SPDX-License-Identifier: MIT
#include "apps/command_line.hpp"
#include "apps/list/described_keys.hpp"
#include "core/version.hpp"

#include <fmt/ranges.h>

#include <iterator>

namespace camopt::apps {

namespace {

/// What roff would obey is written out: '\', hyphens that people copy, a line that begins with '.' or "'".
std::string roff(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        const bool begins_line = escaped.empty() || escaped.back() == '\n';
        if (begins_line && (c == '.' || c == '\'')) escaped += "\\&";
        if (c == '\\')
            escaped += "\\e";
        else if (c == '-')
            escaped += "\\-";
        else
            escaped += c;
    }
    return escaped;
}

std::string section(std::string_view title) {
    return fmt::format(".SH {}\n", title);
}

std::string tagged(std::string_view tag, std::string_view text) {
    return fmt::format(".TP\n{}\n{}\n", tag, roff(text));
}

/// "N:INT in [16 - 1000]": what stands for the value, and what is allowed.
struct ValueWords {
    std::string name, allowed;
};
ValueWords value_words_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t colon = type.find(':');
    ValueWords words = {type.substr(0, colon), ""};
    if (option.get_items_expected_max() == 0) words.name.clear();
    if (colon != std::string::npos) words.allowed = type.substr(colon + 1);
    if (const std::size_t bracket = words.allowed.find("in ["); bracket != std::string::npos)
        words.allowed.erase(0, bracket + 3);
    return words;
}

std::string option_tag(const CLI::Option& option) {
    if (option.get_positional()) return fmt::format(".I {}", roff(option.get_name()));
    const ValueWords value = value_words_of(option);
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    if (value.name.empty()) return fmt::format(".B {}", roff(fmt::format("{}", fmt::join(names, ", "))));
    return fmt::format(".BI \"{} \" {}", roff(fmt::format("{}", fmt::join(names, ", "))), roff(value.name));
}

std::string option_text(const CLI::Option& option) {
    std::string text = option.get_description() + ".";
    const ValueWords value = value_words_of(option);
    if (!value.allowed.empty()) text += fmt::format(" Allowed: {}.", value.allowed);
    if (!option.get_default_str().empty()) text += fmt::format(" Default: {}.", option.get_default_str());
    if (option.get_required()) text += " Must be given.";
    for (const CLI::Option* needed : option.get_needs())
        text += fmt::format(" Needs {}.", needed->get_name());
    return text;
}

std::vector<const CLI::App*> commands_in(const CLI::App& command) {
    return command.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_in(const CLI::App& command) {
    return command.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

std::string usage_of(const CLI::App& command, const std::string& name) {
    std::string usage = fmt::format(".B {}\n", roff(name));
    std::string words = "[OPTION …]";
    for (const CLI::Option* option : options_in(command))
        if (option->get_positional()) words += " " + option->get_name();
    return usage + fmt::format(".I {}\n", roff(words));
}

/// A command, its words and options, then the commands inside it.
std::string command_text(const CLI::App& command, const std::string& parent) {
    const std::string name = parent + " " + command.get_name();
    std::string text = fmt::format(".SS \"{}\"\n{}.PP\n{}.\n", roff(name), usage_of(command, name),
                                   roff(command.get_description()));
    for (const CLI::Option* option : options_in(command))
        text += tagged(option_tag(*option), option_text(*option));
    for (const CLI::App* inner : commands_in(command)) text += command_text(*inner, name);
    return text;
}

/// Lines that keep their breaks and blanks.
std::string as_it_stands(std::string_view text) {
    return fmt::format(".nf\n{}.fi\n", roff(text));
}

/// What the help closes with: "Examples:" and its lines, an empty line, the exit codes.
struct Closing {
    std::string examples, exit_codes;
};
Closing closing_of(const CLI::App& command) {
    std::string footer = command.get_footer();
    const std::string heading = "Examples:\n";
    if (footer.starts_with(heading)) footer.erase(0, heading.size());
    const std::size_t gap = footer.find("\n\n");
    Closing closing = {footer.substr(0, gap) + "\n", ""};
    if (gap != std::string::npos) closing.exit_codes = footer.substr(gap + 2);
    return closing;
}

std::string keys_of(const DescribedKeys& file) {
    std::string text;
    const KeyRow* previous = nullptr;
    for (const KeyRow& row : file.rows) {
        if (!previous || previous->table != row.table)
            text += fmt::format(".SS \"{}\"\n", table_heading(row));
        std::vector<std::string> keys;
        std::ranges::transform(row.spellings, std::back_inserter(keys),
                               [&](const Spelling& spelling) { return row.key(spelling); });
        text += tagged(fmt::format(".B {}", roff(fmt::format("{}", fmt::join(keys, ", ")))),
                       fmt::format("{}; default: {}. {}", row.allowed(row.spellings.front()),
                                   row.default_text, row.meaning));
        previous = &row;
    }
    return text;
}

constexpr std::string_view description =
    "camopt reads a scene (one TOML file: motion, cam, objective and limits that must not be exceeded), "
    "finds the spline of least weighted peaks of velocity, acceleration and jerk, and proves a lower bound "
    "that no spline of that space can improve on. If no curve satisfies all limits it proves this and "
    "reports how much each would have to be relaxed. With a [cam] table motion and cam are designed "
    "together.";

constexpr std::string_view files =
    "With --out a folder is written: report.html, report.md and tables.csv, result.json, certificate.json "
    "(the proof, "
    "which can be "
    "recomputed from its own numbers), motion.csv and pictures; with a cam its profile and diagrams.";

}  // namespace

std::string manual_page(const CLI::App& program) {
    const Closing closing = closing_of(program);
    std::string page = fmt::format(
        ".\\\" SPDX-License-Identifier: MIT\n.TH CAMOPT 1 \"\" \"camopt {}\" \"User commands\"\n", version());
    page += section("NAME") + "camopt \\- the best motion curve for a cam, found and proved\n";
    page += section("SYNOPSIS");
    for (const CLI::App* command : commands_in(program))
        page += (command == commands_in(program).front() ? "" : ".br\n") +
                usage_of(*command, "camopt " + command->get_name());
    page += section("DESCRIPTION") + roff(description) + "\n";
    page += section("OPTIONS");
    for (const CLI::Option* option : options_in(program))
        page += tagged(option_tag(*option), option_text(*option));
    page += section("COMMANDS");
    for (const CLI::App* command : commands_in(program)) page += command_text(*command, "camopt");
    for (const DescribedKeys& file : described_keys()) {
        page += section(file.heading);
        if (file.name == "scene")
            page +=
                "Each quantity is written once, in one of its units; an entry of an array of tables is "
                "chosen by "
                "its number, from 0: motion.segments[1].to. The same list: camopt list keys.\n";
        page += keys_of(file);
    }
    page += section("FILES") + roff(files) + "\n";
    page += section("EXIT STATUS") + roff(closing.exit_codes);
    page += section("EXAMPLES") + as_it_stands(closing.examples);
    for (const CLI::App* command : commands_in(program))
        if (command->get_footer() != program.get_footer())
            page += ".PP\n" + as_it_stands(closing_of(*command).examples);
    return page;
}

}  // namespace camopt::apps

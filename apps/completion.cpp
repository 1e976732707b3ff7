// SPDX-License-Identifier: MIT
#include "apps/command_line.hpp"
#include "apps/studio/studio_controls.hpp"
#include "input/keys/scene_keys.hpp"
#include "report/exports/workshop.hpp"
#include "report/view/columns.hpp"

namespace camopt::apps {

namespace {

using input::KeyRow;
using input::KeyType;
using WordList = std::vector<std::string>;

/// The row of the table itself: of "motion.segments" the key "segments" of "motion".
const KeyRow* row_of_table(std::string_view table) {
    const std::size_t dot = table.rfind('.');
    if (dot == std::string_view::npos) return input::find_row("", table);
    return input::find_row(table.substr(0, dot), table.substr(dot + 1));
}

/// "motion."; an entry of an array of tables is chosen by its number: "motion.segments[0].".
std::string prefix_of(std::string_view table) {
    if (table.empty()) return "";
    const KeyRow* const row = row_of_table(table);
    return std::string(table) + (row && row->type == KeyType::tables ? "[0]." : ".");
}

/// Tables are none.
bool is_value(const KeyRow& row) {
    return row.type != KeyType::table && row.type != KeyType::tables && row.type != KeyType::options;
}

/// KEY= for every key; KEY=VALUE once the key is written and its values can be listed.
WordList setting_words(std::string_view typed) {
    WordList words;
    for (const KeyRow& row : input::scene_keys()) {
        if (!is_value(row)) continue;
        for (const auto& spelling : row.spellings) {
            const std::string key = prefix_of(row.table) + row.key(spelling) + "=";
            if (!typed.starts_with(key))
                words.push_back(key);
            else
                for (const std::string& value : values_of_key(row)) words.push_back(key + value);
        }
    }
    return words;
}

const CLI::Option* option_named(const CLI::App& command, std::string_view word) {
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            if (word == "--" + name) return option;
    return nullptr;
}

bool is_flag(const CLI::Option& option) {
    return option.get_items_expected_max() == 0;
}

/// The columns after those that are typed already.
WordList column_words(std::string_view typed) {
    const std::size_t comma = typed.rfind(',');
    const std::string before(comma == std::string_view::npos ? "" : typed.substr(0, comma + 1));
    WordList words;
    for (const TableColumn& column : table_columns()) words.push_back(before + column.key);
    return words;
}

/// By the word that --help shows for the value.
WordList value_words(const CLI::Option& option, std::string_view typed) {
    const std::string& type = option.get_type_name();
    if (type.starts_with("KEY=")) return setting_words(typed);
    if (type.starts_with("DIR")) return {":folders"};
    if (type.starts_with("FILE")) return {":files"};
    if (type.starts_with("WEIGHTS"))
        return {std::string_view("simplex:").starts_with(typed) ? "simplex:" : ":files"};
    if (option.check_lname("solver")) return solver_words();
    if (option.check_lname("plc")) return controller_keys();
    if (option.check_lname("columns")) return column_words(typed);
    return {};
}

WordList positional_words(const CLI::App& command) {
    if (command.get_name() == "list") return list_topics();
    if (command.get_name() == "table") return {"spline-vs-modified-sine"};
    if (command.get_name() == "export" || command.get_name() == "inspect" || command.get_name() == "valves")
        return {":results"};
    if (command.get_name() == "report") return {":folders"};
    if (command.get_name() == "merge") return {":folders"};
    if (command.get_name() == "machine") return {":scenes"};
    return {command.get_option_no_throw("SCENE") ? ":scenes" : ":files"};
}

const CLI::App* command_called(const CLI::App& command, std::string_view word) {
    for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; }))
        if (inner->get_name() == word) return inner;
    return nullptr;
}

WordList option_words(const CLI::App& command) {
    WordList words;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    return words;
}

WordList inner_command_words(const CLI::App& command) {
    WordList words;
    for (const CLI::App* inner : command.get_subcommands([](const CLI::App*) { return true; }))
        words.push_back(inner->get_name());
    return words;
}

/// Where the words before the cursor lead: the command, and the option whose value the cursor is in.
struct Position {
    const CLI::App* command = nullptr;
    const CLI::Option* option = nullptr;
    bool first_of_command = true;  ///< a command inside it may still be named
};

Position position_after(const CLI::App& program, std::span<const char* const> words) {
    Position position = {&program, nullptr, true};
    for (const char* const raw : words) {
        const std::string_view word = raw;
        if (word.starts_with("-")) {
            const CLI::Option* const option = option_named(*position.command, word);
            position.option = option && !is_flag(*option) ? option : nullptr;
            position.first_of_command = false;
        } else if (position.option) {
            position.option = nullptr;
        } else if (const CLI::App* const inner =
                       position.first_of_command ? command_called(*position.command, word) : nullptr) {
            position = {inner, nullptr, true};
        } else {
            position.first_of_command = false;
        }
    }
    return position;
}

WordList fitting_words(const CLI::App& program, std::span<const char* const> words) {
    const std::string_view typed = words.back();
    const Position position = position_after(program, words.first(words.size() - 1));
    if (position.option) return value_words(*position.option, typed);
    if (const std::size_t equals = typed.find('=');
        typed.starts_with("--") && equals != std::string_view::npos) {
        const CLI::Option* const option = option_named(*position.command, typed.substr(0, equals));
        WordList values = option ? value_words(*option, typed.substr(equals + 1)) : WordList();
        for (std::string& value : values)
            if (!value.starts_with(':')) value.insert(0, typed.substr(0, equals + 1));
        return values;
    }
    if (typed.starts_with("-")) return option_words(*position.command);
    WordList fitting = position.first_of_command ? inner_command_words(*position.command) : WordList();
    if (position.command == &program) return fitting;
    for (std::string& word : positional_words(*position.command)) fitting.push_back(std::move(word));
    return fitting;
}

}  // namespace

std::string completion_text(const CLI::App& program, std::span<const char* const> words) {
    if (words.empty()) return "";
    std::string text;
    for (const std::string& word : fitting_words(program, words))
        if (word.starts_with(words.back()) || word.starts_with(':')) text += word + "\n";
    return text;
}

}  // namespace camopt::apps

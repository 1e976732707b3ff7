// SPDX-License-Identifier: MIT
// A scene as text that can be changed: tables in the order of the file, each a list of key = value. Knows
// just the TOML that it writes itself: one value a line, no quoted keys, comments on lines of their own.
// Nothing of the library reads or writes it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace camopt::soak {

/// Seventeen digits: reads back as the same double.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string list_text(const std::vector<double>& values);
[[nodiscard]] std::string quoted(std::string_view word);

struct SceneTable {
    std::string name;
    bool repeated = false;  ///< [[name]]
    std::vector<std::pair<std::string, std::string>> members;

    [[nodiscard]] std::optional<std::string> find(std::string_view key) const;
    /// A text without its quotes.
    [[nodiscard]] std::string word(std::string_view key, std::string_view missing) const;
    void set(std::string_view key, std::string value);
    void set(std::string_view key, double value) { set(key, number_text(value)); }
    void erase(std::string_view key);
};

class SceneText {
 public:
    /// Throws std::runtime_error for a line it does not know.
    [[nodiscard]] static SceneText parse(std::string_view text);
    [[nodiscard]] std::string text() const;

    [[nodiscard]] bool has(std::string_view table) const { return find(table) != nullptr; }
    [[nodiscard]] const SceneTable* find(std::string_view table) const;
    /// The table, made where it is not there yet.
    SceneTable& at(std::string_view table);
    void erase(std::string_view table);
    SceneTable& append(std::string_view repeated_table);
    [[nodiscard]] std::vector<const SceneTable*> all(std::string_view repeated_table) const;
    [[nodiscard]] std::vector<SceneTable>& tables() { return tables_; }

    [[nodiscard]] std::optional<std::string> find(std::string_view table, std::string_view key) const;
    [[nodiscard]] std::string word(std::string_view table, std::string_view key,
                                   std::string_view missing) const;
    [[nodiscard]] double number(std::string_view table, std::string_view key, double missing) const;
    [[nodiscard]] std::vector<double> list(std::string_view table, std::string_view key) const;

    /// What is remembered of the trial, written as comments above the scene.
    std::vector<std::string> remarks;

 private:
    std::vector<SceneTable> tables_;
};

/// The members of an inline table or of each inline table of a list.
[[nodiscard]] SceneTable inline_table(std::string_view text);
[[nodiscard]] std::vector<SceneTable> inline_tables(std::string_view text);
[[nodiscard]] std::string inline_text(const SceneTable& table);
[[nodiscard]] std::string inline_text(const std::vector<SceneTable>& tables);

}  // namespace camopt::soak

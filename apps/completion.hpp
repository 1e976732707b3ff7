// SPDX-License-Identifier: MIT
// What could stand where the cursor is: `camopt __complete WORD …`, which the completions of bash, zsh and
// fish beside this file ask. The last word is the one being typed, empty where none is begun.
//
// The answer is lines: the words that fit, then at most one directive: ":folders", ":files", ":scenes" (files
// *.toml and folders), ":results" (those and result folders). A word that ends in '=' is to be typed on
// without a space.
#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>

namespace camopt::apps {

/// Never throws for what is typed: where nothing fits the text is empty.
[[nodiscard]] std::string completion_text(const CLI::App& program, std::span<const char* const> words);

}  // namespace camopt::apps

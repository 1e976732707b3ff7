// SPDX-License-Identifier: MIT
// What is wrong with the words of a command line, told with what was probably meant.
#pragma once

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <vector>

namespace camopt::apps {

/// "unknown command 'solv'; did you mean 'solve'?", "unknown option '--point' of camopt solve; did you mean
/// '--points'?"; empty where every word is known. Words after "--" are not looked at.
[[nodiscard]] std::string unknown_word(const CLI::App& program, std::span<const char* const> words);

/// Throws InputError for an option that was given an empty text: --out "" is a variable of a script that was
/// never set, not the wish for no folder.
void refuse_empty_values(const CLI::App& program);

/// For CLI::Option::check: one of these words, else an error with what was probably meant.
[[nodiscard]] CLI::Validator one_of(std::vector<std::string> words);

}  // namespace camopt::apps

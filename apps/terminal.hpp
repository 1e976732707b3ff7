// SPDX-License-Identifier: MIT
// The one way to the terminal: what it would obey instead of showing is written out
// (core/text/printable.hpp).
#pragma once

#include "core/platform/console.hpp"
#include "solvers/solver.hpp"

#include <filesystem>

namespace camopt::apps {

/// To standard output, all of it. Throws std::system_error where it does not take the text (a full disk, a
/// closed pipe): a text that is cut short must not end in exit code 0.
void print(std::string_view text);

/// "  wrote FILE", a line each.
[[nodiscard]] std::string written_lines(const std::vector<std::filesystem::path>& paths);

/// To standard error.
void print_error(std::string_view text);

// One line of progress on the terminal, overwritten in place.

/// A callback that writes to stderr; empty where stderr is not a terminal.
[[nodiscard]] std::function<void(std::string_view)> terminal_progress();

/// Wipes the line, so that what follows starts clean.
void end_progress();

// A long computation with its progress on the terminal, which Ctrl-C stops.

/// What compute(control, finished) returns; none where it was interrupted, for "the table" is incomplete
/// then, and that is said. What `finished` hears of is shown behind `words`.
template <class Compute>
auto interruptible_run(const std::string& what, const std::string& words, const Compute& compute) {
    const InterruptWatch watch;
    const auto progress = terminal_progress();
    const std::function<void(const std::string&)> finished = [&](const std::string& part) {
        if (progress) progress(words + part);
    };
    std::optional result = compute(SolveControl{InterruptWatch::interrupted, {}}, finished);
    end_progress();
    if (!InterruptWatch::interrupted()) return result;
    print_error("camopt: interrupted; " + what + " is incomplete and was not written\n");
    result.reset();
    return result;
}

}  // namespace camopt::apps

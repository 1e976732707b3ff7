// SPDX-License-Identifier: MIT
// What only the operating system knows of a program's words, its terminal, its end and its desktop.
#pragma once

#include "core/base/standard.hpp"

#include <filesystem>

namespace camopt {

/// The words of the command line in UTF-8, with a console that shows UTF-8 and obeys escape sequences. First
/// in main().
[[nodiscard]] std::vector<std::string> program_words(int count, char** words);

/// Standard error is a terminal.
[[nodiscard]] bool error_is_terminal();

/// Asks the file system as closing standard output would: some report a full disk only then. False: errno has
/// the reason.
[[nodiscard]] bool output_is_taken();

/// Where the running program's file lies; empty where the system does not say.
[[nodiscard]] std::filesystem::path program_folder();

/// Opens a page on this machine as a double click would. False: there is no desktop that could.
bool open_in_browser(const std::filesystem::path& page);

// Ctrl-C during a solve, or the termination that job schedulers send: the first asks the solver to stop and
// deliver the best point it has, so that the files that were begun are finished or removed; the second ends
// the program at once.

/// Watches as long as it lives; then the previous behaviour returns.
class InterruptWatch {
 public:
    /// hangup_too: also the end of the terminal.
    enum class Signals { termination, hangup_too };

    explicit InterruptWatch(Signals signals = Signals::termination);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    [[nodiscard]] static bool interrupted();
};

}  // namespace camopt

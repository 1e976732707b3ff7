// SPDX-License-Identifier: MIT
// A table on standard output that is cut short (a full disk) must not pass for a whole one.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace camopt::benchmarks {

/// The first line of main: at its end all of standard output is written, or the exit code is 1.
class WholeOutput {
 public:
    WholeOutput() = default;
    ~WholeOutput() {
        const bool failed = std::ferror(stdout) != 0;
        if (std::fflush(stdout) == 0 && !failed) return;
        std::fputs("cannot write to standard output\n", stderr);
        std::_Exit(1);
    }
    WholeOutput(const WholeOutput&) = delete;
    WholeOutput& operator=(const WholeOutput&) = delete;
};

}  // namespace camopt::benchmarks

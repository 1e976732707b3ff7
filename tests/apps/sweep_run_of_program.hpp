// SPDX-License-Identifier: MIT
// A camopt that runs beside the test, to be killed at a chosen moment; and what a sweep leaves.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace camopt::test {

class RunningProgram {
 public:
    /// Starts camopt; its output goes to FOLDER.out and FOLDER.err beside the sweep's folder.
    RunningProgram(const std::vector<std::string>& arguments, const std::string& log);
    ~RunningProgram();  ///< kills it where it still runs
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    void send(int signal) const;
    [[nodiscard]] bool runs();
    /// Its exit code, or 128 + the signal that killed it, as a shell says it.
    [[nodiscard]] int wait();
    [[nodiscard]] std::vector<pid_t> children() const;

 private:
    pid_t process_ = -1;
    int status_ = 0;
};

/// sweep.csv without the time columns, lines sorted.
[[nodiscard]] std::vector<std::string> timeless_rows(const std::string& folder);

/// How many chunks are finished in the folder.
[[nodiscard]] int chunk_count(const std::string& folder);

}  // namespace camopt::test

// SPDX-License-Identifier: MIT
// The commands of camopt, one file each (<name>_command.cpp). They return the exit code, print results to
// stdout, and throw InputError for what the user got wrong.
#pragma once

#include "apps/exit_code.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt::apps {

struct SolveRequest {
    std::string scene;                  ///< file
    std::string out;                    ///< folder; empty: nothing is written
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::optional<int> points;          ///< of profile.csv; none: by chord tolerance
    bool dxf = false;                   ///< write profile.dxf too
    bool json = false;
    std::string command;  ///< the whole command line, for the record
};
[[nodiscard]] ExitCode solve_command(const SolveRequest& request);

struct CompareRequest {
    std::string scene;                  ///< file
    std::string out;                    ///< folder; empty: nothing is written
    std::string solver;                 ///< replaces solver.name; empty: the scene's
    std::vector<std::string> settings;  ///< KEY=VALUE
    bool json = false;
    std::string command;  ///< the whole command line, for the record
};
[[nodiscard]] ExitCode compare_command(const CompareRequest& request);

struct CheckRequest {
    std::string scene;
    std::vector<std::string> settings;
};
[[nodiscard]] ExitCode check_command(const CheckRequest& request);

struct ListRequest {
    std::string what;  ///< "laws", "followers" or "solvers"
    bool json = false;
};
[[nodiscard]] ExitCode list_command(const ListRequest& request);

struct TableRequest {
    std::string what;  ///< "spline-vs-modified-sine"
    std::string out;   ///< folder; empty: nothing is written
    bool json = false;
};
[[nodiscard]] ExitCode table_command(const TableRequest& request);

}  // namespace camopt::apps

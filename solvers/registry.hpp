// SPDX-License-Identifier: MIT
// Which backends there are, which of them this build has, and what options each takes.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/solver.hpp"

namespace camopt {

/// One option of a backend. `kind`: "bool", "integer", "number" or "text"; `range` in words.
struct NativeOption {
    std::string name, kind, default_value, range, meaning;
};

struct SolverEntry {
    std::string name;         ///< "structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla"
    std::string method;       ///< one line: what algorithm, for which problems
    bool available = false;   ///< built into this camopt
    std::string version;      ///< of the library behind it, empty where absent
    std::string remedy;       ///< where absent: which package to install
    bool gives_multipliers = false;
    bool needs_convex = false;
    std::vector<NativeOption> options;
};

/// Every backend camopt knows, built in or not, in the order of the documentation.
[[nodiscard]] std::span<const SolverEntry> solver_entries();

/// Throws InputError with the list of names for an unknown one, UnavailableError with the remedy for one that
/// this build leaves out.
[[nodiscard]] std::unique_ptr<Solver> make_solver(std::string_view name);

/// Throws InputError for a native option that the backend does not have or whose value it cannot take.
void check_native_options(std::string_view solver, const std::map<std::string, OptionValue>& options);

}  // namespace camopt

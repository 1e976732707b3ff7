// SPDX-License-Identifier: MIT
// The backends, which of them this build has, and the options of each.
#pragma once

#include "solvers/solver.hpp"

namespace camopt {

/// One option of a backend. `kind`: "bool", "integer", "number" or "text"; `range` in words, made from the
/// members below it, which are used to validate a value (solvers/backend_support.hpp builds all of it).
struct NativeOption {
    std::string name, kind, default_value, range, meaning;
    double minimum = -infinity, maximum = infinity;  ///< of an integer or a number
    bool minimum_excluded = false;                   ///< the number must be greater than `minimum`
    std::vector<std::string> choices{};              ///< of a text
    std::vector<std::string> absent{};               ///< of these, those that this build does not have
    std::string remedy{};                            ///< for these: which package to install
};

struct SolverEntry {
    std::string name;        ///< "structured", "ipopt", "nlopt.slsqp", "nlopt.auglag.lbfgs", …
    std::string method;      ///< one line: what algorithm, for which problems
    bool available = false;  ///< built in, or its part is there (core/platform/parts.hpp)
    std::string version;     ///< of the library behind it, empty where absent
    std::string remedy;      ///< if absent: which package to install
    bool gives_multipliers = false;
    bool needs_convex = false;
    bool needs_derivatives = true;
    bool takes_equalities = true;
    bool safe_in_threads = true;  ///< several solves of one process run at once, and not one after another
    std::vector<NativeOption> options;
};

/// Every backend that camopt knows, built in or not, in the order of the documentation, then those added. A
/// returned list remains valid when another is added.
[[nodiscard]] std::span<const SolverEntry> solver_entries();

/// Makes a solver; called from several threads at once.
using SolverMaker = std::function<std::unique_ptr<Solver>()>;

/// Adds a solver of the program permanently: scenes name it (solver.name), it is listed, and verified like
/// every other by the certificate alone. Throws InputError for a name that is taken, "auto", or different
/// from the solver's own.
void add_solver(SolverEntry entry, const SolverMaker& make);

/// Throws InputError with the list of names for an unknown one, UnavailableError with the package to install
/// for one that is not available.
[[nodiscard]] std::unique_ptr<Solver> make_solver(std::string_view name);

/// Who goes on where the structured solver fails: Ipopt where this build has it, else no one ("").
[[nodiscard]] std::string solver_after_structured();

/// Throws InputError for a native option that the backend does not have or whose value it rejects.
void check_native_options(std::string_view solver, const std::map<std::string, OptionValue>& options);

}  // namespace camopt

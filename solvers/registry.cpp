// SPDX-License-Identifier: MIT
#include "solvers/registry.hpp"

#include "core/errors.hpp"
#include "core/text/spelling_hint.hpp"
#include "solvers/backend_support.hpp"
#include "solvers/ipopt/ipopt_solver.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace camopt {

namespace {

struct Backend {
    SolverEntry (*entry)();
    std::unique_ptr<Solver> (*make)();
};

/// A new backend is one line here (docs/adding_a_solver.md).
constexpr std::array<Backend, 10> backends = {{
    {structured_entry, make_structured_solver},
    {ipopt_entry, make_ipopt_solver},
    {nlopt_entry<NloptMethod::slsqp>, make_nlopt_solver<NloptMethod::slsqp>},
    {nlopt_entry<NloptMethod::cobyla>, make_nlopt_solver<NloptMethod::cobyla>},
    {nlopt_entry<NloptMethod::mma>, make_nlopt_solver<NloptMethod::mma>},
    {nlopt_entry<NloptMethod::ccsaq>, make_nlopt_solver<NloptMethod::ccsaq>},
    {nlopt_entry<NloptMethod::isres>, make_nlopt_solver<NloptMethod::isres>},
    {nlopt_entry<NloptMethod::auglag_lbfgs>, make_nlopt_solver<NloptMethod::auglag_lbfgs>},
    {nlopt_entry<NloptMethod::auglag_sbplx>, make_nlopt_solver<NloptMethod::auglag_sbplx>},
    {nlopt_entry<NloptMethod::auglag_neldermead>, make_nlopt_solver<NloptMethod::auglag_neldermead>},
}};

std::size_t index_of(std::string_view name) {
    const std::span<const SolverEntry> entries = solver_entries();
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const SolverEntry& entry) { return entry.name == name; });
    if (found != entries.end()) return static_cast<std::size_t>(found - entries.begin());
    std::vector<std::string> names;
    for (const SolverEntry& entry : entries) names.push_back(entry.name);
    throw InputError(fmt::format("unknown solver '{}'; allowed: {}{}", name, fmt::join(names, ", "),
                                 spelling_hint(name, names)));
}

}  // namespace

std::span<const SolverEntry> solver_entries() {
    static const std::vector<SolverEntry> entries = [] {
        std::vector<SolverEntry> all;
        for (const Backend& backend : backends) all.push_back(backend.entry());
        return all;
    }();
    return entries;
}

std::unique_ptr<Solver> make_solver(std::string_view name) {
    return backends[index_of(name)].make();
}

void check_native_options(std::string_view solver, const std::map<std::string, OptionValue>& options) {
    check_native_options(solver_entries()[index_of(solver)], options);
}

}  // namespace camopt

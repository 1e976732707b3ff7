// SPDX-License-Identifier: MIT

#include "core/open_registry.hpp"
#include "solvers/backend_support.hpp"
#include "solvers/ipopt/ipopt_solver.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <fmt/ranges.h>

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

using Solvers = OpenRegistry<SolverEntry, SolverMaker>;

Solvers& solvers() {
    static Solvers all(&SolverEntry::name, [] {
        Solvers::Lists built_in;
        for (const Backend& backend : backends) {
            built_in.descriptions.push_back(backend.entry());
            built_in.makers.emplace_back(backend.make);
        }
        return built_in;
    }());
    return all;
}

std::size_t index_of(std::span<const SolverEntry> entries, std::string_view name) {
    const auto found = std::ranges::find(entries, name, &SolverEntry::name);
    if (found != entries.end()) return static_cast<std::size_t>(found - entries.begin());
    std::vector<std::string> names;
    for (const SolverEntry& entry : entries) names.push_back(entry.name);
    throw InputError(fmt::format("unknown solver '{}'; allowed: {}{}", name, fmt::join(names, ", "),
                                 spelling_hint(name, names)));
}

}  // namespace

std::span<const SolverEntry> solver_entries() {
    return solvers().descriptions();
}

void add_solver(SolverEntry entry, const SolverMaker& make) {
    const std::unique_ptr<Solver> solver = make ? make() : nullptr;
    if (!solver)
        throw InputError("add_solver: found an empty function; allowed: a function that returns a solver");
    if (entry.name.empty() || entry.name == "auto" || solver->name() != entry.name)
        throw InputError(
            fmt::format("add_solver: found the name \"{}\" for a solver that calls itself \"{}\"; "
                        "allowed: its own name, not \"auto\"",
                        entry.name, solver->name()));
    entry.available = true;
    const std::string name = entry.name;
    solvers().add(std::move(entry), make, [&] {
        throw InputError(fmt::format(
            "add_solver: found the name \"{}\", which another solver has; allowed: a new one", name));
    });
}

std::string solver_after_structured() {
    const bool available = std::ranges::any_of(
        solver_entries(), [](const SolverEntry& entry) { return entry.name == "ipopt" && entry.available; });
    return available ? "ipopt" : "";
}

std::unique_ptr<Solver> make_solver(std::string_view name) {
    const Solvers::Lists& known = solvers().lists();
    return known.makers[index_of(known.descriptions, name)]();
}

void check_native_options(std::string_view solver, const std::map<std::string, OptionValue>& options) {
    const std::span<const SolverEntry> entries = solver_entries();
    check_native_options(entries[index_of(entries, solver)], options);
}

}  // namespace camopt

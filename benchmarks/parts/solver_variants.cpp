// SPDX-License-Identifier: MIT
#include "benchmarks/parts/solver_variants.hpp"

#include "solvers/registry.hpp"

#include <algorithm>

namespace camopt::benchmarks {

namespace {

bool has_option(const SolverEntry& entry, const std::string& name) {
    return std::ranges::any_of(entry.options,
                               [&](const NativeOption& option) { return option.name == name; });
}

/// Barrier rules that suit linear programs; the first is what the backend takes by itself.
void add_ipopt(std::vector<SolverVariant>& variants, const SolverEntry& entry) {
    const std::vector<SolverVariant> rules = {
        {entry.name, "predictor-corrector", {}},
        {entry.name, "adaptive", {{"mehrotra_algorithm", false}}},
        {entry.name, "monotone", {{"mehrotra_algorithm", false}, {"mu_strategy", std::string("monotone")}}}};
    const bool chains = has_option(entry, "chain_dense_columns");
    for (const SolverVariant& rule : rules) {
        for (const char* chained : {"no", "yes"}) {
            SolverVariant variant = rule;
            if (chains) variant.options["chain_dense_columns"] = std::string(chained);
            variant.words += chained == std::string("yes") ? ", chained columns" : ", dense columns";
            variants.push_back(std::move(variant));
            if (!chains) break;
        }
    }
}

}  // namespace

bool is_available(const std::string& backend) {
    return std::ranges::any_of(solver_entries(),
                               [&](const auto& entry) { return entry.name == backend && entry.available; });
}

std::vector<SolverVariant> solver_variants() {
    std::vector<SolverVariant> variants;
    for (const SolverEntry& entry : solver_entries()) {
        if (!entry.available) continue;
        if (entry.name == "structured") variants.push_back({entry.name, "default", {}});
        if (entry.name == "ipopt") add_ipopt(variants, entry);
    }
    return variants;
}

}  // namespace camopt::benchmarks

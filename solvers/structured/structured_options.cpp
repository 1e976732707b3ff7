// SPDX-License-Identifier: MIT
#include "solvers/structured/structured_options.hpp"

#include "solvers/backend_support.hpp"

#include <fmt/core.h>

namespace camopt {

namespace {

constexpr std::array<std::pair<std::string_view, FactorKind>, 5> factorizations() {
    return {{{"auto", FactorKind::automatic},
             {"chain", FactorKind::chain},
             {"simplicial", FactorKind::simplicial},
             {"cholmod", FactorKind::cholmod},
             {"klu", FactorKind::klu}}};
}

double number(const std::string& name, const OptionValue& value) {
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* integer = std::get_if<long long>(&value)) return static_cast<double>(*integer);
    throw InputError(fmt::format("structured.{}: a number is expected", name));
}

int integer(const std::string& name, const OptionValue& value) {
    const auto* found = std::get_if<long long>(&value);
    if (found == nullptr || *found < -1000000000 || *found > 1000000000)
        throw InputError(fmt::format("structured.{}: an integer of moderate size is expected", name));
    return static_cast<int>(*found);
}

FactorKind factorization(const OptionValue& value) {
    const auto* name = std::get_if<std::string>(&value);
    for (const auto& [word, kind] : factorizations())
        if (name != nullptr && *name == word) return kind;
    throw InputError("structured.factorization: allowed is auto, chain, simplicial, cholmod or klu");
}

void require(bool holds, const char* name, const char* range) {
    if (!holds) throw InputError(fmt::format("structured.{}: allowed is {}", name, range));
}

}  // namespace

void StructuredOptions::validate() const {
    require(max_iterations >= 1, "max_iterations", ">= 1");
    require(regularisation >= 1e-14 && regularisation <= 1e-3, "regularisation", "1e-14 … 1e-3");
    require(correctors >= 0 && correctors <= 10, "correctors", "0 … 10");
    require(patience >= 2, "patience", ">= 2");
    require(max_passes >= 1, "max_passes", ">= 1");
    require(first_radius >= 1e-8 && first_radius <= 1e8, "first_radius", "1e-8 … 1e8");
}

StructuredOptions structured_options(const std::map<std::string, OptionValue>& native) {
    StructuredOptions options;
    for (const auto& [name, value] : native) {
        if (name == "max_iterations")
            options.max_iterations = integer(name, value);
        else if (name == "regularisation")
            options.regularisation = number(name, value);
        else if (name == "correctors")
            options.correctors = integer(name, value);
        else if (name == "patience")
            options.patience = integer(name, value);
        else if (name == "max_passes")
            options.max_passes = integer(name, value);
        else if (name == "first_radius")
            options.first_radius = number(name, value);
        else if (name == "factorization")
            options.factor = factorization(value);
        else
            throw InputError(
                fmt::format("structured has no option \"{}\"; allowed: correctors, factorization, "
                            "first_radius, max_iterations, max_passes, patience, regularisation",
                            name));
    }
    options.validate();
    return options;
}

SolverEntry structured_entry() {
    SolverEntry entry;
    entry.name = "structured";
    entry.method =
        "primal-dual interior point, banded quasi-definite factorization with a dense border; around it a "
        "trust-region method of quadratic programs for nonlinear rows";
    entry.available = true;
    entry.version =
        fmt::format("Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    entry.gives_multipliers = true;
    entry.options = {
        integer_option("max_iterations", "200", {1.0, 1e9}, "iterations without the elastic phase"),
        number_option("regularisation", "1e-9", {1e-14, 1e-3}, "diagonal shift of the scaled Newton matrix"),
        integer_option("correctors", "1", {0.0, 10.0}, "centrality correctors in one iteration, at most"),
        text_option("factorization", "auto", {"auto", "chain", "simplicial", "cholmod", "klu"},
                    "of the Newton matrix; chain falls back on simplicial where the matrix is none; cholmod "
                    "and klu are SuiteSparse's"),
        integer_option("patience", "12", {2.0, 1e9},
                       "iterations without a better point before the search ends"),
        integer_option("max_passes", "200", {1.0, 1e9}, "nonlinear rows: linearizations, at most"),
        number_option("first_radius", "1", {1e-8, 1e8},
                      "nonlinear rows: how far the first linearization is trusted, relative to max(1, |x|)"),
    };
    if (!has_suitesparse_factors())
        for (NativeOption& option : entry.options)
            if (option.name == "factorization") {
                option.absent = {"cholmod", "klu"};
                option.remedy = suitesparse_remedy;
            }
    return entry;
}

}  // namespace camopt

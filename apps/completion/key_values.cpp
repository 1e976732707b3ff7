// SPDX-License-Identifier: MIT
#include "apps/completion/key_values.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "solvers/registry.hpp"

namespace camopt::apps {

namespace {

std::vector<std::string> law_words() {
    std::vector<std::string> words;
    for (const LawInfo& info : law_catalogue()) words.emplace_back(info.key);
    return words;
}

}  // namespace

std::vector<std::string> solver_words() {
    std::vector<std::string> words = {"auto"};
    for (const SolverEntry& entry : solver_entries())
        if (entry.available) words.emplace_back(entry.name);
    return words;
}

std::vector<std::string> values_of_key(const KeyRow& row) {
    if (row.type == KeyType::boolean) return {"true", "false"};
    if (row.name == "law" || row.name == "reference") return law_words();
    if (row.table == "solver" && row.name == "name") return solver_words();
    return {row.choices.begin(), row.choices.end()};
}

}  // namespace camopt::apps

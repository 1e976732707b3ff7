// SPDX-License-Identifier: MIT
#include "apps/scene_loading.hpp"

#include "input/scene_reader.hpp"
#include "motions/law_catalogue.hpp"
#include "solvers/registry.hpp"

namespace camopt::apps {

Scene load_scene(const std::string& file, const std::vector<std::string>& settings) {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) known.laws.push_back(law.key);
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return input::read_scene_file(file, known, settings);
}

}  // namespace camopt::apps

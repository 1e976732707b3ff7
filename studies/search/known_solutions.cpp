// SPDX-License-Identifier: MIT
#include "studies/search/known_solutions.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A scene is solved with its rules and up to two relaxations of them.
constexpr std::size_t most_grids = 4;

std::vector<std::string> names_of_rules(const CamModel& model) {
    std::vector<std::string> all;
    for (const PlacedRule& rule : model.rules)
        all.push_back(fmt::format("{} {}", rule->name(), rule.stretch));
    return all;
}

std::vector<double> joints_of(const CamModel& model) {
    std::vector<double> all;
    for (const MotionFamily::Piece& piece : model.design.pieces())
        all.insert(all.end(), {piece.begin, piece.end});
    return all;
}

}  // namespace

/// An empty one where there is none.
KnownSolutions::Grid& KnownSolutions::grid_of(const CamModel& model) {
    const std::vector<std::string> wanted = names_of_rules(model);
    const auto known = std::ranges::find(grids, wanted, &Grid::rules);
    if (known != grids.end())
        std::rotate(grids.begin(), known, std::next(known));
    else
        grids.insert(grids.begin(), Grid{wanted, {}, {}});
    if (grids.size() > most_grids) grids.pop_back();
    return grids.front();
}

CamProblem KnownSolutions::problem(CamModel model) {
    Grid& grid = grid_of(model);
    if (!grid.samples.empty() && grid.joints == joints_of(model)) return {std::move(model), grid.samples};
    CamProblem plain(std::move(model));
    grid.plain = plain.samples().size();
    return plain;
}

void KnownSolutions::keep(const CamProblem& problem) {
    Grid& grid = grid_of(problem.model());
    grid.joints = joints_of(problem.model());
    grid.samples = problem.samples();
    // Rows of the whole motion hold at speeds that the next scene may not have.
    std::erase_if(grid.samples, [](const RuleSample& sample) { return !sample.setting.empty(); });
    if (static_cast<double>(grid.samples.size()) > most_growth * static_cast<double>(grid.plain))
        grid.samples.clear();
}

Eigen::VectorXd KnownSolutions::last_found(const CamProblem& problem) const {
    const CamModel& model = problem.model();
    const Eigen::Index size = found.design.size();
    const auto parameters = static_cast<Eigen::Index>(model.parameters.size());
    const bool same = size > 0 && size == model.design.size() && parameters == found.parameters.size();
    if (!same || found.joints != joints_of(model)) return {};
    Eigen::VectorXd x(size + parameters);
    x << found.design.cwiseQuotient(design_scales(model)), found.parameters;
    return problem.completed(x);
}

void KnownSolutions::keep_found(const CamProblem& problem, const Eigen::VectorXd& x) {
    found = {joints_of(problem.model()), problem.design_values(x),
             x.tail(static_cast<Eigen::Index>(problem.model().parameters.size()))};
}

}  // namespace camopt

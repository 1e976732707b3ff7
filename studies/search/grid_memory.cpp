// SPDX-License-Identifier: MIT
#include "studies/search/grid_memory.hpp"

#include <algorithm>
#include <utility>

namespace camopt {

namespace {

// A scene is solved with its rules and up to two relaxations of them.
constexpr std::size_t most_grids = 4;

}  // namespace

std::vector<GridMemory::Place> GridMemory::places(const CamModel& model) {
    std::vector<Place> all;
    for (const PlacedRule& rule : model.rules) all.push_back({std::string(rule->name()), rule.stretch});
    return all;
}

std::vector<double> GridMemory::joints(const CamModel& model) {
    std::vector<double> all;
    for (const MotionFamily::Piece& piece : model.design.pieces()) {
        all.push_back(piece.begin);
        all.push_back(piece.end);
    }
    return all;
}

/// An empty one where there is none.
GridMemory::Grid& GridMemory::grid_of(const CamModel& model) {
    const std::vector<Place> wanted = places(model);
    const auto found = std::ranges::find(grids_, wanted, &Grid::places);
    if (found != grids_.end())
        std::rotate(grids_.begin(), found, std::next(found));
    else
        grids_.insert(grids_.begin(), Grid{wanted, {}, {}});
    if (grids_.size() > most_grids) grids_.pop_back();
    return grids_.front();
}

CamProblem GridMemory::problem(CamModel model) {
    Grid& grid = grid_of(model);
    if (!grid.samples.empty() && grid.joints == joints(model))
        return CamProblem(std::move(model), grid.samples);
    CamProblem plain(std::move(model));
    grid.plain = plain.samples().size();
    return plain;
}

void GridMemory::keep(const CamProblem& problem) {
    Grid& grid = grid_of(problem.model());
    grid.joints = joints(problem.model());
    grid.samples = problem.samples();
    // Rows of the whole motion hold at speeds that the next scene may not have.
    std::erase_if(grid.samples, [](const RuleSample& sample) { return !sample.setting.empty(); });
    if (static_cast<double>(grid.samples.size()) > most_growth_ * static_cast<double>(grid.plain))
        grid.samples.clear();
}

Eigen::VectorXd GridMemory::last_found(const CamProblem& problem) const {
    const CamModel& model = problem.model();
    const Eigen::Index size = found_.design.size();
    const auto parameters = static_cast<Eigen::Index>(model.parameters.size());
    const bool same = size > 0 && size == model.design.size() && parameters == found_.parameters.size();
    if (!same || found_.joints != joints(model)) return {};
    Eigen::VectorXd x(size + parameters);
    x << found_.design.cwiseQuotient(design_scales(model)), found_.parameters;
    return problem.completed(x);
}

void GridMemory::keep_found(const CamProblem& problem, const Eigen::VectorXd& x) {
    found_ = {joints(problem.model()), problem.design_values(x),
              x.tail(static_cast<Eigen::Index>(problem.model().parameters.size()))};
}

}  // namespace camopt

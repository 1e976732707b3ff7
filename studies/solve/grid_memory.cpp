// SPDX-License-Identifier: MIT
#include "studies/solve/grid_memory.hpp"

#include <utility>

namespace camopt {

namespace {

// A grid that has grown by more than this over the plain one costs more than the rounds it saves.
constexpr double most_growth = 1.5;

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

CamProblem GridMemory::problem(CamModel model) {
    if (!samples_.empty() && places_ == places(model) && joints_ == joints(model))
        return CamProblem(std::move(model), samples_);
    CamProblem plain(std::move(model));
    plain_ = plain.samples().size();
    return plain;
}

void GridMemory::keep(const CamProblem& problem) {
    places_ = places(problem.model());
    joints_ = joints(problem.model());
    samples_ = problem.samples();
    if (static_cast<double>(samples_.size()) > most_growth * static_cast<double>(plain_)) samples_.clear();
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A part of all motions: boxes of their states at finitely many cam angles and of the parameters, and the
// linear program that lies under the problem over these boxes.
#pragma once

#include "objectives/boxes/rule_over_box.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "solvers/vertex/vertex_program.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace camopt::box_bound {

/// (order 0 … 3 of y at a cam angle) = weights · x + offset.
struct StateRow {
    Eigen::VectorXd weights;
    double offset = 0.0;
};

/// A cam angle at which rules that are not linear are kept.
struct Place {
    double at = 0.0;
    Side side = Side::right;
    std::array<StateRow, 4> state;
    std::vector<int> rules;  ///< of the model

    [[nodiscard]] Eigen::VectorXd point(const Eigen::VectorXd& x) const;
};

/// What a box of one place has of one rule.
struct Bent {
    int rule = 0;
    std::optional<RuleOverBox> over;
};

struct PlaceBox {
    std::array<Interval, 4> state{Interval::everything(), Interval::everything(), Interval::everything(),
                                  Interval::everything()};
    std::array<std::array<int, 2>, 4> steps{{{-1, -1}, {-1, -1}, {-1, -1}, {-1, -1}}};  ///< of its ends
    std::vector<Bent> bent;  ///< one a rule of the place
    bool bites = true;       ///< some rule may be broken in it
};

struct Node {
    VertexProgram program;
    std::vector<char> may_go{};  ///< of each row of the program: a plane or a side of a box
    std::vector<int> steps{};    ///< of each row of the program: its step of the proof
    /// The steps that bound a variable now, its lower and upper bound; −1: as at the beginning.
    std::vector<std::array<int, 2>> bound_steps{};
    std::vector<int> splits{};      ///< steps that this part assumes
    std::vector<PlaceBox> boxes{};  ///< one a place
    int linear_rows = 0;            ///< of the grid of linear rules, how many are in the program
    double bound = -infinity;
    bool empty = false;  ///< proved: nothing lies in it
    /// What the bound, or that it is empty, follows from: steps and multipliers.
    std::vector<std::pair<int, double>> multipliers{};
    std::vector<int> bounds_used{};
    Eigen::VectorXd x{};  ///< where the bound is taken
    int depth = 0;
};

}  // namespace camopt::box_bound

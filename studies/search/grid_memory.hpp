// SPDX-License-Identifier: MIT
// Where the rules of a scene had to be sampled, kept for a neighbouring scene: the exchange then starts with
// the angles that mattered instead of finding them again, round by round. A scene has a grid for each set of
// rules it is solved with: its own, and those of its relaxations. Beside the grids: what a look (a picture
// before its proof) begins with, the motion that the last search found and the weight that broke the last
// tie.
#pragma once

#include "objectives/grid/cam_problem.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace camopt {

class GridMemory {
 public:
    /// A grid that has grown by more than `most_growth` over the plain one is not kept: it costs more than
    /// the rounds it saves, unless the neighbour is very near (a slider that is drawn).
    explicit GridMemory(double most_growth = 1.5) : most_growth_(most_growth) {}

    /// The problem of `model`, on the grid kept from its neighbour. Plain where there is none: nothing kept
    /// yet of these rules, or another spline.
    [[nodiscard]] CamProblem problem(CamModel model);
    void keep(const CamProblem& problem);

    /// A look: one search from where the last one ended instead of relaxations and several starts, one weight
    /// of the tie-break instead of all. What it finds is as good as a neighbour's and not proved.
    bool only_looks = false;
    /// The weight that the last tie-break kept.
    std::optional<double> tie_break_weight;

    /// The point that the last search found, for a problem of the same motion and dimensions; empty: none.
    [[nodiscard]] Eigen::VectorXd last_found(const CamProblem& problem) const;
    void keep_found(const CamProblem& problem, const Eigen::VectorXd& x);
    void forget_found() { found_ = {}; }

 private:
    struct Place {
        std::string rule;
        int stretch = -1;
        bool operator==(const Place&) const = default;
    };
    [[nodiscard]] static std::vector<Place> places(const CamModel& model);
    [[nodiscard]] static std::vector<double> joints(const CamModel& model);

    struct Grid {
        std::vector<Place> places;
        std::vector<double> joints;  ///< where the pieces of the motion begin and end
        std::vector<RuleSample> samples;
        std::size_t plain = 0;  ///< samples of the plain grid
    };
    [[nodiscard]] Grid& grid_of(const CamModel& model);

    struct Found {
        std::vector<double> joints;
        Eigen::VectorXd design;      ///< in its own units
        Eigen::VectorXd parameters;  ///< as in x
    };

    double most_growth_;
    Found found_;
    std::vector<Grid> grids_;  ///< the one asked for last in front
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// What a neighbouring scene was solved with, for the next one. The exchange starts with the cam angles that
// mattered instead of finding them again, round by round: a grid for each set of rules, of the scene and of
// its relaxations. A look (PlanOptions::look) also begins with the motion that the last search found and the
// weight that broke the last tie. Where only weights differ, a motion that is known may be proved optimal
// without any solve (proved_optima.hpp).
//
// Verdict and objective are those of a cold solve, to the solver's tolerance. Scenes that are no neighbours
// (another spline, another motion) are solved cold.
#pragma once

#include "studies/search/proved_optima.hpp"

namespace camopt {

struct KnownSolutions {
    /// The problem of `model`, on the grid kept from its neighbour. Plain if there is none: nothing kept yet
    /// of these rules, or another spline.
    [[nodiscard]] CamProblem problem(CamModel model);
    /// Whether the last problem was a plain one.
    [[nodiscard]] bool is_cold() const { return grids.empty() || grids.front().samples.empty(); }
    void keep(const CamProblem& problem);

    /// The point that the last search found, for a problem of the same motion and dimensions; empty: none.
    [[nodiscard]] Eigen::VectorXd last_found(const CamProblem& problem) const;
    void keep_found(const CamProblem& problem, const Eigen::VectorXd& x);

    /// Rules and the samples that they had.
    struct Grid {
        std::vector<std::string> rules;  ///< names with their stretches
        std::vector<double> joints;      ///< where the pieces of the motion begin and end
        std::vector<RuleSample> samples;
        std::size_t plain = 0;  ///< samples of the plain grid
    };
    struct Found {
        std::vector<double> joints;
        Eigen::VectorXd design;      ///< in its own units
        Eigen::VectorXd parameters;  ///< as in x
    };

    /// A grid that has grown by more than this over the plain one is not kept: it costs more than the rounds
    /// it saves, unless the neighbour is very near (a slider that is drawn).
    double most_growth = 1.5;
    Found found = {};
    std::optional<double> tie_break_weight = {};  ///< that the last tie-break kept
    std::vector<Grid> grids = {};                 ///< the one used last in front
    /// Of convex scenes: motions that are optimal for other weights too need no solve.
    ProvedOptima optima = {};
    int number = 0;  ///< of the scene that is solved next, for those who number them

 private:
    [[nodiscard]] Grid& grid_of(const CamModel& model);
};

}  // namespace camopt

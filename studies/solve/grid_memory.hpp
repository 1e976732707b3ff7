// SPDX-License-Identifier: MIT
// Where the rules of a scene had to be sampled, kept for a neighbouring scene: the exchange then starts with
// the angles that mattered instead of finding them again, round by round.
#pragma once

#include "objectives/grid/cam_problem.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace camopt {

class GridMemory {
 public:
    /// The problem of `model`, on the grid kept from its neighbour. Plain where there is none: nothing kept
    /// yet, other rules, or another spline.
    [[nodiscard]] CamProblem problem(CamModel model);
    void keep(const CamProblem& problem);

 private:
    struct Place {
        std::string rule;
        int stretch = -1;
        bool operator==(const Place&) const = default;
    };
    [[nodiscard]] static std::vector<Place> places(const CamModel& model);
    [[nodiscard]] static std::vector<double> joints(const CamModel& model);

    std::vector<Place> places_;
    std::vector<double> joints_;  ///< where the pieces of the motion begin and end
    std::vector<RuleSample> samples_;
    std::size_t plain_ = 0;  ///< samples of the plain grid
};

}  // namespace camopt

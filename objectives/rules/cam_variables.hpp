// SPDX-License-Identifier: MIT
// The cam of a problem, of any kind: which of its dimensions the optimizer varies, and the values of the
// others.
#pragma once

#include "profiles/sampling.hpp"
#include "scene/cam_mechanism.hpp"

#include <Eigen/Core>

#include <atomic>
#include <memory>
#include <vector>

namespace camopt {

struct CamVariables {
    struct Variable {
        int dimension = 0;       ///< its index among the cam's dimensions
        int parameter = 0;       ///< index among the problem's parameters
        double reference = 1.0;  ///< m or rad in one unit of the parameter
    };
    DrivenMechanism cam;
    MotionScale scale;
    std::vector<Variable> variables;
    /// Number of evaluated points of the cam: shared by all rules of a problem; threads may count
    /// concurrently.
    std::shared_ptr<std::atomic<long>> profile_points = std::make_shared<std::atomic<long>>(0);

    /// The dimensions for all parameters of a problem.
    [[nodiscard]] std::vector<double> dimensions_at(const Eigen::VectorXd& parameters) const;
    /// The dimensions for a rule's own parameters q, one for each of the variables.
    [[nodiscard]] std::vector<double> dimensions_for(const Eigen::VectorXd& q) const;
    /// The dimension is variable.
    [[nodiscard]] bool is_variable(int dimension) const;
};

}  // namespace camopt

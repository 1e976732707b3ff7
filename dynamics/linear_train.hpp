// SPDX-License-Identifier: MIT
//
// An elastic follower train as a linear system, in SI units:
//
//   M ẍ + C ẋ + K x = k_1 y e_1 + c_1 ẏ e_1 − P e_n.
//
// Masses 1 … n from cam to output. The deviation of x from its static position s y − u P is
// e = x − s y + u P, where K s = k_1 e_1 and K u = e_n; without a return spring s = 1.
#pragma once

#include "scene/dynamics_spec.hpp"

#include <Eigen/Core>

#include <vector>

namespace camopt {

struct LinearTrain {
    std::vector<TrainStage> stages;  ///< the output last
    double return_stiffness = 0.0, preload = 0.0;
    Eigen::VectorXd share;       ///< s: how far each mass follows y at rest
    Eigen::VectorXd compliance;  ///< u: m/N for a force on the output

    [[nodiscard]] int masses() const { return static_cast<int>(stages.size()); }
    /// B: rows Σ_j B_ij x_j = elongation of spring i for y = 0; with a return spring one more. Each row times
    /// √k_i / √m_j: the potential energy is half its square.
    [[nodiscard]] Eigen::MatrixXd elongations() const;
    /// The same with √c_i: CᵀC is the damping for unit masses.
    [[nodiscard]] Eigen::MatrixXd damped_elongations() const;
};

/// Throws InputError for a chain of more than four masses or with a mass or spring that is not positive.
[[nodiscard]] LinearTrain linear_train(const DynamicsSpec& spec);

}  // namespace camopt

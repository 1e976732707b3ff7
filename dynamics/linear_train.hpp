// SPDX-License-Identifier: MIT
// An elastic follower train as a linear system, in SI units:
//
//   M ẍ + C ẋ + K x = k_1 y e_1 + c_1 ẏ e_1 − P e_n.
//
// C has the dampers of the stages and one from the output to ground. Masses 1 … n from cam to output. The
// deviation of x from its static position s y − u P is e = x − s y + u P, where K s = k_1 e_1 and K u = e_n;
// without a return spring s = 1.
#pragma once

#include "scene/dynamics_spec.hpp"

namespace camopt {

struct LinearTrain {
    std::vector<TrainStage> stages;  ///< the output last
    double return_stiffness = 0.0, preload = 0.0;
    double ground_damping = 0.0;  ///< of the output
    Eigen::VectorXd share;        ///< s: how far each mass follows y at rest
    Eigen::VectorXd compliance;   ///< u: m/N for a force on the output

    [[nodiscard]] int masses() const { return static_cast<int>(stages.size()); }
    /// B: rows Σ_j B_ij x_j = elongation of spring i for y = 0; with a return spring one more. Each row times
    /// √k_i / √m_j: the potential energy is half its square.
    [[nodiscard]] Eigen::MatrixXd elongations() const;
    /// The same with √c_i, and with a damper to ground one row more: CᵀC is the damping for unit masses.
    [[nodiscard]] Eigen::MatrixXd damped_elongations() const;

 private:
    /// One row more, of the output against ground, where the weight is above 0.
    [[nodiscard]] Eigen::MatrixXd with_ground(Eigen::MatrixXd rows, double weight) const;
};

/// Throws InputError for a chain of more than four masses or with a mass or spring that is not positive.
[[nodiscard]] LinearTrain linear_train(const DynamicsSpec& spec);

// A linear train at one speed of the cam. With time x = cam angle / unit angle, T = unit angle / speed
// seconds long, lifts for displacements and q_i = √m_i e_i:
//
//   p = R q,   p' = R q',   q'' = −Rᵀ p − D q' + g_1 y' + g_2 y'',   X = (p, q').
//
// RᵀR = T² M^{−1/2} K M^{−1/2}, computed from the elongations of the springs, which avoids cancellation
// between stiffnesses of different size. X' = A X + … has A + Aᵀ <= 0: the energy |X|² never grows without
// input, nor do rounding errors. Over a piece the response to a polynomial is a matrix exponential (Step);
// values inside come from Taylor steps of at most half a radian of the fastest mode.

class LinearTrainAtSpeed final : public TrainAtSpeed {
 public:
    /// speed rad/s, unit_angle rad, lift m or rad; all > 0.
    LinearTrainAtSpeed(const LinearTrain& train, double speed, double unit_angle, double lift);

    [[nodiscard]] int states() const override { return static_cast<int>(generator_.rows()); }
    [[nodiscard]] Step step(double width, int degree) const override;
    [[nodiscard]] const Eigen::VectorXd& kick() const override { return by_acceleration_; }
    [[nodiscard]] const Reading& acceleration() const override { return acceleration_; }
    [[nodiscard]] const Reading& deflection() const override { return deflection_; }
    [[nodiscard]] const Reading& contact_force() const override { return contact_force_; }
    [[nodiscard]] const Eigen::MatrixXcd& modes() const override { return modes_; }
    [[nodiscard]] std::vector<Extremum> maxima(const Reading& reading, double sign,
                                               const Eigen::VectorXd& begin_state, const SlopePiece& piece,
                                               double floor) const override;
    [[nodiscard]] Eigen::VectorXd state_inside(const Eigen::VectorXd& begin_state, const SlopePiece& piece,
                                               double t) const override;

    [[nodiscard]] std::vector<Eigen::VectorXd> states_along(std::span<const SlopePiece> pieces,
                                                            const Eigen::VectorXd& start,
                                                            double slope_before) const override;
    [[nodiscard]] Eigen::VectorXd steady_start(std::span<const SlopePiece> turn) const override;

    /// A, and the input matrices of y' and y''.
    [[nodiscard]] const Eigen::MatrixXd& generator() const { return generator_; }
    [[nodiscard]] const Eigen::VectorXd& by_velocity() const { return by_velocity_; }
    [[nodiscard]] const Eigen::VectorXd& by_acceleration() const { return by_acceleration_; }

 private:
    class KnownSteps;
    void set_readings(const LinearTrain& train, const Eigen::MatrixXd& root, double seconds, double lift);
    void set_modes(const LinearTrain& train);

    Eigen::MatrixXd generator_;
    Eigen::VectorXd by_velocity_, by_acceleration_;
    Reading acceleration_, deflection_, contact_force_;
    Eigen::MatrixXcd modes_;
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
//
// The elastic follower train between cam and output, and the interface of its formulas (in dynamics/).
//
// Masses form a chain from the cam to the output, each on a spring and a damper from the one before it;
// the first is driven by the cam's motion y. A return spring with a preload may press the output back to the
// cam:
//
//   M ẍ + C ẋ + K x = k_1 y e_1 + c_1 ẏ e_1 − P e_n.
//
// SI: kg, N/m, N s/m, N; of a swinging output kg m², N m/rad, N m s/rad, N m. A scene without a DynamicsSpec
// evaluates none of it, and a program without camopt::dynamics contains none of it.
#pragma once

#include "core/motion.hpp"

#include <Eigen/Core>

namespace camopt {

/// One mass on its spring and damper.
struct TrainStage {
    double mass = 0.0;       ///< > 0
    double stiffness = 0.0;  ///< > 0, to the mass or cam before it
    double damping = 0.0;    ///< >= 0
    friend bool operator==(const TrainStage&, const TrainStage&) = default;
};

/// y' on one piece of a motion: Σ_k slope_k t^k, t = (x − begin) / width in [0, 1]; y at its begin.
struct SlopePiece {
    double begin = 0.0, width = 0.0;
    double displacement = 0.0;
    Eigen::VectorXd slope;
};

/// A train at one speed of the cam, with x for time and lifts for displacements. Its state X is 0 while the
/// output rests, is driven by y' and y'', and never grows without input (|X|² is its energy).
class TrainAtSpeed {
 public:
    virtual ~TrainAtSpeed() = default;

    [[nodiscard]] virtual int states() const = 0;
    /// Over a piece: X(end) = state · X(begin) + drive · slope, with a slope of `degree`.
    struct Step {
        Eigen::MatrixXd state, drive;
    };
    [[nodiscard]] virtual Step step(double width, int degree) const = 0;
    /// X changes by this times a jump of y'.
    [[nodiscard]] virtual const Eigen::VectorXd& kick() const = 0;

    /// An output: state · X + motion · (y, y', y'') + constant.
    struct Reading {
        Eigen::VectorXd state;
        std::array<double, 3> motion{};
        double constant = 0.0;
    };
    /// Of the output: x'' in lifts by x².
    [[nodiscard]] virtual const Reading& acceleration() const = 0;
    /// x − y in lifts, without the constant compression by the preload.
    [[nodiscard]] virtual const Reading& deflection() const = 0;
    /// The force of the train on the cam, N or N m.
    [[nodiscard]] virtual const Reading& contact_force() const = 0;

    /// One row per vibrating mode: once y rests the output moves by Σ Re(row · X e^{(…)}) about its rest,
    /// mode k with the amplitude |row_k · X|. modes x states.
    [[nodiscard]] virtual const Eigen::MatrixXcd& modes() const = 0;

    /// Local maxima of sign · output along a piece that begins with state X, those above `floor`; both ends
    /// count. Accurate to round-off. `at`: x.
    [[nodiscard]] virtual std::vector<Extremum> maxima(const Reading& reading, double sign,
                                                       const Eigen::VectorXd& begin_state,
                                                       const SlopePiece& piece, double floor) const = 0;
    /// X at the begin of every piece and at the end of the last, from `start` on; y' was `slope_before`, and
    /// where it jumps X receives an impulse (the returned states are those after it; after the last piece
    /// none).
    [[nodiscard]] virtual std::vector<Eigen::VectorXd> states_along(std::span<const SlopePiece> pieces,
                                                                    const Eigen::VectorXd& start,
                                                                    double slope_before) const = 0;
    /// X at the begin of a periodic cycle, before the impulse there. Infinite or huge if a train without
    /// damping is driven in resonance.
    [[nodiscard]] virtual Eigen::VectorXd steady_start(std::span<const SlopePiece> turn) const = 0;
    /// X at t in [0, 1] of a piece.
    [[nodiscard]] virtual Eigen::VectorXd state_inside(const Eigen::VectorXd& begin_state,
                                                       const SlopePiece& piece, double t) const = 0;

 protected:
    TrainAtSpeed() = default;
    TrainAtSpeed(const TrainAtSpeed&) = default;
    TrainAtSpeed& operator=(const TrainAtSpeed&) = default;
};

/// The interface behind DynamicsSpec::formulas.
class TrainFormulas {
 public:
    virtual ~TrainFormulas() = default;

    /// unit_angle: the cam angle of x = 1, rad. speed: rad/s, > 0. lift: m or rad.
    [[nodiscard]] virtual std::unique_ptr<const TrainAtSpeed> at(double speed, double unit_angle,
                                                                 double lift) const = 0;
    /// y' of any motion as polynomials: exact for splines, others to round-off.
    [[nodiscard]] virtual std::vector<SlopePiece> pieces(const Motion& motion) const = 0;
    /// Natural frequencies of the train with the cam held, undamped, ascending, rad/s.
    [[nodiscard]] virtual const std::vector<double>& natural_frequencies() const = 0;
    /// Whether some mode is underdamped.
    [[nodiscard]] virtual bool vibrates() const = 0;

 protected:
    TrainFormulas() = default;
    TrainFormulas(const TrainFormulas&) = default;
    TrainFormulas& operator=(const TrainFormulas&) = default;
};

/// Whose motion the spline is: the cam's, which the output follows as the train lets it, or the output's
/// (polydyne, splinedyne). Then the cam does what the train needs at the scene's speed Ω,
///
///   s = (1 + k_r / k) y + (c_g / k) ẏ + (m / k) ÿ,
///
/// the output's spring k, its mass m, return spring k_r and damper to ground c_g; damping of the train itself
/// plays no part. Peaks, limits and conditions of the motion are the output's, everything of the cam sees s.
enum class PrescribedMotion { cam, output };

struct DynamicsSpec {
    double mass = 0.0;  ///< moved at the output, > 0
    /// One of the two: natural frequency of the output on its spring with the part before it held, rad/s; or
    /// that spring.
    std::optional<double> natural_frequency = {}, stiffness = {};
    /// At most one of the two: of critical, or N s/m.
    std::optional<double> damping_ratio = {}, damping = {};
    double return_stiffness = 0.0;                          ///< >= 0
    double preload = 0.0;                                   ///< >= 0, at displacement 0
    double ground_damping = 0.0;                            ///< >= 0, N s/m, of the output to ground
    PrescribedMotion prescribe = PrescribedMotion::cam;     ///< output: of trains of one mass
    std::vector<TrainStage> stages = {};                    ///< from the cam on, before the output; at most 3
    std::optional<std::array<double, 2>> speed_range = {};  ///< rad/s; none: the scene's speed alone
    std::shared_ptr<const TrainFormulas> formulas = {};     ///< set by dynamics/train_formulas.hpp

    [[nodiscard]] bool prescribes_output() const { return prescribe == PrescribedMotion::output; }
    /// Whether a force presses the follower on the cam: else the cam guides it in both directions.
    [[nodiscard]] bool pressed() const { return return_stiffness > 0.0 || preload > 0.0; }
    /// The output on its own spring and damper.
    [[nodiscard]] TrainStage output() const;
    friend bool operator==(const DynamicsSpec&, const DynamicsSpec&) = default;
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/numbers/polynomial.hpp"
#include "dynamics/linear_train.hpp"
#include "dynamics/small_matrices.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

#include <deque>

namespace camopt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Norm of A times a Taylor step: the series of this many terms then has a truncation error of 0.5^20 / 20!,
// far below round-off.
constexpr double taylor_radians = 0.5;
constexpr int taylor_terms = 19;
// Relative to |eigenvalue|: a smaller imaginary part is round-off of a mode that does not vibrate.
constexpr double least_vibration = 1e-9;
// Relative: breakpoints of a uniform spline differ by round-off.
constexpr double same_width = 1e-13;
// More steps on one piece would take seconds to evaluate, and the phase at its end would be inaccurate.
constexpr double most_steps = 4e6;

/// A square root of the stiffness for unit masses: RᵀR = LᵀL.
MatrixXd stiffness_root(const LinearTrain& train, double seconds) {
    MatrixXd root = seconds * train.elongations();
    if (root.rows() == root.cols()) return root;
    if (root.cols() == 1) return MatrixXd::Constant(1, 1, root.norm());
    return triangular_root(root);
}

// Of bounded size, so that a step allocates nothing: four masses, slopes of up to 24 terms.
constexpr int most_terms = 28, most_states = 8;
using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_terms, 1>;
using StateSeries = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_states, most_terms>;
using State = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_states, 1>;

/// The input's polynomial from t = `from` on, by (t − from) / part.
Terms shifted(const VectorXd& polynomial, double from, double part) {
    Terms result = polynomial;
    const Eigen::Index size = result.size();
    for (Eigen::Index i = 0; i + 1 < size; ++i)
        for (Eigen::Index k = size - 2; k >= i; --k) result[k] += from * result[k + 1];
    double power = 1.0;
    for (Eigen::Index k = 0; k < size; ++k, power *= part) result[k] *= power;
    return result;
}

/// One Taylor step of the train: X, y', y as series of a local variable in [0, 1].
struct Series {
    StateSeries state;  ///< states x terms
    Terms slope, displacement;
    double width = 0.0;  ///< in x

    /// An output as a polynomial of the local variable.
    [[nodiscard]] Terms of(const TrainAtSpeed::Reading& reading) const {
        Terms value = state.transpose().lazyProduct(reading.state);
        value[0] += reading.constant;
        value.head(displacement.size()) += reading.motion[0] * displacement;
        value.head(slope.size()) += reading.motion[1] * slope;
        for (Eigen::Index k = 1; k < slope.size(); ++k)
            value[k - 1] += reading.motion[2] * static_cast<double>(k) * slope[k] / width;
        return value;
    }
};

int steps_over(double radians) {
    const double steps = std::max(1.0, std::ceil(radians / taylor_radians));
    if (!(steps <= most_steps))
        throw SceneError({"dynamics",
                          fmt::format("a train that vibrates {:.3g} times in one piece of the motion",
                                      radians / units::turn),
                          fmt::format("at most {:.3g}, a softer train or a higher speed",
                                      most_steps * taylor_radians / units::turn)});
    return static_cast<int>(steps);
}

class TaylorSteps {
 public:
    TaylorSteps(const LinearTrainAtSpeed& train, const SlopePiece& piece)
        : train_(train), piece_(piece), steps_(steps_over(train.generator().norm() * piece.width)) {}

    [[nodiscard]] int count() const { return steps_; }

    /// From t = `from` over `part` of the piece, X and y at its begin.
    [[nodiscard]] Series series(const State& begin_state, double displacement, double from,
                                double part) const {
        Series one;
        one.width = part * piece_.width;
        one.slope = shifted(piece_.slope, from, part);
        const Eigen::Index degree = one.slope.size() - 1;
        const Eigen::Index terms = std::max<Eigen::Index>(taylor_terms, degree + 3);
        one.displacement = Terms::Zero(degree + 2);
        one.displacement[0] = displacement;
        for (Eigen::Index k = 0; k <= degree; ++k)
            one.displacement[k + 1] = one.width * one.slope[k] / static_cast<double>(k + 1);
        one.state = StateSeries::Zero(begin_state.size(), terms);
        one.state.col(0) = begin_state;
        for (Eigen::Index k = 0; k + 1 < terms; ++k) {
            State next = one.width * train_.generator().lazyProduct(one.state.col(k));
            if (k <= degree) next += one.width * one.slope[k] * train_.by_velocity();
            if (k + 1 <= degree)
                next += static_cast<double>(k + 1) * one.slope[k + 1] * train_.by_acceleration();
            one.state.col(k + 1) = next / static_cast<double>(k + 1);
        }
        return one;
    }

 private:
    const LinearTrainAtSpeed& train_;
    const SlopePiece& piece_;
    int steps_;
};

}  // namespace

LinearTrainAtSpeed::LinearTrainAtSpeed(const LinearTrain& train, double speed, double unit_angle,
                                       double lift) {
    const Eigen::Index n = train.masses();
    const double seconds = unit_angle / speed;
    const MatrixXd root = stiffness_root(train, seconds);
    const MatrixXd damped = train.damped_elongations();
    generator_ = MatrixXd::Zero(2 * n, 2 * n);
    generator_.topRightCorner(n, n) = root;
    generator_.bottomLeftCorner(n, n) = -root.transpose();
    generator_.bottomRightCorner(n, n) = -seconds * (damped.transpose() * damped);
    by_acceleration_ = by_velocity_ = VectorXd::Zero(2 * n);
    VectorXd mass_root(n);
    for (Eigen::Index i = 0; i < n; ++i)
        mass_root[i] = std::sqrt(train.stages[static_cast<std::size_t>(i)].mass);
    by_acceleration_.tail(n) = -mass_root.cwiseProduct(train.share);
    // C s − c_1 e_1: damper velocities while every mass follows its static share. Of those of the train 0
    // without a return spring.
    VectorXd parting = VectorXd::Zero(damped.rows());
    if (damped.rows() > n) parting[n] = std::sqrt(train.ground_damping) * train.share[n - 1];
    for (Eigen::Index i = 0; i < n; ++i) {
        const double before = i == 0 ? 1.0 : train.share[i - 1];
        parting[i] = std::sqrt(train.stages[static_cast<std::size_t>(i)].damping) * (train.share[i] - before);
    }
    by_velocity_.tail(n) = -seconds * (damped.transpose() * parting);
    set_readings(train, root, seconds, lift);
    set_modes(train);
}

void LinearTrainAtSpeed::set_readings(const LinearTrain& train, const MatrixXd& root, double seconds,
                                      double lift) {
    const Eigen::Index n = train.masses();
    const TrainStage& first = train.stages.front();
    const TrainStage& last = train.stages.back();
    const double last_root = std::sqrt(last.mass), first_root = std::sqrt(first.mass);
    // e_i = (R^{-1} p)_i / √m_i.
    const MatrixXd inverse = inverse_of(root);
    for (Reading* reading : {&acceleration_, &deflection_, &contact_force_})
        reading->state = VectorXd::Zero(2 * n);
    deflection_.state.head(n) = inverse.row(n - 1).transpose() / last_root;
    deflection_.motion[0] = train.share[n - 1] - 1.0;
    acceleration_.state = generator_.row(2 * n - 1).transpose() / last_root;
    acceleration_.motion[1] = by_velocity_[2 * n - 1] / last_root;
    // s_n y'' + e_n'', where e_n'' contains −s_n y'': only forces remain.
    acceleration_.motion[2] = 0.0;
    // The first spring and damper between y and x_1 = s_1 y − u_1 P + e_1.
    contact_force_.state.head(n) = -lift * first.stiffness * inverse.row(0).transpose() / first_root;
    contact_force_.state[n] = -lift * first.damping / seconds / first_root;
    // k_1 (1 − s_1) = k_r s_n: the force of the return spring reaches the cam.
    contact_force_.motion[0] = lift * train.return_stiffness * train.share[n - 1];
    contact_force_.motion[1] = lift * first.damping / seconds * (1.0 - train.share[0]);
    contact_force_.constant = train.share[n - 1] * train.preload;
}

void LinearTrainAtSpeed::set_modes(const LinearTrain& train) {
    const Eigen::Index n = train.masses();
    const double last_root = std::sqrt(train.stages.back().mass);
    if (n == 1) {
        const double w = generator_(0, 1), decay = -0.5 * generator_(1, 1);
        const double vibration = (w - decay) * (w + decay);
        modes_.resize(vibration > 0.0 && decay < w * (1.0 - least_vibration) ? 1 : 0, 2);
        if (modes_.rows() == 0) return;
        const double damped = std::sqrt(vibration);
        // e − i (e' + ζ w e) / w_d, e = p / (w √m).
        modes_(0, 0) = std::complex<double>(1.0, -decay / damped) / (w * last_root);
        modes_(0, 1) = std::complex<double>(0.0, -1.0 / damped) / last_root;
        return;
    }
    const Eigenvectors modes = eigenvectors_of(generator_);
    std::vector<Eigen::Index> vibrating;
    for (Eigen::Index k = 0; k < modes.values.size(); ++k) {
        const std::complex<double> value = modes.values[k];
        if (value.imag() > least_vibration * std::abs(value)) vibrating.push_back(k);
    }
    modes_.resize(static_cast<Eigen::Index>(vibrating.size()), 2 * n);
    for (std::size_t m = 0; m < vibrating.size(); ++m) {
        std::complex<double> output = 0.0;
        for (Eigen::Index i = 0; i < 2 * n; ++i)
            output += deflection_.state[i] * modes.right(i, vibrating[m]);
        modes_.row(static_cast<Eigen::Index>(m)) = 2.0 * output * modes.left.row(vibrating[m]);
    }
}

TrainAtSpeed::Step LinearTrainAtSpeed::step(double width, int degree) const {
    // φ_{j+1}(H) b = ∫ e^{H(1−t)} t^j / j! b dt, for both inputs b and every power j, as blocks of one
    // exponential.
    const Eigen::Index n = states(), powers = degree + 1;
    MatrixXd whole = MatrixXd::Zero(n + 2 * powers, n + 2 * powers);
    whole.topLeftCorner(n, n) = width * generator_;
    whole.col(n).head(n) = by_velocity_;
    whole.col(n + powers).head(n) = by_acceleration_;
    for (Eigen::Index block = 0; block < 2; ++block)
        for (Eigen::Index j = 0; j + 1 < powers; ++j)
            whole(n + block * powers + j, n + block * powers + j + 1) = 1.0;
    const MatrixXd exponential = exponential_of(std::move(whole));
    Step result{exponential.topLeftCorner(n, n), MatrixXd::Zero(n, powers)};
    double factorial = 1.0;
    for (Eigen::Index k = 0; k < powers; ++k) {
        if (k > 0) factorial *= static_cast<double>(k);
        result.drive.col(k) = width * factorial * exponential.col(n + k).head(n);
        if (k > 0) result.drive.col(k) += factorial * exponential.col(n + powers + k - 1).head(n);
    }
    return result;
}

std::vector<Extremum> LinearTrainAtSpeed::maxima(const Reading& reading, double sign,
                                                 const VectorXd& begin_state, const SlopePiece& piece,
                                                 double floor) const {
    const TaylorSteps steps(*this, piece);
    State state = begin_state;
    double displacement = piece.displacement;
    std::vector<Extremum> found;
    // While y rests the energy |X|² decreases, and so do all bounds on the outputs.
    const bool rests = piece.slope.size() == 1 && piece.slope[0] == 0.0;
    const double at_rest = sign * (reading.constant + reading.motion[0] * displacement);
    const double reach = reading.state.norm();
    const double part = 1.0 / steps.count();
    for (int i = 0; i < steps.count(); ++i) {
        if (rests && at_rest + reach * state.norm() <= floor) break;
        const Series series = steps.series(state, displacement, i * part, part);
        const Terms value = sign * series.of(reading);
        if (const auto maximum = maximum_above(value, floor)) {
            const double t = (i + maximum->at) * part;
            found.push_back({maximum->value, piece.begin + std::min(t, 1.0) * piece.width, Side::right});
        }
        state = series.state.rowwise().sum();
        displacement = series.displacement.sum();
    }
    if (!found.empty() && found.back().at >= piece.begin + piece.width) found.back().side = Side::left;
    return found;
}

/// Steps of equal width share their exponential: uniform splines have one width, up to the rounding of
/// breakpoints.
class LinearTrainAtSpeed::KnownSteps {
 public:
    explicit KnownSteps(const LinearTrainAtSpeed& train) : train_(train) {}

    const Step& of(const SlopePiece& piece) {
        const auto degree = static_cast<int>(piece.slope.size()) - 1;
        for (const Known& known : known_)
            if (known.degree == degree && std::abs(known.width - piece.width) <= same_width * piece.width)
                return known.step;
        known_.push_back({piece.width, degree, train_.step(piece.width, degree)});
        return known_.back().step;
    }

 private:
    struct Known {
        double width;
        int degree;
        Step step;
    };
    const LinearTrainAtSpeed& train_;
    std::deque<Known> known_;
};

std::vector<VectorXd> LinearTrainAtSpeed::states_along(std::span<const SlopePiece> pieces,
                                                       const VectorXd& start, double slope_before) const {
    KnownSteps steps(*this);
    std::vector<VectorXd> all;
    VectorXd state = start;
    double slope = slope_before;
    for (const SlopePiece& piece : pieces) {
        state += (piece.slope[0] - slope) * kick();
        all.push_back(state);
        const Step& step = steps.of(piece);
        state = step.state * state + step.drive * piece.slope;
        slope = piece.slope.sum();
    }
    all.push_back(state);
    return all;
}

VectorXd LinearTrainAtSpeed::steady_start(std::span<const SlopePiece> turn) const {
    KnownSteps steps(*this);
    MatrixXd whole = MatrixXd::Identity(states(), states());
    for (const SlopePiece& piece : turn) whole = steps.of(piece).state * whole;
    const double before = turn.back().slope.sum();
    const VectorXd forced = states_along(turn, VectorXd::Zero(states()), before).back();
    return solution_of(MatrixXd::Identity(states(), states()) - whole, forced);
}

VectorXd LinearTrainAtSpeed::state_inside(const VectorXd& begin_state, const SlopePiece& piece,
                                          double t) const {
    if (t <= 0.0) return begin_state;
    const Step whole = step(t * piece.width, static_cast<int>(piece.slope.size()) - 1);
    return whole.state * begin_state + whole.drive * VectorXd(shifted(piece.slope, 0.0, t));
}

}  // namespace camopt

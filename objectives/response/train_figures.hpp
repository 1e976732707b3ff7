// SPDX-License-Identifier: MIT
// The response of an elastic follower train: the events of a motion, the response to a motion, and the
// response as rows of a family of motions.
#pragma once

#include "scene/scene.hpp"
#include "splines/motion_family.hpp"

#include <complex>

namespace camopt {

// Excitation of a follower train: everything between two dwells, and the dwell after it, with free vibration.

/// Consecutive stretches of x: one, or two if it crosses the end of a closed program.
struct MotionStretch {
    double begin = 0.0, end = 0.0;
};

struct MotionEvent {
    std::vector<MotionStretch> moving;
    std::vector<MotionStretch>
        dwell;  ///< may lie beyond the motion: DRD and RR rest for the rest of the revolution
};

/// In the order of the cam angle. A closed program without a dwell has none.
[[nodiscard]] std::vector<MotionEvent> motion_events(const MotionSpec& motion);

/// One rise from rest over [0, 1], and a dwell for the rest: used to compare laws.
[[nodiscard]] MotionEvent single_rise(double unit_angle);

// The response of an elastic follower train to a motion: from rest over each event, at
// one speed or at the worst of a range.

/// A motion cut into the pieces of one event.
struct EventPieces {
    std::vector<SlopePiece> moving, dwell;
};
[[nodiscard]] EventPieces pieces_of_event(const std::vector<SlopePiece>& all, const MotionEvent& event);

/// One event at one speed, from rest.
class EventResponse {
 public:
    EventResponse(const TrainAtSpeed& train, const EventPieces& pieces);

    /// The amplitude after the event, in lifts: Σ over modes.
    [[nodiscard]] double residual() const { return residual_modes().cwiseAbs().sum(); }
    /// Mode by mode with its phase.
    [[nodiscard]] Eigen::VectorXcd residual_modes() const {
        return train_.modes() * end_.cast<std::complex<double>>();
    }
    /// Local maxima of sign · output above `floor`; with_dwell: including the free vibration.
    [[nodiscard]] std::vector<Extremum> maxima(const TrainAtSpeed::Reading& reading, double sign,
                                               double floor, bool with_dwell) const;
    /// The largest of them, without a floor.
    [[nodiscard]] Extremum largest(const TrainAtSpeed::Reading& reading, double sign, bool with_dwell) const;
    /// Of |output|.
    [[nodiscard]] Extremum largest_magnitude(const TrainAtSpeed::Reading& reading, bool with_dwell) const;

 private:
    const TrainAtSpeed& train_;
    const EventPieces& pieces_;
    std::vector<Eigen::VectorXd> states_;  ///< at the begin of each piece, moving ones first
    Eigen::VectorXd end_;                  ///< after the event, with y at rest
};

/// The scene's train. Throws InputError for one without its formulas.
[[nodiscard]] const TrainFormulas& train_of(const Scene& scene);
/// The same at one speed.
[[nodiscard]] std::unique_ptr<const TrainAtSpeed> train_at(const Scene& scene, double speed);
/// From the first to the last speed of the range, rad/s; twice the same where there is none.
[[nodiscard]] std::array<double, 2> response_speeds(const Scene& scene);

/// Local maxima of a function of the speed over the range, the largest first. Sampled so densely that the
/// phase at the end of `length` of x changes by less than a sixteenth of a cycle of the slowest mode between
/// two, then refined; only those near the largest count.
struct SpeedMaximum {
    double speed = 0.0, value = 0.0;
};
[[nodiscard]] std::vector<SpeedMaximum> maxima_over_speeds(const Scene& scene, double length,
                                                           const std::function<double(double)>& function);

// The state of a train as an affine function of the entries of a family of motions.

/// y' on a piece of a family, by powers of (x − begin) / width, each coefficient a row of the entries.
struct AffinePiece {
    double begin = 0.0, width = 0.0;
    std::vector<AffineRow> slope;
};

/// The pieces of one event: moving ones, then those of the dwell.
class EventRows {
 public:
    EventRows(const MotionFamily& family, const MotionEvent& event, const TrainFormulas& formulas);

    /// X at x on the event, as states x (entries + 1): the last column does not depend on the entries.
    [[nodiscard]] Eigen::MatrixXd state_at(const TrainAtSpeed& train, double x) const;
    /// X at its end.
    [[nodiscard]] Eigen::MatrixXd state_at_end(const TrainAtSpeed& train) const {
        return advanced(train, moving_, 0.0);
    }

 private:
    [[nodiscard]] Eigen::MatrixXd advanced(const TrainAtSpeed& train, std::size_t pieces, double rest) const;

    int entries_;
    std::vector<AffinePiece> pieces_;
    std::size_t moving_ = 0;
};

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The response of an elastic follower train to a motion: from rest over each event (motion_events.hpp), at
// one speed or at the worst of a range.
#pragma once

#include "core/numbers/extremum.hpp"
#include "objectives/response/motion_events.hpp"
#include "scene/scene.hpp"

#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace camopt {

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
    [[nodiscard]] double residual() const;
    /// Mode by mode with its phase.
    [[nodiscard]] Eigen::VectorXcd residual_modes() const;
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

/// The scene's train at one speed.
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

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Breakpoints of a scene that move, and what goes with them: rows at the same parts of the pieces, and the
// motion where it was.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"

namespace camopt {

/// Breakpoints of a scene and how they may move. A symmetric motion moves them in pairs; ends of regions of
/// constant velocity stay (of a program they are added to the breakpoints of a segment).
class MovingBreakpoints {
 public:
    /// `points`: where they start, in the units of spline.breakpoints. Segments stay longer than a part of
    /// the mean one, or than the shortest of `points`.
    MovingBreakpoints(const Scene& scene, const Peaks& reference, HeldStrokes strokes,
                      std::vector<double> points, CostUnits units = {});

    /// How many move separately.
    [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(moving_.size()); }
    /// Those that `moves`, in mean segments, lead to.
    [[nodiscard]] std::vector<double> points(const Eigen::VectorXd& moves) const;
    /// By how much each segment is longer than it must be, in mean segments, and its slope by the moves.
    [[nodiscard]] Eigen::VectorXd room(const Eigen::VectorXd& moves) const;
    [[nodiscard]] const Eigen::MatrixXd& room_slope() const { return room_slope_; }
    /// The scene on points(moves), in `units`.
    [[nodiscard]] CamModel model(const Eigen::VectorXd& moves) const;

 private:
    const Scene& scene_;
    Peaks reference_;
    HeldStrokes strokes_;
    CostUnits units_;
    std::vector<double> start_;
    std::vector<std::size_t> moving_;
    double mean_ = 1.0, least_ = 0.0;
    Eigen::MatrixXd room_slope_;
};

/// Samples that see the maxima which moving breakpoints shift: of every rule that is curved between
/// breakpoints.
[[nodiscard]] std::vector<RuleSample> samples_between(const CamModel& model);

/// Samples of one model for another one on other breakpoints: each at the same part of its piece. Empty where
/// the pieces are others.
[[nodiscard]] std::vector<RuleSample> moved_samples(const CamModel& from, const CamModel& to,
                                                    std::vector<RuleSample> samples);

/// x of a problem in states, on other breakpoints of as many entries: with the states that its motion has
/// there, continued from where the breakpoints were.
[[nodiscard]] Eigen::VectorXd carried(const CamProblem& from, const Eigen::VectorXd& x, const CamModel& to);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The state of a train as an affine function of the entries of a family of motions.
#pragma once

#include "objectives/response/train_figures.hpp"
#include "splines/motion_family.hpp"

#include <map>
#include <memory>
#include <vector>

namespace camopt {

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
    [[nodiscard]] Eigen::MatrixXd state_at_end(const TrainAtSpeed& train) const;

 private:
    [[nodiscard]] Eigen::MatrixXd advanced(const TrainAtSpeed& train, std::size_t pieces, double rest) const;

    int entries_;
    std::vector<AffinePiece> pieces_;
    std::size_t moving_ = 0;
};

}  // namespace camopt

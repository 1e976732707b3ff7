// SPDX-License-Identifier: MIT
// Extremes of a cam's figures over the whole motion: every piece is sampled densely, the best places are
// refined.
#pragma once

#include "tests/soak/figures/cam_point.hpp"
#include "tests/soak/figures/motion.hpp"

#include <functional>
#include <vector>

namespace camopt::soak {

class CamSurvey {
 public:
    CamSurvey(const Motion& motion, const Cam& cam);

    /// Of a point; −infinity where the point does not count. The largest over the motion.
    using Amount = std::function<double(const CamPoint&)>;
    [[nodiscard]] double largest(const Amount& amount) const;
    [[nodiscard]] double least(const Amount& amount) const;

    /// The largest |s'| of the motion: what counts as standing still is judged by it.
    [[nodiscard]] double fastest() const { return fastest_; }

 private:
    struct Sample {
        int piece = 0;
        long double x = 0;
        CamPoint point;
    };
    [[nodiscard]] CamPoint point(const Piece& piece, long double x) const;
    [[nodiscard]] double refined(const Amount& amount, std::size_t about) const;

    const Motion& motion_;
    const Cam& cam_;
    std::vector<Sample> samples_;
    double fastest_ = 0.0;
};

}  // namespace camopt::soak

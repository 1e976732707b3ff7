// SPDX-License-Identifier: MIT
// Round numbers for an axis.
#pragma once

#include <string>
#include <vector>

namespace camopt {

struct PlotTick {
    double value = 0.0;
    std::string words;  ///< empty: a line of the grid without a label
};

/// Multiples of a round step (1, 2 or 5 times a power of ten) in [lower, upper]: about `wanted` of them.
[[nodiscard]] std::vector<double> round_ticks(double lower, double upper, int wanted);

/// The same for an angle in degrees: steps a protractor knows (1, 2, 5, 10, 15, 30, 45, 60, 90 …).
[[nodiscard]] std::vector<double> degree_ticks(double lower, double upper, int wanted);

/// round_ticks with their texts: just the decimals that the step between them needs, however few they are.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(double lower, double upper, int wanted);

/// The number with just the decimals that tell it from its neighbours.
[[nodiscard]] std::string tick_text(double value, double step);

/// The least and the largest of the finite numbers seen; [0, 0] before the first one.
struct ValueRange {
    double lower = 0.0, upper = 0.0;
    bool started = false;

    void add(double value);
    [[nodiscard]] bool empty() const { return !(upper >= lower) || !started; }
    /// A little wider, and never of no width.
    [[nodiscard]] ValueRange padded(double part) const;
};

}  // namespace camopt

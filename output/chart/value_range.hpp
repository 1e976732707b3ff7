// SPDX-License-Identifier: MIT
#pragma once

namespace camopt {

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

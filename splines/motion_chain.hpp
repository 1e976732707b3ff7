// SPDX-License-Identifier: MIT
// A sequence of motions: one revolution of dwells, laws and splines as one Motion.
//
// On its interval each part follows y(x) = y0 + y_scale · shape((x − x0) / x_scale); a dwell has no shape and
// stays at y0. The r-th derivative is y_scale / x_scale^r · shape^{(r)}. x_scale < 0 mirrors the shape: it is
// traversed from its end to its begin, and its left side is seen from the right.
#pragma once

#include "core/motion.hpp"

namespace camopt {

struct ChainPart {
    double begin = 0.0, end = 0.0;        ///< x
    std::shared_ptr<const Motion> shape;  ///< none: a dwell
    double x0 = 0.0, x_scale = 1.0;       ///< x_scale not 0
    double y0 = 0.0, y_scale = 1.0;
};

/// Enclosures of y to its fourth derivative over `x`, inside the part between two breakpoints of its shape;
/// nullopt if the shape has none.
[[nodiscard]] std::optional<std::array<Interval, 5>> ranges_of(const ChainPart& part, const Interval& x);

class MotionChain final : public Motion {
 public:
    /// Throws InputError for an empty list, or if a part does not begin where the one before it ended.
    explicit MotionChain(std::vector<ChainPart> parts);

    [[nodiscard]] double begin() const override { return parts_.front().begin; }
    [[nodiscard]] double end() const override { return parts_.back().end; }
    [[nodiscard]] MotionPoint at(double x, Side side = Side::right) const override;
    [[nodiscard]] std::vector<double> breakpoints() const override;
    /// y^{(order)}, 3 or higher, of a dwell or a spline; NaN where another shape has no such derivative.
    [[nodiscard]] double higher_derivative(double x, int order, Side side) const;

    [[nodiscard]] const std::vector<ChainPart>& parts() const { return parts_; }

 private:
    std::vector<ChainPart> parts_;
    std::vector<std::vector<double>> own_breakpoints_;  ///< of each shape; empty for a dwell

    [[nodiscard]] std::size_t part_at(double x, Side& side) const;
};

/// Index of the interval [begins_i, begins_{i+1}) that holds x, of (…] as seen from the left; clamped.
[[nodiscard]] int interval_of(const std::vector<double>& begins, double x, Side side);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A motion: displacement and its first three derivatives by the cam angle.
//
// Normalised form: x = cam angle / rise angle, y = displacement / lift; ' is d/dx. A DRD motion lives on
// [0, 1], an RR motion on [0, 1 + return angle / rise angle]. No units; physical ones return in output/.
#pragma once

#include "core/numbers/extremum.hpp"
#include "core/numbers/interval.hpp"

#include <array>
#include <optional>
#include <vector>

namespace camopt {

/// (y, y', y'', y''') at x. Index r of `derivative` is the r-th derivative.
struct MotionPoint {
    double x = 0.0;
    std::array<double, 4> derivative{};
};

/// A curve y(x) with exact derivatives up to the third, never a numeric one.
class Motion {
 public:
    virtual ~Motion() = default;

    [[nodiscard]] virtual double begin() const = 0;
    [[nodiscard]] virtual double end() const = 0;

    /// The point at x in [begin, end]. Where a derivative jumps, its limit from `side`. Infinite where it is.
    [[nodiscard]] virtual MotionPoint at(double x, Side side = Side::right) const = 0;

    /// Enclosures of y to its fourth derivative over `x`, a stretch between two neighbouring breakpoints.
    /// Returns nullopt if no enclosure is implemented.
    [[nodiscard]] virtual std::optional<std::array<Interval, 5>> ranges(const Interval& x) const {
        static_cast<void>(x);
        return {};
    }

    /// Ascending x where a derivative up to the third may jump or change its formula, begin and end included.
    [[nodiscard]] virtual std::vector<double> breakpoints() const = 0;

 protected:
    Motion() = default;
    Motion(const Motion&) = default;
    Motion& operator=(const Motion&) = default;
    Motion(Motion&&) = default;
    Motion& operator=(Motion&&) = default;
};

/// The state of a follower at one cam angle, the input of every cam generator: displacement and its
/// derivatives by the cam angle, SI: m, m/rad, m/rad² (rad, 1, 1/rad where it swings).
struct FollowerState {
    double s = 0.0, velocity = 0.0, acceleration = 0.0;  ///< s, s', s''
};

/// The shape of a rule g <= 0 over all motions whose displacements stay in a range, and all parameters in
/// their bounds.
enum class Curvature { linear, convex, general };

}  // namespace camopt

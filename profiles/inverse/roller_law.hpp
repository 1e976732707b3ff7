// SPDX-License-Identifier: MIT
// The roller's motion along its axis: strokes of constant acceleration, one after the other.
//
//   L(t) = position + velocity · (t - reference) + acceleration · (t - reference)² / 2   for begin <= t <=
//   end
// m, s. Errors: InputError where strokes do not follow one another in time or the roller jumps between them.
#pragma once

#include "core/numbers/extremum.hpp"

#include <vector>

namespace camopt {

struct RollerStroke {
    double begin = 0.0, end = 0.0, reference = 0.0;             ///< s
    double position = 0.0, velocity = 0.0, acceleration = 0.0;  ///< m, m/s, m/s² at the reference
};

struct RollerState {
    double distance = 0.0, velocity = 0.0, acceleration = 0.0;  ///< L, dL/dt, d²L/dt²
};

class RollerLaw {
 public:
    explicit RollerLaw(std::vector<RollerStroke> strokes);

    [[nodiscard]] double begin() const { return strokes_.front().begin; }
    [[nodiscard]] double end() const { return strokes_.back().end; }
    [[nodiscard]] const std::vector<RollerStroke>& strokes() const { return strokes_; }
    /// Where strokes meet, the one on `side`. Throws InputError outside [begin, end].
    [[nodiscard]] RollerState at(double time, Side side = Side::right) const;

 private:
    std::vector<RollerStroke> strokes_;
};

[[nodiscard]] RollerState state_of(const RollerStroke& stroke, double time);

/// The time within the stroke at which the roller is at `distance`; NaN if it never is. The stroke must not
/// reverse inside; of two times the one inside [begin, end].
[[nodiscard]] double time_at(const RollerStroke& stroke, double distance);

}  // namespace camopt

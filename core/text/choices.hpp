// SPDX-License-Identifier: MIT
// Choices that a scene names and the numerics below it know.
#pragma once

#include <string>
#include <variant>

namespace camopt {

/// Dwell-rise-dwell, rise-return, or a program of segments.
enum class MotionType { drd, rr, program };

/// What the entries of a design vector are (splines/design_vector.hpp).
enum class DesignKind { automatic, ordinates, coefficients, states };

/// A value of a backend's own option.
using OptionValue = std::variant<bool, long long, double, std::string>;

[[nodiscard]] const char* name_of(MotionType value);
[[nodiscard]] const char* name_of(DesignKind value);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The interval allowed for a number of a scene, with its words in error messages. Used by the validation of a
// Scene and by the key table of the scene reader.
#pragma once

#include <limits>
#include <string>

namespace camopt {

/// An interval; bounds without a value are infinite. Numbers that are not finite are never inside.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_included = true;
    bool high_included = true;

    [[nodiscard]] static constexpr Range above(double low) { return {.low = low, .low_included = false}; }
    [[nodiscard]] static constexpr Range at_least(double low) { return {.low = low}; }
    [[nodiscard]] static constexpr Range between(double low, double high) {
        return {.low = low, .high = high};
    }
    [[nodiscard]] static constexpr Range above_up_to(double low, double high) {
        return {.low = low, .high = high, .low_included = false};
    }

    [[nodiscard]] bool contains(double value) const;

    /// The interval after a change of unit: both bounds times `factor` > 0.
    [[nodiscard]] Range scaled(double factor) const;

    /// "", "> 0", ">= 0", "> 0 and <= 360", "from 2 to 4".
    [[nodiscard]] std::string text() const;

    /// "a number > 0", "an integer from 2 to 4", "a finite number".
    [[nodiscard]] std::string number_text() const;
    [[nodiscard]] std::string integer_text() const;
};

namespace ranges {

inline constexpr Range any = {};
inline constexpr Range positive = {.low = 0.0, .low_included = false};
inline constexpr Range not_negative = {.low = 0.0};

}  // namespace ranges
}  // namespace camopt

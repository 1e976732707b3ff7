// SPDX-License-Identifier: MIT
// How far a made cam may be from its drawing. Every limit of the scene then holds for every cam within it: a
// made cam moves its follower by s + δ with |δ| <= profile, |δ'| <= slope, |δ''| <= acceleration, and its
// numbers lie within ± of those of the drawing. SI: m (of an output that swings rad), by rad of cam angle.
// A scene without a ToleranceSpec evaluates none of it.
#pragma once

#include "core/base/standard.hpp"

#include <map>

namespace camopt {

/// ± of a number.
struct NumberTolerance {
    double size = 0.0;     ///< SI, or percent of the number
    bool percent = false;  ///< of the magnitude of the number; of a range that of its larger end

    [[nodiscard]] double half_width(double number) const {
        return percent ? size / 100.0 * std::abs(number) : size;
    }
    friend bool operator==(const NumberTolerance&, const NumberTolerance&) = default;
};

/// One cam within the tolerances, in parts of them from −1 to 1.
struct MadeParts {
    std::array<double, 3> motion = {};  ///< of the errors of s, s', s''
    std::vector<double> numbers = {};   ///< of ToleranceSpec::numbers, in their order

    friend bool operator==(const MadeParts&, const MadeParts&) = default;
};

struct ToleranceSpec {
    /// |δ|, |δ'|, |δ''|; none: 0 of δ and δ', not bounded of δ'' (limits on s'' and curvature then leave
    /// it out, and say so).
    std::array<std::optional<double>, 3> motion = {};
    /// By the name under which a scene writes a dimension of the cam ("base_radius", CamSpec::written_as) or
    /// a number of the spring ("preload", "spring_rate").
    std::map<std::string, NumberTolerance> numbers = {};
    /// Cams between the ends of the tolerances that limits are held for, too: the solve finds those that
    /// would pass one (objectives/rules/maxima/between_ends.hpp).
    std::vector<MadeParts> between = {};

    [[nodiscard]] double of_motion(std::size_t order) const {
        return order < motion.size() ? motion[order].value_or(0.0) : 0.0;
    }
    friend bool operator==(const ToleranceSpec&, const ToleranceSpec&) = default;
};

/// The names of derivatives of δ, as keys of the table.
inline constexpr std::array motion_tolerance_names = {"profile", "slope", "acceleration"};

/// Each of them doubles the ends that a limit is held at.
inline constexpr std::size_t most_tolerant_numbers = 6;

}  // namespace camopt

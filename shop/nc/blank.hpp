// SPDX-License-Identifier: MIT
// The blank that a cam is cut from: a full cylinder about the cam's axis, of a plate that slides a block, and
// how far a cutter is from it.
//
//   { x² + y² <= radius², lower <= z <= upper }      cam frame (machine.hpp), m
//   { (x, y) in block, lower <= z <= upper }
// Bores and what is cut already are left out: where rapids are concerned a blank is full. A cutter is its
// cylinder without an upper end: what holds it is at least as thick and stands above.
#pragma once

#include "shop/nc/machine.hpp"

#include <Eigen/Geometry>

namespace camopt {

struct Blank {
    double radius = 0.0;              ///< m, > 0; of a block 0
    double lower = 0.0, upper = 0.0;  ///< z of its ends, m, lower < upper
    /// In place of the cylinder, m.
    std::optional<Eigen::AlignedBox2d> block = {};

    void validate() const;  ///< throws InputError
    /// The greatest d · p of its points; `direction` need not be a unit vector.
    [[nodiscard]] double support(const Eigen::Vector3d& direction) const;
    /// From the origin of the cam frame to its farthest point.
    [[nodiscard]] double reach() const {
        return std::hypot(farthest_from_axis(), std::max(std::abs(lower), std::abs(upper)));
    }
    /// From the axis, m.
    [[nodiscard]] double farthest_from_axis() const;
    /// Its point nearest to this one.
    [[nodiscard]] Eigen::Vector3d nearest(const Eigen::Vector3d& point) const;
};

/// What the user says of a blank; the rest is the cam's extent and the allowance.
struct BlankChoice {
    std::optional<double> radius = {}, lower = {}, upper = {};  ///< m
    double allowance = 5e-3;                                    ///< m, >= 0, all around

    void validate() const;  ///< throws InputError
};
[[nodiscard]] Blank chosen_blank(const Blank& with_allowance, const BlankChoice& choice);

/// The greatest height over the origin, along the tool, that the blank can have however the machine's table
/// stands: max of −O · p over its points and the directions O that the machine knows.
[[nodiscard]] double greatest_height(const Blank& blank, const Machine& machine);

/// From the cutter's side and end to the blank, m: never more than the true distance, and equal to it but for
/// rounding where an end face or a side decides. Zero or less: they cannot be told apart.
[[nodiscard]] double distance_to_blank(const Blank& blank, const ToolPose& pose, double cutter_radius);

/// For the program's reader: size and place, mm.
[[nodiscard]] std::string words_of(const Blank& blank);

/// Where clamps are that have the form of a blank: "within diameter 30 mm about the cam's axis", "below y =
/// 12 mm along the plate".
[[nodiscard]] std::string clamp_words(const Blank& clamp);

}  // namespace camopt

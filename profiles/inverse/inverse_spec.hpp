// SPDX-License-Identifier: MIT
// The dimensions of an inverse cam and its feeder: their names, once for the scene reader and the formulas
// (profiles/inverse/inverse_mechanism.hpp).
#pragma once

#include "scene/cam_spec.hpp"

namespace camopt {

struct CamKind;

/// cam.type of such a cam.
inline constexpr const char* inverse_type = "inverse";

enum class InverseNumber {
    roller_radius,
    roller_rest,     ///< L where the roller started from rest
    roller_end,      ///< L where its stroke ends
    roller_angle,    ///< cam angle of that stroke, rad
    roller_from,     ///< L where the rise begins
    pin_distance,    ///< L1
    pin_angle,       ///< al0, rad
    rocker_pivot_x,  ///< C
    rocker_pivot_y,
    feeder_offset,  ///< Lx
    feeder_start    ///< Y at displacement 0
};
inline constexpr int inverse_number_count = 11;
[[nodiscard]] const char* name_of_number(InverseNumber value);  ///< "roller_radius", …

/// Type "inverse", every number at 0, without formulas: inverse_spec of inverse_mechanism.hpp adds them.
[[nodiscard]] CamSpec blank_inverse_spec();

/// Inverse cams with a feeder, as scene files know them.
[[nodiscard]] CamKind inverse_kind();

/// Cam angle of the roller's return, rad, which a scene may give behind the numbers above.
[[nodiscard]] std::optional<double> return_angle(const CamSpec& spec);

}  // namespace camopt

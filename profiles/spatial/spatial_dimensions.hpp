// SPDX-License-Identifier: MIT
// The dimensions of a three-dimensional cam, and the quantities that limits ask of it. Frames, signs and
// formulas: profiles/spatial/spatial_cam.hpp.
#pragma once

#include "profiles/spatial/spatial_spec.hpp"

namespace camopt {

/// The dimensions on which limits depend. m.
enum class SpatialDimension {
    roller_radius,
    arm_length,  ///< barrel: index radius r_i; rotating: f_l, pivot to the roller's near end; else unused
    center_distance,  ///< barrel: l3; rotating: dy; translating: ρ0, from the cam's axis to the near end
    lateral_offset    ///< barrel: l1; else dx
};
inline constexpr int spatial_dimension_count = 4;
[[nodiscard]] const char* name_of(SpatialDimension value);  ///< "roller_radius", …

/// All that determines a cam.
struct SpatialDimensions {
    SpatialFollower follower = SpatialFollower::barrel;
    Rotation rotation = Rotation::counterclockwise;
    std::array<double, spatial_dimension_count> dimensions{};  ///< by SpatialDimension
    double axial_offset = 0.0;   ///< l2, dz, z0: shifts the cam along its axis and changes nothing else
    double start = 0.0;          ///< q = start + s; rad, m
    double roller_length = 0.0;  ///< stations 0 <= h <= roller_length
    DrumForm form = {};

    [[nodiscard]] double operator[](SpatialDimension index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
    /// Half the width of the groove: from the roller's axis to either flank.
    [[nodiscard]] double groove_radius() const {
        return (*this)[SpatialDimension::roller_radius] + 0.5 * form.groove_clearance;
    }
    [[nodiscard]] double& operator[](SpatialDimension index) {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

/// Quantities in limits.
enum class SpatialQuantity {
    pressure_numerator,    ///< tan φ = numerator / denominator; m
    pressure_denominator,  ///< m; > 0 in a cam without geometry_fault
    undercut,              ///< g
    normal_lever,          ///< force along the normal = F / lever or M / lever; m of a follower that swings
    contact_radius         ///< of the Hertz pressure (spatial_cam.hpp); m
};

}  // namespace camopt

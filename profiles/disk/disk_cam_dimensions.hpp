// SPDX-License-Identifier: MIT
// The disk cam as a value. Frames, signs and formulas: profiles/disk/disk_cam.hpp.
#pragma once

#include "profiles/disk/disk_spec.hpp"

namespace camopt {

/// A cam with all its dimensions fixed.
struct DiskCam {
    FollowerType follower = FollowerType::translating_roller;
    Rotation rotation = Rotation::counterclockwise;
    std::array<double, dimension_count> dimensions{};  ///< by DimensionIndex
    FormSpec form = {};                                ///< both sides of it: disk_cam.hpp

    [[nodiscard]] double operator[](DimensionIndex index) const {
        return dimensions[static_cast<std::size_t>(index)];
    }
};

}  // namespace camopt

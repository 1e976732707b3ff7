// SPDX-License-Identifier: MIT
// profile.svg: the cam to scale in the cam frame, with its pitch curve, base and prime circle, its follower
// where the motion begins and, paler, every 60°, a mark every 30° of cam angle, the direction of rotation and
// its dimensions. Stretches that are undercut are red, and said to be.
#pragma once

#include "output/drawing/profile_shape.hpp"

#include <string>
#include <string_view>

namespace camopt {

/// A shape that is not closed is drawn as the sector it is.
[[nodiscard]] std::string profile_svg(const ProfileShape& shape, std::string_view title);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The delivered motion in result.json, complete: its splines as the polynomials they are, and how the parts
// are chained. input/result/ reads it back.
#pragma once

#include "output/json/json_text.hpp"
#include "splines/motion_chain.hpp"

namespace camopt {

/// Parts that share a spline name the same curve.
[[nodiscard]] Json motion_json(const MotionChain& motion);

}  // namespace camopt

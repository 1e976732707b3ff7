// SPDX-License-Identifier: MIT
#pragma once

namespace camopt {

/// The shape of a rule g <= 0 over all motions whose displacements stay in a range, and all parameters in
/// their bounds.
enum class Curvature { linear, convex, general };

}  // namespace camopt

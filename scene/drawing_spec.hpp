// SPDX-License-Identifier: MIT
// What a workshop drawing and a solid of a disk cam need beyond its profile. Nothing of it moves the motion.
// m and rad. Angles are cam angles: the ray of the cam that points along +y when the cam has turned by so
// much from where the motion begins.
#pragma once

#include <cmath>
#include <optional>
#include <string>

namespace camopt {

/// A parallel slot in the bore.
struct Keyway {
    double width = 0.0;  ///< m, > 0, below the bore's diameter
    double depth = 0.0;  ///< m, > 0: its floor lies so far outside the bore's circle
    double at = 0.0;     ///< rad: its middle

    /// From the centre to the corners of its floor in a bore of this radius.
    [[nodiscard]] double reach(double bore_radius) const {
        return std::hypot(bore_radius + depth, 0.5 * width);
    }
};

/// What the title block says beside the scene's title; empty: nothing.
struct TitleBlock {
    std::string part = {}, material = {}, tolerance = {}, drawn_by = {};
};

struct DrawingSpec {
    std::optional<double> bore = {};          ///< m, diameter, > 0; none: the cam has no hole
    std::optional<Keyway> keyway = {};        ///< only in a bore
    std::optional<double> thickness = {};     ///< m, > 0
    std::optional<double> groove_depth = {};  ///< m, > 0: of a grooved cam; none: half the thickness
    double datum = 0.0;                       ///< rad: where the cam is marked; tables count from there
    TitleBlock title_block = {};

    /// m: how far bore and keyway reach from the centre; 0: there is no bore.
    [[nodiscard]] double reach() const {
        if (!bore) return 0.0;
        return keyway ? keyway->reach(0.5 * *bore) : 0.5 * *bore;
    }
};

}  // namespace camopt

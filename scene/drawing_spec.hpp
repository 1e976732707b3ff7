// SPDX-License-Identifier: MIT
// Data of a workshop drawing and a solid of a disk cam in addition to its profile, without effect on the
// motion. m and rad. Angles are cam angles: the ray of the cam that points along +y when the cam has turned
// by this angle from the start of the motion.
#pragma once

#include <cmath>
#include <optional>
#include <string>

namespace camopt {

/// A parallel slot in the bore.
struct Keyway {
    double width = 0.0;  ///< m, > 0, below the bore's diameter
    double depth = 0.0;  ///< m, > 0: distance of its floor outside the bore's circle
    double at = 0.0;     ///< rad: its middle

    /// From the centre to the corners of its floor in a bore of this radius.
    [[nodiscard]] double reach(double bore_radius) const {
        return std::hypot(bore_radius + depth, 0.5 * width);
    }
};

/// Text of the title block in addition to the scene's title; empty: none.
struct TitleBlock {
    std::string part = {}, material = {}, tolerance = {}, drawn_by = {};
};

struct DrawingSpec {
    std::optional<double> bore = {};          ///< m, diameter, > 0; none: the cam has no hole
    std::optional<Keyway> keyway = {};        ///< only in a bore
    std::optional<double> thickness = {};     ///< m, > 0
    std::optional<double> groove_depth = {};  ///< m, > 0: of a grooved cam; none: half the thickness
    double datum = 0.0;                       ///< rad: the mark of the cam; tables count from there
    TitleBlock title_block = {};

    /// m: reach of bore and keyway from the centre; 0: there is no bore.
    [[nodiscard]] double reach() const {
        if (!bore) return 0.0;
        return keyway ? keyway->reach(0.5 * *bore) : 0.5 * *bore;
    }
};

}  // namespace camopt

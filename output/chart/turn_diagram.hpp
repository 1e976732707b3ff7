// SPDX-License-Identifier: MIT
// Quantities of a cam over the cam angle: one panel each, one below the other, with limits dotted and
// extremes marked. Degrees; values in the unit that is shown.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace camopt {

/// A limit over a stretch of the cam.
struct TurnLimit {
    double begin = 0.0, end = 0.0;  ///< deg
    double value = 0.0;
    std::string words;  ///< empty: none
};

/// An extreme to name.
struct TurnMark {
    double at = 0.0, value = 0.0;  ///< at: deg
    bool above = true;             ///< where the label stands
};

struct TurnPanel {
    std::string caption, unit;
    std::vector<std::vector<Eigen::Vector2d>> pieces;  ///< (deg, value); between two pieces it may jump
    std::function<std::string(double value)> words;    ///< of an extreme: "φ = 12.3°"
    std::vector<TurnLimit> limits;
    double least_range = 0.0;                         ///< of the axis
    double bound = 0.0;                               ///< values beyond ± this are cut off; 0: none
    std::optional<std::vector<TurnMark>> marks = {};  ///< none: the extremes of the curve
};

struct TurnDiagram {
    std::string title;
    double begin = 0.0, end = 0.0;  ///< deg
    std::vector<double> knots;      ///< deg: where the motion changes its formula
    std::vector<TurnPanel> panels;
};

[[nodiscard]] std::string turn_diagram_svg(const TurnDiagram& diagram);

}  // namespace camopt

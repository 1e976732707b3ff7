// SPDX-License-Identifier: MIT
// Drawing in the cam frame: metres in, px out, the same scale both ways.
#pragma once

#include "output/chart/svg_canvas.hpp"

#include <Eigen/Core>

#include <span>
#include <string_view>

namespace camopt {

struct ProfileCanvas {
    SvgCanvas& canvas;
    Eigen::Vector2d origin;  ///< px of the cam's centre
    double scale = 1.0;      ///< px per m

    [[nodiscard]] Eigen::Vector2d place(const Eigen::Vector2d& point) const {
        return {origin.x() + scale * point.x(), origin.y() - scale * point.y()};
    }
    /// Metres of so many px, for marks whose size does not depend on the cam.
    [[nodiscard]] double px(double count) const { return count / scale; }

    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view css_class) const;
    void circle(const Eigen::Vector2d& center, double radius, std::string_view css_class) const;
    void polyline(std::span<const Eigen::Vector2d> points, bool closed, std::string_view css_class) const;
    /// The words' middle at the point.
    void text(const Eigen::Vector2d& middle, std::string_view words, std::string_view css_class) const;
};

}  // namespace camopt

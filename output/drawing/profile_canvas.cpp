// SPDX-License-Identifier: MIT
#include "output/drawing/profile_canvas.hpp"

#include <string>

namespace camopt {

using Eigen::Vector2d;

void ProfileCanvas::line(const Vector2d& from, const Vector2d& to, std::string_view css_class) const {
    const Vector2d a = place(from), b = place(to);
    canvas.line(a.x(), a.y(), b.x(), b.y(), css_class);
}

void ProfileCanvas::circle(const Vector2d& center, double radius, std::string_view css_class) const {
    const Vector2d middle = place(center);
    canvas.circle(middle.x(), middle.y(), scale * radius, css_class);
}

void ProfileCanvas::polyline(std::span<const Vector2d> points, bool closed,
                             std::string_view css_class) const {
    std::string data;
    for (const Vector2d& point : points) {
        const Vector2d at = place(point);
        data += (data.empty() ? "M" : "L") + svg_number(at.x()) + " " + svg_number(at.y());
    }
    canvas.path(closed ? data + "Z" : data, css_class);
}

void ProfileCanvas::text(const Vector2d& middle, std::string_view words, std::string_view css_class) const {
    const Vector2d at = place(middle);
    canvas.text(at.x(), at.y() + 4.0, words, css_class);
}

}  // namespace camopt

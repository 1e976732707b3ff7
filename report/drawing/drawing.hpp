// SPDX-License-Identifier: MIT
// A plane drawing as a value: lines, arcs, circles and words in named styles, from which pictures, workshop
// drawings, DXF files and pages are made.
//
// m, rad, y upwards. A style is a name ("cam", "pitch"); what it looks like and what lies above what is up
// to each back end: SVG below, shop/dxf/dxf_drawing.hpp, shop/sheet/pdf, report/page. Nothing here knows a
// cam.
#pragma once

#include "core/units.hpp"
#include "report/chart/svg_canvas.hpp"

#include <Eigen/Core>

#include <variant>

namespace camopt {

/// A point of a path and the arc from it to the next one: bulge = tan(angle / 4), > 0 turns to the left,
/// 0 is a straight line.
struct ArcVertex {
    Eigen::Vector2d position;
    double bulge = 0.0;
};

/// An arc between two vertices as a circle: bulge not 0.
struct BulgeArc {
    Eigen::Vector2d center;
    double radius, from, to;  ///< rad; to > from where it turns to the left
};
// Inline: a painter may be in a separate part (core/platform/parts.hpp).
[[nodiscard]] inline BulgeArc bulge_arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                        double bulge) {
    const Eigen::Vector2d chord = to - from, left(-chord.y(), chord.x());
    const Eigen::Vector2d center = 0.5 * (from + to) + (1.0 - bulge * bulge) / (4.0 * bulge) * left;
    const Eigen::Vector2d out = from - center;
    const double begin = std::atan2(out.y(), out.x());
    return {center, out.norm(), begin, begin + 4.0 * std::atan(bulge)};
}

struct DrawnPath {
    std::string style;
    std::vector<ArcVertex> vertices;  ///< closed: the last arc leads back to the first
    bool closed = false;
};
struct DrawnCircle {
    std::string style;
    Eigen::Vector2d center = {0.0, 0.0};
    double radius = 0.0;
};
/// One line on its baseline; its height is that of a capital letter.
struct DrawnText {
    std::string style;
    Eigen::Vector2d at = {0.0, 0.0};  ///< of the anchor
    double height = 2.5e-3;
    std::string words;  ///< UTF-8
    TextSide anchor = TextSide::start;
    double turn = 0.0;  ///< counterclockwise
};
/// Of a text's width, what lies before its anchor.
[[nodiscard]] inline double share_before(TextSide anchor) {
    return anchor == TextSide::start ? 0.0 : anchor == TextSide::middle ? 0.5 : 1.0;
}
/// A dimension: what it measures of the drawing, and where its line and words stand.
struct DrawnDimension {
    enum class Kind {
        linear,    ///< from first to second along `direction`; the line passes through `place`
        diameter,  ///< of the circle about first through second; words at `place`, a leader to second
        radius,    ///< likewise
        angle  ///< about first, from the ray `direction` counterclockwise by `sweep`; the arc through `place`
    };
    Kind kind = Kind::linear;
    Eigen::Vector2d first = {0.0, 0.0}, second = {0.0, 0.0};
    double direction = 0.0, sweep = 0.0;
    Eigen::Vector2d place = {0.0, 0.0};
    bool across = false;  ///< linear: it measures a diameter, and its words say so
    LengthUnit lengths = LengthUnit::millimetre;
    std::string tolerance = {};  ///< behind the number: "H7"

    /// m, or rad of an angle.
    [[nodiscard]] double measured() const;
};
using DrawnElement = std::variant<DrawnPath, DrawnCircle, DrawnText>;

struct DrawingBox {
    Eigen::Vector2d least = Eigen::Vector2d::Constant(HUGE_VAL), most = Eigen::Vector2d::Constant(-HUGE_VAL);

    /// A point, or a square about it.
    void add(const Eigen::Vector2d& point, double half = 0.0) {
        least = least.cwiseMin(point - Eigen::Vector2d::Constant(half));
        most = most.cwiseMax(point + Eigen::Vector2d::Constant(half));
    }
    [[nodiscard]] Eigen::Vector2d size() const { return most - least; }
};

struct Drawing {
    std::vector<DrawnElement> elements;

    void path(std::string style, std::vector<ArcVertex> vertices, bool closed = false) {
        elements.emplace_back(DrawnPath{std::move(style), std::move(vertices), closed});
    }
    void polyline(std::string style, std::span<const Eigen::Vector2d> points, bool closed = false);
    void line(std::string style, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        path(std::move(style), {{from, 0.0}, {to, 0.0}});
    }
    /// Of a circle, from angle to angle (rad), counterclockwise where `to` is larger.
    void arc(std::string style, const Eigen::Vector2d& center, double radius, double from, double to);
    void rectangle(std::string style, const Eigen::Vector2d& low, const Eigen::Vector2d& high);
    void circle(std::string style, const Eigen::Vector2d& center, double radius) {
        elements.emplace_back(DrawnCircle{std::move(style), center, radius});
    }
    void text(DrawnText text) { elements.emplace_back(std::move(text)); }
    void add(const Drawing& other);
    void move(const Eigen::Vector2d& offset);
    void scale(double factor);  ///< about the origin, heights of words too
    /// Of vertices and circles; an arc may reach a little beyond, words do not count.
    [[nodiscard]] DrawingBox box() const;
    [[nodiscard]] bool has(std::string_view style) const;
};

[[nodiscard]] const std::string& style_of(const DrawnElement& element);
inline constexpr double capital_height = 0.729;  ///< of a font's size: of DejaVu Sans

// The back end SVG.

/// Where a point of the drawing lies in a picture: origin.x + scale.x x, origin.y − scale.y y.
struct PicturePlace {
    Eigen::Vector2d origin = {0.0, 0.0}, scale = {1.0, 1.0};

    [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& point) const {
        return {origin.x() + scale.x() * point.x(), origin.y() - scale.y() * point.y()};
    }
    /// m of so many px, for marks whose size does not depend on what is drawn.
    [[nodiscard]] double px(double count) const { return count / scale.x(); }
};

/// How a style looks in pictures. The first of a list lies at the bottom.
struct PictureStyle {
    const char* name = "";
    const char* css = "";
};
/// CSS rules of the styles; an open path of a filled style is not filled.
[[nodiscard]] std::string css_of(std::span<const PictureStyle> styles);
/// Its elements of these styles, those of the first style first. Arcs and words need the same scale both
/// ways.
void draw(SvgCanvas& canvas, const Drawing& drawing, const PicturePlace& place,
          std::span<const PictureStyle> styles);

}  // namespace camopt

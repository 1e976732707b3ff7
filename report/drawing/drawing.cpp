// SPDX-License-Identifier: MIT
#include "report/drawing/drawing.hpp"

#include "core/word_of.hpp"
#include "report/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr std::string_view open_class = "sector";

bool is_filled(const PictureStyle& style) {
    return std::string_view(style.css).starts_with("fill:#");
}

/// Path data.
std::string svg_path(const DrawnPath& path, const PicturePlace& place, const SvgCanvas& canvas) {
    constexpr double straight = 1e-9;  // of a bulge: its arc leaves the chord by no more than that part of it
    const std::vector<ArcVertex>& vertices = path.vertices;
    std::string data;
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count + (path.closed ? 1 : 0); ++i) {
        const Vector2d at = place(vertices[i % count].position);
        const double bulge = i == 0 ? 0.0 : vertices[i - 1].bulge;
        if (std::abs(bulge) > straight) {
            const double radius =
                place.scale.x() *
                bulge_arc(vertices[i - 1].position, vertices[i % count].position, bulge).radius;
            data += fmt::format("A{0} {0} 0 {1} {2} ", canvas.number(radius), std::abs(bulge) > 1.0 ? 1 : 0,
                                bulge > 0.0 ? 0 : 1);
        } else if (i == count) {
            break;
        } else {
            data += i == 0 ? "M" : "L";
        }
        data += canvas.number(at.x()) + " " + canvas.number(at.y());
    }
    return path.closed ? data + "Z" : data;
}

struct SvgDrawer {
    SvgCanvas& canvas;
    const PicturePlace& place;
    const PictureStyle& style;

    void operator()(const DrawnPath& path) const {
        std::string css_class = style.name;
        if (!path.closed && path.vertices.size() > 2 && is_filled(style))
            css_class.append(" ").append(open_class);
        canvas.path(svg_path(path, place, canvas), css_class);
    }
    void operator()(const DrawnCircle& circle) const {
        const Vector2d middle = place(circle.center);
        canvas.circle(middle.x(), middle.y(), place.scale.x() * circle.radius, style.name);
    }
    void operator()(const DrawnText& text) const {
        const Vector2d at = place(text.at);
        canvas.text(at.x(), at.y(), text.words,
                    std::string(style.name) + word_of<TextSide::end>(text.anchor, {"", " middle", " end"}),
                    degrees_shown.of(text.turn), place.scale.x() * text.height / capital_height);
    }
};

}  // namespace

void Drawing::polyline(std::string style, std::span<const Vector2d> points, bool closed) {
    std::vector<ArcVertex> vertices;
    vertices.reserve(points.size());
    for (const Vector2d& point : points) vertices.push_back({point, 0.0});
    path(std::move(style), std::move(vertices), closed);
}

void Drawing::arc(std::string style, const Vector2d& center, double radius, double from, double to) {
    const auto at = [&](double angle) -> Vector2d {
        return center + radius * Vector2d(std::cos(angle), std::sin(angle));
    };
    const double half = 0.5 * (to - from), bulge = std::tan(0.25 * half);  // two arcs: a bulge ends at 360°
    path(std::move(style), {{at(from), bulge}, {at(from + half), bulge}, {at(to), 0.0}});
}

void Drawing::rectangle(std::string style, const Vector2d& low, const Vector2d& high) {
    polyline(std::move(style), std::array<Vector2d, 4>{low, {high.x(), low.y()}, high, {low.x(), high.y()}},
             true);
}

void Drawing::add(const Drawing& other) {
    elements.insert(elements.end(), other.elements.begin(), other.elements.end());
}

void Drawing::scale(double factor) {
    for (DrawnElement& element : elements) {
        if (auto* circle = std::get_if<DrawnCircle>(&element))
            circle->center *= factor, circle->radius *= factor;
        if (auto* text = std::get_if<DrawnText>(&element)) text->at *= factor, text->height *= factor;
        if (auto* path = std::get_if<DrawnPath>(&element))
            for (ArcVertex& vertex : path->vertices) vertex.position *= factor;
    }
}

void Drawing::move(const Vector2d& offset) {
    for (DrawnElement& element : elements) {
        if (auto* circle = std::get_if<DrawnCircle>(&element)) circle->center += offset;
        if (auto* text = std::get_if<DrawnText>(&element)) text->at += offset;
        if (auto* path = std::get_if<DrawnPath>(&element))
            for (ArcVertex& vertex : path->vertices) vertex.position += offset;
    }
}

DrawingBox Drawing::box() const {
    DrawingBox box;
    for (const DrawnElement& element : elements) {
        if (const auto* circle = std::get_if<DrawnCircle>(&element)) box.add(circle->center, circle->radius);
        if (const auto* path = std::get_if<DrawnPath>(&element))
            for (const ArcVertex& vertex : path->vertices) box.add(vertex.position);
    }
    return box;
}

bool Drawing::has(std::string_view style) const {
    return std::ranges::any_of(elements,
                               [&](const DrawnElement& element) { return style_of(element) == style; });
}

const std::string& style_of(const DrawnElement& element) {
    return std::visit([](const auto& one) -> const std::string& { return one.style; }, element);
}

double DrawnDimension::measured() const {
    switch (kind) {
        case Kind::linear:
            return std::abs((second - first).dot(Vector2d(std::cos(direction), std::sin(direction))));
        case Kind::diameter:
            return 2.0 * (second - first).norm();
        case Kind::radius:
            return (second - first).norm();
        case Kind::angle:
            break;
    }
    return std::abs(sweep);
}

std::string css_of(std::span<const PictureStyle> styles) {
    std::string rules;
    for (const PictureStyle& style : styles) rules += fmt::format(".{}{{{}}}", style.name, style.css);
    return rules + fmt::format(".{}{{fill:none}}", open_class);
}

void draw(SvgCanvas& canvas, const Drawing& drawing, const PicturePlace& place,
          std::span<const PictureStyle> styles) {
    for (const PictureStyle& style : styles)
        for (const DrawnElement& element : drawing.elements)
            if (style_of(element) == style.name) std::visit(SvgDrawer{canvas, place, style}, element);
}

}  // namespace camopt

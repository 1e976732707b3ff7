// SPDX-License-Identifier: MIT
#include "report/drawing/drawing.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr std::string_view open_class = "sector";

bool is_filled(const PictureStyle& style) {
    return std::string_view(style.css).starts_with("fill:#");
}

struct SvgDrawer {
    SvgCanvas& canvas;
    const PicturePlace& place;
    const PictureStyle& style;

    void operator()(const DrawnPath& path) const {
        std::string css_class = style.name;
        if (!path.closed && path.vertices.size() > 2 && is_filled(style))
            css_class.append(" ").append(open_class);
        canvas.path(svg_path(path.vertices, path.closed, place), css_class);
    }
    void operator()(const DrawnCircle& circle) const {
        const Vector2d middle = place(circle.center);
        canvas.circle(middle.x(), middle.y(), place.scale.x() * circle.radius, style.name);
    }
    void operator()(const DrawnText&) const {}  // labels of pictures are placed free of each other
};

}  // namespace

void Drawing::polyline(std::string style, std::span<const Vector2d> points, bool closed) {
    std::vector<ArcVertex> vertices;
    vertices.reserve(points.size());
    for (const Vector2d& point : points) vertices.push_back({point, 0.0});
    path(std::move(style), std::move(vertices), closed);
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

std::string svg_path(std::span<const ArcVertex> vertices, bool closed, const PicturePlace& place) {
    constexpr double straight = 1e-9;  // of a bulge: its arc leaves the chord by no more than that part of it
    const auto number = [&](double value) { return svg_number(value, place.decimals); };
    std::string data;
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count + (closed ? 1 : 0); ++i) {
        const Vector2d at = place(vertices[i % count].position);
        const double bulge = i == 0 ? 0.0 : vertices[i - 1].bulge;
        if (std::abs(bulge) > straight) {
            const double radius =
                place.scale.x() *
                bulge_arc(vertices[i - 1].position, vertices[i % count].position, bulge).radius;
            data += fmt::format("A{0} {0} 0 {1} {2} ", number(radius), std::abs(bulge) > 1.0 ? 1 : 0,
                                bulge > 0.0 ? 0 : 1);
        } else if (i == count) {
            break;
        } else {
            data += i == 0 ? "M" : "L";
        }
        data += number(at.x()) + " " + number(at.y());
    }
    return closed ? data + "Z" : data;
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

// SPDX-License-Identifier: MIT
#include "shop/sheet/sheet_painter.hpp"

#include <Eigen/Geometry>

namespace camopt {

namespace {

using Eigen::Vector2d;

// m on the paper.
constexpr double mark_arrow = 2.5e-3, mark_arrow_half = 0.45e-3, mark_overshoot = 1.2e-3, mark_gap = 0.6e-3,
                 mark_tail = 4.0e-3, words_above = 0.8e-3, words_beside = 1.2e-3, leader_shoulder = 3.0e-3;
const char* const dimension_layer = "DIMENSIONS";

Vector2d direction_of(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

Vector2d left_of(const Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

void add_mark_line(DimensionMarks& marks, const Vector2d& from, const Vector2d& to) {
    marks.lines.push_back(
        {dimension_layer, SheetPen::thin, {{from, 0.0}, {to, 0.0}}, false, SheetSpace::paper, false});
}

/// Its tip at the point, pointing along the direction.
void add_mark_arrow(DimensionMarks& marks, const Vector2d& tip, const Vector2d& direction) {
    const Vector2d back = tip - mark_arrow * direction, side = mark_arrow_half * left_of(direction);
    marks.arrows.push_back({tip, back + side, back - side});
}

void set_mark_text(DimensionMarks& marks, const Vector2d& at, const std::string& words, TextSide anchor,
                   double turn) {
    marks.text = {dimension_layer, at, dimension_text_height, words, anchor, turn};
}

/// Words are read from below and from the right.
double readable(double angle) {
    const double half = std::numbers::pi / 2.0;
    double turn = std::remainder(angle, 2.0 * std::numbers::pi);
    if (turn > half + 1e-9) turn -= 2.0 * half;
    if (turn <= -half + 1e-9) turn += 2.0 * half;
    return turn;
}

DimensionMarks linear_marks(const DrawnDimension& dimension, const SheetView& view) {
    DimensionMarks marks;
    const Vector2d along = direction_of(dimension.direction), across = left_of(along);
    Vector2d from = view.on_paper(dimension.first), to = view.on_paper(dimension.second);
    if ((to - from).dot(along) < 0.0) std::swap(from, to);
    const auto on_line = [&](const Vector2d& point) -> Vector2d {
        return point + across * across.dot(dimension.place - point);
    };
    const Vector2d left = on_line(from), right = on_line(to);
    for (const auto& [point, end] : {std::pair{from, left}, std::pair{to, right}}) {
        const Vector2d out = end - point;
        if (out.norm() < mark_gap) continue;
        const Vector2d way = out.normalized();
        add_mark_line(marks, point + mark_gap * way, end + mark_overshoot * way);
    }
    const std::string words = words_of(dimension);
    const double length = (right - left).norm(), width = widest_text(words, dimension_text_height),
                 turn = readable(dimension.direction);
    const bool arrows_fit = length > 2.5 * mark_arrow, words_fit = length > width + 1e-3;
    if (arrows_fit) {
        add_mark_line(marks, left, right);
        add_mark_arrow(marks, left, -along);
        add_mark_arrow(marks, right, along);
    } else {
        add_mark_line(marks, left - mark_tail * along, right + mark_tail * along);
        add_mark_arrow(marks, left, along);
        add_mark_arrow(marks, right, -along);
    }
    const Vector2d up = left_of(direction_of(turn));
    if (words_fit) {
        set_mark_text(marks, 0.5 * (left + right) + words_above * up, words, TextSide::middle, turn);
        return marks;
    }
    // Beside the line, at the end from which the words run on outwards.
    const bool forwards = direction_of(turn).dot(along) > 0.0;
    const Vector2d start = right + (arrows_fit ? 0.0 : mark_tail) * along;
    add_mark_line(marks, start, start + (width + 2.0 * words_beside) * along);
    set_mark_text(marks, start + words_beside * along + words_above * up, words,
                  forwards ? TextSide::start : TextSide::end, turn);
    return marks;
}

DimensionMarks leader_marks(const DrawnDimension& dimension, const SheetView& view) {
    DimensionMarks marks;
    const Vector2d tip = view.on_paper(dimension.second), center = view.on_paper(dimension.first);
    const bool to_right = dimension.place.x() >= tip.x();
    const std::string words = words_of(dimension);
    const double width = widest_text(words, dimension_text_height), side = to_right ? 1.0 : -1.0;
    const Vector2d elbow = dimension.place, end = elbow + side * Vector2d(leader_shoulder + width, 0.0);
    const Vector2d way = (elbow - tip).normalized();
    if (dimension.kind == DrawnDimension::Kind::radius) {
        add_mark_line(marks, center, tip);
        add_mark_arrow(marks, tip, (tip - center).normalized());
    } else {
        add_mark_arrow(marks, tip, -way);
    }
    add_mark_line(marks, tip, elbow);
    add_mark_line(marks, elbow, end);
    set_mark_text(marks, elbow + Vector2d(side * leader_shoulder, words_above), words,
                  to_right ? TextSide::start : TextSide::end, 0.0);
    return marks;
}

DimensionMarks angle_marks(const DrawnDimension& dimension, const SheetView& view) {
    DimensionMarks marks;
    const Vector2d center = view.on_paper(dimension.first);
    const double radius = (dimension.place - center).norm(), from = dimension.direction,
                 to = from + dimension.sweep, sign = dimension.sweep < 0.0 ? -1.0 : 1.0;
    Sheet arcs;
    arcs.arc(dimension_layer, SheetPen::thin,
             {dimension_layer, SheetPen::thin, center, radius, SheetSpace::paper}, from, to);
    marks.lines = std::move(arcs.paths);
    const double head = sign * 0.5 * mark_arrow / radius;  // the chord of a head leans by half its angle
    add_mark_arrow(marks, center + radius * direction_of(from), -sign * left_of(direction_of(from + head)));
    add_mark_arrow(marks, center + radius * direction_of(to), sign * left_of(direction_of(to - head)));
    const double middle = 0.5 * (from + to), turn = readable(middle - std::numbers::pi / 2.0);
    const bool outwards = left_of(direction_of(turn)).dot(direction_of(middle)) > 0.0;
    const double distance = outwards ? radius + words_above : radius - words_above;
    set_mark_text(marks, center + distance * direction_of(middle), words_of(dimension), TextSide::middle,
                  turn);
    return marks;
}

/// Words with some room around them, and points along all that is drawn with them.
struct PlacedWords {
    Vector2d corner, along;
    double width = 0.0, height = 0.0;
    std::vector<Vector2d> points = {};

    explicit PlacedWords(const DrawnText& text) : along(direction_of(text.turn)) {
        constexpr double room = 0.8e-3;
        const double own = widest_text(text.words, text.height);
        const double part = text.anchor == TextSide::start    ? 0.0
                            : text.anchor == TextSide::middle ? 0.5
                                                              : 1.0;
        const Vector2d up = left_of(along);
        corner = text.at - (room + part * own) * along - room * up;
        width = own + 2.0 * room;
        height = text.height + 2.0 * room;
        for (const double line : {0.0, 0.5, 1.0})
            add(corner + line * height * up, corner + line * height * up + width * along);
    }
    explicit PlacedWords(const DimensionMarks& marks) : PlacedWords(marks.text) {
        for (const SheetPath& line : marks.lines)
            for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i)
                add(line.vertices[i].position, line.vertices[i + 1].position, line.vertices[i].bulge);
    }
    void add(const Vector2d& from, const Vector2d& to, double bulge = 0.0) {
        constexpr int steps = 100;
        for (int k = 0; k <= steps; ++k) {
            const double part = static_cast<double>(k) / steps;
            if (bulge == 0.0) {
                points.emplace_back(from + part * (to - from));
                continue;
            }
            const BulgeArc arc = bulge_arc(from, to, bulge);
            points.emplace_back(arc.center +
                                arc.radius * direction_of(arc.from + part * (arc.to - arc.from)));
        }
    }
    [[nodiscard]] bool covers(const PlacedWords& other) const {
        return std::ranges::any_of(other.points, [&](const Vector2d& point) {
            const double across = along.dot(point - corner), up = left_of(along).dot(point - corner);
            return across >= 0.0 && across <= width && up >= 0.0 && up <= height;
        });
    }
};

/// The k-th place to try: further out, of a diameter to both sides of where it was.
DrawnDimension moved(DrawnDimension dimension, const SheetView& view, int k) {
    constexpr double step = 1.5e-3, turn = 7.0 * units::degree;
    const bool leads =
        dimension.kind == DrawnDimension::Kind::diameter || dimension.kind == DrawnDimension::Kind::radius;
    const Vector2d center = view.on_paper(dimension.first);
    Vector2d out = (dimension.place - (leads ? view.on_paper(dimension.second) : center)).normalized();
    if (dimension.kind == DrawnDimension::Kind::diameter) {
        const Eigen::Rotation2D<double> rotation((k % 2 == 0 ? -0.5 * k : 0.5 * (k + 1)) * turn);
        dimension.second = dimension.first + rotation * (dimension.second - dimension.first);
        dimension.place = center + rotation * (dimension.place - center);
        return dimension;
    }
    if (dimension.kind == DrawnDimension::Kind::linear) {
        const Vector2d across = left_of(direction_of(dimension.direction));
        out = across.dot(out) < 0.0 ? Vector2d(-across) : across;
    }
    dimension.place += k * step * out;
    return dimension;
}

}  // namespace

void separate_dimensions(Sheet& sheet) {
    constexpr int most_steps = 20;
    std::vector<PlacedWords> placed(sheet.texts.begin(), sheet.texts.end());
    for (DrawnDimension& dimension : sheet.dimensions) {
        dimension.lengths = sheet.lengths;
        for (int k = 0; k < most_steps; ++k) {
            const DrawnDimension tried = moved(dimension, sheet.view, k);
            const PlacedWords own(dimension_marks(tried, sheet.view));
            if (std::ranges::any_of(
                    placed, [&](const PlacedWords& other) { return own.covers(other) || other.covers(own); }))
                continue;
            dimension = tried;
            break;
        }
        placed.emplace_back(dimension_marks(dimension, sheet.view));
    }
}

void paint(const Sheet& sheet, SheetPainter& painter) {
    for (SheetPath path : sheet.paths) {
        if (path.space == SheetSpace::model)
            for (ArcVertex& vertex : path.vertices) vertex.position = sheet.view.on_paper(vertex.position);
        path.space = SheetSpace::paper;
        painter.path(path);
    }
    for (SheetCircle circle : sheet.circles) {
        if (circle.space == SheetSpace::model) {
            circle.center = sheet.view.on_paper(circle.center);
            circle.radius *= sheet.view.scale;
        }
        circle.space = SheetSpace::paper;
        painter.circle(circle);
    }
    std::vector<DrawnText> words;
    for (const DrawnDimension& dimension : sheet.dimensions) {
        const DimensionMarks marks = dimension_marks(dimension, sheet.view);
        for (const SheetPath& line : marks.lines) painter.path(line);
        for (const std::array<Vector2d, 3>& arrow : marks.arrows)
            painter.path({marks.text.style,
                          SheetPen::thin,
                          {{arrow[0], 0.0}, {arrow[1], 0.0}, {arrow[2], 0.0}},
                          true,
                          SheetSpace::paper,
                          true});
        words.push_back(marks.text);
    }
    for (const DrawnText& text : words) painter.text(text);
    for (const DrawnText& text : sheet.texts) painter.text(text);
}

DimensionMarks dimension_marks(const DrawnDimension& dimension, const SheetView& view) {
    switch (dimension.kind) {
        case DrawnDimension::Kind::linear:
            return linear_marks(dimension, view);
        case DrawnDimension::Kind::angle:
            return angle_marks(dimension, view);
        case DrawnDimension::Kind::diameter:
        case DrawnDimension::Kind::radius:
            break;
    }
    return leader_marks(dimension, view);
}

}  // namespace camopt

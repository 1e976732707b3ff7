// SPDX-License-Identifier: MIT
#include "shop/sheet/dimension_marks.hpp"

#include "core/text/printable.hpp"
#include "report/view/shown_units.hpp"

#include <Eigen/Geometry>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Kind = DrawnDimension::Kind;

// m on the paper.
constexpr double mark_text = 2.5e-3, mark_arrow = 2.5e-3, mark_arrow_half = 0.45e-3, mark_overshoot = 1.2e-3,
                 mark_gap = 0.6e-3, mark_tail = 4.0e-3, words_above = 0.8e-3, words_beside = 1.2e-3,
                 leader_shoulder = 3.0e-3, beside_words = 1e-3;

Vector2d direction_of(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

Vector2d left_of(const Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

/// Words are read from below and from the right.
double readable(double angle) {
    const double half = std::numbers::pi / 2.0;
    double turn = std::remainder(angle, 2.0 * std::numbers::pi);
    if (turn > half + 1e-9) turn -= 2.0 * half;
    if (turn <= -half + 1e-9) turn += 2.0 * half;
    return turn;
}

class MarkMaker {
 public:
    MarkMaker(const DrawnDimension& dimension, double paper)
        : dimension_(dimension),
          paper_(paper),
          words_(words_of(dimension)),
          width_(widest_text(words_, paper * mark_text)) {}

    [[nodiscard]] Drawing made() {
        switch (dimension_.kind) {
            case Kind::linear:
                add_linear();
                break;
            case Kind::angle:
                add_angle();
                break;
            case Kind::diameter:
            case Kind::radius:
                add_leader();
                break;
        }
        marks_.text(text_);
        return std::move(marks_);
    }

 private:
    const DrawnDimension& dimension_;
    double paper_;
    std::string words_;
    double width_;
    Drawing marks_;
    DrawnText text_;

    void line(const Vector2d& from, const Vector2d& to) { marks_.line("dimension", from, to); }
    /// Its tip at the point, pointing along the direction.
    void arrow(const Vector2d& tip, const Vector2d& direction) {
        const Vector2d back = tip - paper_ * mark_arrow * direction,
                       side = paper_ * mark_arrow_half * left_of(direction);
        marks_.polyline("arrow", std::array<Vector2d, 3>{tip, back + side, back - side}, true);
    }
    void set_text(const Vector2d& at, TextSide anchor, double turn) {
        text_ = {"measure", at, paper_ * mark_text, words_, anchor, turn};
    }

    void add_linear() {
        const Vector2d along = direction_of(dimension_.direction), across = left_of(along);
        Vector2d from = dimension_.first, to = dimension_.second;
        if ((to - from).dot(along) < 0.0) std::swap(from, to);
        const auto on_line = [&](const Vector2d& point) -> Vector2d {
            return point + across * across.dot(dimension_.place - point);
        };
        const Vector2d left = on_line(from), right = on_line(to);
        for (const auto& [point, end] : {std::pair{from, left}, std::pair{to, right}}) {
            const Vector2d out = end - point;
            if (out.norm() < paper_ * mark_gap) continue;
            const Vector2d way = paper_ * out.normalized();
            line(point + mark_gap * way, end + mark_overshoot * way);
        }
        const double length = (right - left).norm(), turn = readable(dimension_.direction);
        const bool arrows_fit = length > 2.5 * paper_ * mark_arrow,
                   words_fit = length > width_ + paper_ * beside_words;
        if (arrows_fit) {
            line(left, right);
            arrow(left, -along);
            arrow(right, along);
        } else {
            line(left - paper_ * mark_tail * along, right + paper_ * mark_tail * along);
            arrow(left, along);
            arrow(right, -along);
        }
        const Vector2d up = paper_ * words_above * left_of(direction_of(turn));
        if (words_fit) return set_text(0.5 * (left + right) + up, TextSide::middle, turn);
        // Beside the line, at the end from which the words run on outwards.
        const bool forwards = direction_of(turn).dot(along) > 0.0;
        const Vector2d start = right + (arrows_fit ? 0.0 : paper_ * mark_tail) * along;
        line(start, start + (width_ + 2.0 * paper_ * words_beside) * along);
        set_text(start + paper_ * words_beside * along + up, forwards ? TextSide::start : TextSide::end,
                 turn);
    }

    void add_leader() {
        const Vector2d &tip = dimension_.second, &center = dimension_.first, &elbow = dimension_.place;
        const bool to_right = elbow.x() >= tip.x();
        const double side = to_right ? 1.0 : -1.0;
        if (dimension_.kind == Kind::radius) {
            line(center, tip);
            arrow(tip, (tip - center).normalized());
        } else {
            arrow(tip, (tip - elbow).normalized());
        }
        line(tip, elbow);
        line(elbow, elbow + side * Vector2d(paper_ * leader_shoulder + width_, 0.0));
        set_text(elbow + paper_ * Vector2d(side * leader_shoulder, words_above),
                 to_right ? TextSide::start : TextSide::end, 0.0);
    }

    void add_angle() {
        const Vector2d& center = dimension_.first;
        const double radius = (dimension_.place - center).norm(), from = dimension_.direction,
                     to = from + dimension_.sweep, sign = dimension_.sweep < 0.0 ? -1.0 : 1.0;
        marks_.arc("dimension", center, radius, from, to);
        // The chord of a head leans by half its angle.
        const double head = sign * 0.5 * paper_ * mark_arrow / radius;
        arrow(center + radius * direction_of(from), -sign * left_of(direction_of(from + head)));
        arrow(center + radius * direction_of(to), sign * left_of(direction_of(to - head)));
        const double middle = 0.5 * (from + to), turn = readable(middle - std::numbers::pi / 2.0);
        const bool outwards = left_of(direction_of(turn)).dot(direction_of(middle)) > 0.0;
        const double distance = radius + (outwards ? 1.0 : -1.0) * paper_ * words_above;
        set_text(center + distance * direction_of(middle), TextSide::middle, turn);
    }
};

/// Words with some room around them, and points along all that is drawn with them.
struct PlacedWords {
    Vector2d corner = {0.0, 0.0}, along = {1.0, 0.0};
    double width = 0.0, height = 0.0;
    std::vector<Vector2d> points = {};

    /// A text, lines with it.
    PlacedWords(std::span<const DrawnElement> elements, double paper) {
        for (const DrawnElement& element : elements) {
            if (const auto* text = std::get_if<DrawnText>(&element)) add(*text, paper);
            if (const auto* path = std::get_if<DrawnPath>(&element); path != nullptr && !path->closed)
                for (std::size_t i = 0; i + 1 < path->vertices.size(); ++i)
                    add(path->vertices[i].position, path->vertices[i + 1].position, path->vertices[i].bulge);
        }
    }
    void add(const DrawnText& text, double paper) {
        const double room = 0.8e-3 * paper, own = widest_text(text.words, text.height);
        along = direction_of(text.turn);
        const Vector2d up = left_of(along);
        corner = text.at - (room + share_before(text.anchor) * own) * along - room * up;
        width = own + 2.0 * room;
        height = text.height + 2.0 * room;
        for (const double line : {0.0, 0.5, 1.0})
            add(corner + line * height * up, corner + line * height * up + width * along);
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
DrawnDimension moved(DrawnDimension dimension, double paper, int k) {
    constexpr double step = 1.5e-3, turn = 7.0 * units::degree;
    const Vector2d center = dimension.first;
    Vector2d out =
        (dimension.place - (dimension.kind == Kind::radius ? dimension.second : center)).normalized();
    if (dimension.kind == Kind::diameter) {
        const Eigen::Rotation2D<double> rotation((k % 2 == 0 ? -0.5 * k : 0.5 * (k + 1)) * turn);
        dimension.second = center + rotation * (dimension.second - center);
        dimension.place = center + rotation * (dimension.place - center);
        return dimension;
    }
    if (dimension.kind == Kind::linear) {
        const Vector2d across = left_of(direction_of(dimension.direction));
        out = across.dot(out) < 0.0 ? Vector2d(-across) : across;
    }
    dimension.place += k * step * paper * out;
    return dimension;
}

}  // namespace

std::string words_of(const DrawnDimension& dimension) {
    if (dimension.kind == Kind::angle) return svg_number(degrees_shown.of(dimension.measured()), 2) + "°";
    const bool diameter =
        dimension.kind == Kind::diameter || (dimension.across && dimension.kind == Kind::linear);
    return (diameter                         ? "⌀"
            : dimension.kind == Kind::radius ? "R"
                                             : "") +
           drawn_length(dimension.measured(), dimension.lengths) +
           (dimension.tolerance.empty() ? "" : " " + printable(dimension.tolerance));
}

Drawing dimension_marks(const DrawnDimension& dimension, double paper) {
    return MarkMaker(dimension, paper).made();
}

Drawing drawing_with_marks(const Sheet& sheet) {
    Drawing all = sheet.drawing;
    for (const DrawnDimension& dimension : sheet.dimensions)
        all.add(dimension_marks(dimension, sheet.paper(1.0)));
    return all;
}

void separate_dimensions(Sheet& sheet) {
    constexpr int most_steps = 20;
    const double paper = sheet.paper(1.0);
    std::vector<PlacedWords> placed;
    for (const DrawnElement& element : sheet.drawing.elements)
        if (std::holds_alternative<DrawnText>(element)) placed.emplace_back(std::span(&element, 1), paper);
    const auto words_and_lines = [paper](const DrawnDimension& dimension) {
        return PlacedWords(dimension_marks(dimension, paper).elements, paper);
    };
    for (DrawnDimension& dimension : sheet.dimensions) {
        dimension.lengths = sheet.lengths;
        for (int k = 0; k < most_steps; ++k) {
            const DrawnDimension tried = moved(dimension, paper, k);
            const PlacedWords own = words_and_lines(tried);
            if (std::ranges::any_of(
                    placed, [&](const PlacedWords& other) { return own.covers(other) || other.covers(own); }))
                continue;
            dimension = tried;
            break;
        }
        placed.push_back(words_and_lines(dimension));
    }
}

}  // namespace camopt

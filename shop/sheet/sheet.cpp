// SPDX-License-Identifier: MIT
#include "shop/sheet/sheet.hpp"

#include "core/text/printable.hpp"
#include "report/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

using Eigen::Vector2d;

std::string words_of(const DrawnDimension& dimension) {
    using Kind = DrawnDimension::Kind;
    if (dimension.kind == Kind::angle) return svg_number(degrees_shown.of(dimension.measured()), 2) + "°";
    const bool diameter =
        dimension.kind == Kind::diameter || (dimension.across && dimension.kind == Kind::linear);
    return (diameter                         ? "⌀"
            : dimension.kind == Kind::radius ? "R"
                                             : "") +
           drawn_length(dimension.measured(), dimension.lengths) +
           (dimension.tolerance.empty() ? "" : " " + printable(dimension.tolerance));
}

void Sheet::line(const std::string& layer, SheetPen pen, const Vector2d& from, const Vector2d& to,
                 SheetSpace space) {
    paths.push_back({layer, pen, {{from, 0.0}, {to, 0.0}}, false, space, false});
}

void Sheet::rectangle(const std::string& layer, SheetPen pen, const Vector2d& low, const Vector2d& high,
                      SheetSpace space) {
    const std::vector<ArcVertex> corners = {
        {low, 0.0}, {{high.x(), low.y()}, 0.0}, {high, 0.0}, {{low.x(), high.y()}, 0.0}};
    paths.push_back({layer, pen, corners, true, space, false});
}

void Sheet::arc(const std::string& layer, SheetPen pen, const SheetCircle& circle, double from, double to) {
    const auto at = [&](double angle) -> Vector2d {
        return circle.center + circle.radius * Vector2d(std::cos(angle), std::sin(angle));
    };
    const double half = 0.5 * (to - from), bulge = std::tan(0.25 * half);  // two arcs: a bulge ends at 360°
    paths.push_back({layer,
                     pen,
                     {{at(from), bulge}, {at(from + half), bulge}, {at(to), 0.0}},
                     false,
                     circle.space,
                     false});
}

double widest_text(std::string_view words, double height) {
    constexpr double capital = 0.729, narrow = 0.32, letter = 0.65, wide = 0.99;  // of the font's size
    double width = 0.0;
    for (const char c : words) {
        if ((static_cast<unsigned char>(c) & 0xc0U) == 0x80U) continue;  // inside a letter of UTF-8
        const std::string_view small = " ,.:;|!'()ijlI", large = "mwMWOQ%@";
        width += small.find(c) != std::string_view::npos     ? (c == '(' || c == ')' ? 0.4 : narrow)
                 : large.find(c) != std::string_view::npos   ? wide
                 : (c >= 'A' && c <= 'Z') || (c & 0x80) != 0 ? 0.84
                                                             : letter;
    }
    return width * height / capital;
}

int drawn_decimals(LengthUnit unit) {
    return unit == LengthUnit::inch ? 4 : 3;
}

std::string drawn_length(double metres, LengthUnit unit) {
    return svg_number(metres / metres_of(unit), drawn_decimals(unit));
}

StandardScale standard_scale(const Vector2d& size, const Vector2d& room) {
    // 50:1 … 1:10000, in steps 1, 2, 5.
    constexpr std::array<int, 15> steps = {50, 20, 10, 5, 2, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
    constexpr std::size_t whole = 5;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double value = i <= whole ? steps[i] : 1.0 / steps[i];
        if (value * size.x() <= room.x() && value * size.y() <= room.y())
            return {value, i <= whole ? fmt::format("{}:1", steps[i]) : fmt::format("1:{}", steps[i])};
    }
    throw InputError(fmt::format("drawing: found a part of {} mm by {} mm; allowed: at most {} m on a sheet",
                                 drawn_length(size.x()), drawn_length(size.y()),
                                 steps.back() * room.minCoeff()));
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "shop/sheet/sheet.hpp"

#include "report/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

using Eigen::Vector2d;

void Sheet::add_on_paper(Drawing drawn) {
    drawn.move(-origin);
    drawn.scale(1.0 / scale);
    drawing.add(drawn);
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

// SPDX-License-Identifier: MIT
// Lenze Cam Loader and the like: a line a point, "x y // comment", x ascending.
//
// A third column would be the torque feed-forward in N m at the motor, which a cam alone does not know: it is
// left out. Comments stand behind points only, so the header does too. Straight lines are assumed between the
// points.
#include "core/errors.hpp"
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

#include <set>

namespace camopt {

namespace {

constexpr int lenze_points = 721;  // every half degree

PlcTable lenze_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat&) {
    std::set<double> places;
    const int last = options.points.value_or(lenze_points) - 1;
    for (int i = 0; i < last; ++i) places.insert(curve.end() * i / last);
    places.insert(curve.end());
    std::vector<EndState> knots;
    for (const double theta : places) {
        const Side side = theta >= curve.end() ? Side::left : Side::right;
        knots.push_back({theta, curve.at(theta, side)[0], 0.0, 0.0});
    }
    PlcTable table;
    table.pieces = lines_between(knots);
    return table;
}

std::string lenze_text(const PlcTable& table) {
    std::string text;
    std::size_t line = 0;
    for (const EndState& knot : knots_of(table.pieces)) {
        text += fmt::format("{} {}", lreal_text(knot.theta), lreal_text(knot.s));
        text += line < table.header.size() ? " // " + table.header[line] + "\n" : "\n";
        ++line;
    }
    return text;
}

std::vector<CamPiece> lenze_pieces(std::string_view text, const PlcUnits&) {
    std::vector<EndState> knots;
    for (const std::string& line : lines_of(text)) {
        const std::vector<std::string> point = lines_of(line.substr(0, line.find("//")));
        if (point.empty()) continue;
        const std::vector<double> numbers = numbers_between(point.front(), ' ', 2);
        knots.push_back({numbers[0], numbers[1], 0.0, 0.0});
    }
    return lines_between(knots);
}

}  // namespace

PlcFormat lenze_format() {
    PlcFormat format;
    format.key = "lenze";
    format.file = "lenze.txt";
    format.controller = "Lenze Cam Loader, motion profile";
    format.rule = "straight lines between the points (assumed)";
    format.numbers = "decimal text";
    format.degree = 1;
    format.element = "points";
    format.straight_lines = true;
    format.prepare = lenze_table;
    format.write = lenze_text;
    format.read = lenze_pieces;
    return format;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Any controller: a CSV file with a row a piece: where it begins and ends, the motion at its begin, and the
// coefficients of its polynomial.
//
// from_deg, to_deg, s, v, a, j (at from_deg; by the degree), c0 … c5: s = Σ c_k (θ − from_deg)^k. Lines that
// begin with # are comments.
#include "shop/plc/plc_format.hpp"
#include "shop/plc/structured_text.hpp"

#include <fmt/format.h>

#include <set>

namespace camopt {

namespace {

constexpr std::size_t csv_coefficients = 6, csv_first_coefficient = 6;
constexpr const char* csv_columns = "from_deg,to_deg,s,v,a,j,c0,c1,c2,c3,c4,c5";

std::string coefficient_csv_text(const PlcTable& table) {
    std::string text;
    for (const std::string& line : table.header) text += "# " + line + "\n";
    text += fmt::format("{}\n", csv_columns);
    for (const CamPiece& piece : table.pieces) {
        text += lreal_text(piece.begin) + "," + lreal_text(piece.end);
        for (int order = 0; order < 4; ++order) text += "," + lreal_text(value_of(piece, piece.begin, order));
        for (std::size_t k = 0; k < csv_coefficients; ++k)
            text += "," + lreal_text(k < piece.coefficients.size() ? piece.coefficients[k] : 0.0);
        text += "\n";
    }
    return text;
}

std::vector<CamPiece> coefficient_csv_pieces(std::string_view text, const PlcUnits&) {
    std::vector<CamPiece> pieces;
    bool headed = false;
    for (const std::string& line : lines_of(text)) {
        if (line.starts_with("#")) continue;
        if (!headed) {
            if (line != csv_columns)
                throw InputError(fmt::format("csv: found the columns {}; allowed: {}", line, csv_columns));
            headed = true;
            continue;
        }
        const std::vector<double> cells =
            numbers_between(line, ',', csv_first_coefficient + csv_coefficients);
        pieces.push_back({cells[0], cells[1], {cells.begin() + csv_first_coefficient, cells.end()}});
        for (int order = 0; order < 4; ++order) {
            const double said = cells[static_cast<std::size_t>(order) + 2];
            if (said != value_of(pieces.back(), pieces.back().begin, order))
                throw InputError(
                    fmt::format("csv: the row from {} deg contradicts its coefficients: {}", cells[0], said));
        }
    }
    if (pieces.empty()) throw InputError("csv: found no row");
    return pieces;
}

// Lenze Cam Loader and the like: a line a point, "x y // comment", x ascending.
//
// A third column would be the torque feed-forward in N m at the motor, which a cam alone does not know: it is
// left out. Comments stand behind points only, so the header does too. Straight lines are assumed between the
// points.
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

PlcFormat coefficient_csv_format() {
    return {.key = "csv",
            .file = "plc.csv",
            .controller = "any controller, polynomial coefficients",
            .rule = "a polynomial of degree 5 in each row",
            .numbers = "decimal text of float64",
            .counted = PlcCount::pieces,
            .element = "rows",
            .prepare = fitted_table,
            .write = coefficient_csv_text,
            .read = coefficient_csv_pieces};
}

PlcFormat lenze_format() {
    return {.key = "lenze",
            .file = "lenze.txt",
            .controller = "Lenze Cam Loader, motion profile",
            .rule = "straight lines between the points (assumed)",
            .numbers = "decimal text",
            .degree = 1,
            .element = "points",
            .straight_lines = true,
            .prepare = lenze_table,
            .write = lenze_text,
            .read = lenze_pieces};
}

}  // namespace camopt

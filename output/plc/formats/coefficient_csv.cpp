// SPDX-License-Identifier: MIT
// Any controller: a CSV file with a row a piece: where it begins and ends, the motion at its begin, and the
// coefficients of its polynomial.
//
// from_deg, to_deg, s, v, a, j (at from_deg; by the degree), c0 … c5: s = Σ c_k (θ − from_deg)^k. Lines that
// begin with # are comments.
#include "core/errors.hpp"
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

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

}  // namespace

PlcFormat coefficient_csv_format() {
    PlcFormat format;
    format.key = "csv";
    format.file = "plc.csv";
    format.controller = "any controller, polynomial coefficients";
    format.rule = "a polynomial of degree 5 in each row";
    format.numbers = "decimal text of float64";
    format.counted = PlcCount::pieces;
    format.element = "rows";
    format.prepare = fitted_table;
    format.write = coefficient_csv_text;
    format.read = coefficient_csv_pieces;
    return format;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Rockwell Logix: an array of CAM_PROFILE_EXTENDED as MCCP would leave it. LREAL, cubics.
//
//     slave = C0 + C1 t + C2 t² + C3 t³,  t = master − Master of the element
//
// The last element is the end point alone.
#include "core/errors.hpp"
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

constexpr std::array<const char*, 4> rockwell_fields = {"C0", "C1", "C2", "C3"};

void append_rockwell_element(std::string& text, std::size_t index, const CamPiece& piece) {
    text += fmt::format(
        "Profile[{0}].Status := 2; Profile[{0}].SegmentType := 1; Profile[{0}].Master := {1}; "
        "Profile[{0}].Slave "
        ":= {2};\n   ",
        index, lreal_text(piece.begin), lreal_text(piece.coefficients.front()));
    for (std::size_t k = 0; k < rockwell_fields.size(); ++k)
        text += fmt::format(" Profile[{}].{} := {};", index, rockwell_fields[k],
                            lreal_text(k < piece.coefficients.size() ? piece.coefficients[k] : 0.0));
    text += "\n";
}

std::string rockwell_text(const PlcTable& table) {
    std::string text = comment_lines(table.header);
    text += fmt::format("// Tag: Profile, CAM_PROFILE_EXTENDED[{}]\n\n", table.pieces.size() + 1);
    for (std::size_t i = 0; i < table.pieces.size(); ++i) append_rockwell_element(text, i, table.pieces[i]);
    const EndState end = state_at_end(table.pieces.back());
    append_rockwell_element(text, table.pieces.size(), {end.theta, end.theta, {end.s}});
    return text;
}

std::vector<CamPiece> rockwell_pieces(std::string_view text, const PlcUnits&) {
    const StElements read = read_assignments(text);
    const int count = static_cast<int>(read.elements.size());
    std::vector<CamPiece> pieces;
    for (int i = 0; i + 1 < count; ++i) {
        CamPiece piece{read.number(i, "Master"), read.number(i + 1, "Master"), {}};
        for (const char* const field : rockwell_fields) piece.coefficients.push_back(read.number(i, field));
        if (read.number(i, "Slave") != piece.coefficients.front())
            throw InputError(fmt::format("rockwell: element {} has another Slave than C0", i));
        pieces.push_back(piece);
    }
    if (pieces.empty()) throw InputError("rockwell: found fewer than two elements");
    constexpr double same_end = 1e-6;  // of the slave position: the end point is but a mark
    const double end = value_of(pieces.back(), pieces.back().end);
    for (const char* const field : {"Slave", "C0"}) {
        const double mark = read.number(count - 1, field);
        if (std::abs(end - mark) > same_end * std::max(1.0, std::abs(mark)))
            throw InputError(fmt::format("rockwell: the last cubic ends at {}, the last element has {} {}",
                                         end, field, mark));
    }
    return pieces;
}

}  // namespace

PlcFormat rockwell_format() {
    PlcFormat format;
    format.key = "rockwell";
    format.file = "rockwell.st";
    format.controller = "Rockwell Logix, CAM_PROFILE_EXTENDED";
    format.rule = "a cubic from each element to the next";
    format.numbers = "LREAL (float64)";
    format.degree = 3;
    format.element = "elements";
    format.prepare = fitted_table;
    format.write = rockwell_text;
    format.read = rockwell_pieces;
    return format;
}

}  // namespace camopt

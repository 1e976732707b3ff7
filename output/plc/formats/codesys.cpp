// SPDX-License-Identifier: MIT
// CODESYS SoftMotion: an array of SMC_CAMXYVA behind a MC_CAM_REF, and the same points as an ASCII table.
//
// dX, dY: master, slave; dV = dY/dX, dA = d²Y/dX² at master speed 1; a quintic between two points.
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::string codesys_text(const PlcTable& table) {
    const std::vector<EndState> knots = knots_of(table.pieces);
    std::string text = comment_lines(table.header);
    text += fmt::format(
        "PROGRAM CamTable\nVAR\n    Points : ARRAY[0..{}] OF SMC_CAMXYVA;\n    Cam : "
        "MC_CAM_REF;\nEND_VAR\n\n",
        knots.size() - 1);
    for (std::size_t i = 0; i < knots.size(); ++i)
        text += fmt::format(
            "Points[{0}].dX := {1}; Points[{0}].dY := {2}; Points[{0}].dV := {3}; Points[{0}].dA := "
            "{4};\n",
            i, lreal_text(knots[i].theta), lreal_text(knots[i].s), lreal_text(knots[i].v),
            lreal_text(knots[i].a));
    text += fmt::format(
        "\nCam.byType := SMC_CAM_TYPE.XYVA;\nCam.xStart := {};\nCam.xEnd := {};\nCam.nElements := {};\n"
        "Cam.pce := ADR(Points[0]);\n",
        lreal_text(knots.front().theta), lreal_text(knots.back().theta), knots.size());
    return text;
}

std::vector<CamPiece> codesys_pieces(std::string_view text, const PlcUnits&) {
    const StElements read = read_assignments(text);
    std::vector<EndState> knots;
    const int count = static_cast<int>(read.number("Cam.nElements"));
    for (int i = 0; i < count; ++i)
        knots.push_back(
            {read.number(i, "dX"), read.number(i, "dY"), read.number(i, "dV"), read.number(i, "dA")});
    return quintics_between(knots);
}

std::string codesys_ascii(const PlcTable& table) {
    std::string text;
    for (const EndState& knot : knots_of(table.pieces))
        text += fmt::format("{};{};{};{}\n", lreal_text(knot.theta), lreal_text(knot.s), lreal_text(knot.v),
                            lreal_text(knot.a));
    return text;
}

std::vector<CamPiece> codesys_ascii_pieces(std::string_view text, const PlcUnits&) {
    std::vector<EndState> knots;
    for (const std::string& line : lines_of(text)) {
        const std::vector<double> cells = numbers_between(line, ';', 4);
        knots.push_back({cells[0], cells[1], cells[2], cells[3]});
    }
    return quintics_between(knots);
}

}  // namespace

PlcFormat codesys_format() {
    PlcFormat format;
    format.key = "codesys";
    format.file = "codesys.st";
    format.controller = "CODESYS SoftMotion, MC_CAM_REF of type XYVA";
    format.rule = "a quintic between two points";
    format.numbers = "LREAL (float64)";
    format.element = "points";
    format.limit = 128;
    format.limit_words = "a cam read from a file";
    format.limit_note = "library parameter gc_SMC_FILE_MAXCAMEL";
    format.shared = 2;
    format.text_file = "codesys.txt";
    format.prepare = fitted_table;
    format.write = codesys_text;
    format.read = codesys_pieces;
    format.write_text = codesys_ascii;
    format.read_text = codesys_ascii_pieces;
    return format;
}

}  // namespace camopt

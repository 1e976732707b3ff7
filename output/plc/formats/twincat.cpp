// SPDX-License-Identifier: MIT
// Beckhoff TwinCAT 3 (TF5050): an array of MC_MotionFunctionPoint behind a MC_CAM_REF of type motion
// function.
//
// FunctionType rules the stretch that begins at a point; POLYNOM5_MM takes s, s', s'' of both ends.
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::string twincat_text(const PlcTable& table) {
    const std::vector<EndState> knots = knots_of(table.pieces);
    std::string text = comment_lines(table.header);
    text += fmt::format(
        "PROGRAM CamTable\nVAR\n    Points : ARRAY[1..{}] OF MC_MotionFunctionPoint;\n    Cam : "
        "MC_CAM_REF;\nEND_VAR\n\n",
        knots.size());
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const bool last = i + 1 == knots.size();
        const double jerk = last ? value_of(table.pieces.back(), table.pieces.back().end, 3)
                                 : value_of(table.pieces[i], table.pieces[i].begin, 3);
        text += fmt::format(
            "Points[{0}].PointIndex := {0}; Points[{0}].FunctionType := MOTIONFUNCTYPE_POLYNOM5_MM; "
            "Points[{0}].PointType := MOTIONPOINTTYPE_MOTION; Points[{0}].RelIndexNextPoint := {1};\n"
            "    Points[{0}].MasterPos := {2}; Points[{0}].SlavePos := {3}; Points[{0}].SlaveVelo := {4}; "
            "Points[{0}].SlaveAcc := {5}; Points[{0}].SlaveJerk := {6};\n",
            i + 1, last ? 0 : 1, lreal_text(knots[i].theta), lreal_text(knots[i].s), lreal_text(knots[i].v),
            lreal_text(knots[i].a), lreal_text(jerk));
    }
    text += fmt::format(
        "\nCam.pArray := ADR(Points);\nCam.ArraySize := SIZEOF(Points);\nCam.TableType := "
        "MC_TABLETYPE_MOTIONFUNCTION;\nCam.NoOfRows := {};\nCam.NoOfColumns := 1;\n",
        knots.size());
    return text;
}

std::vector<CamPiece> twincat_pieces(std::string_view text, const PlcUnits&) {
    const StElements read = read_assignments(text);
    std::vector<EndState> knots;
    const int count = static_cast<int>(read.number("Cam.NoOfRows"));
    for (int i = 1; i <= count; ++i)
        knots.push_back({read.number(i, "MasterPos"), read.number(i, "SlavePos"), read.number(i, "SlaveVelo"),
                         read.number(i, "SlaveAcc")});
    return quintics_between(knots);
}

}  // namespace

PlcFormat twincat_format() {
    PlcFormat format;
    format.key = "twincat";
    format.file = "twincat.st";
    format.controller = "Beckhoff TwinCAT 3 NC Camming, MC_MotionFunctionPoint";
    format.rule = "POLYNOM5_MM, a quintic between two points";
    format.numbers = "LREAL (float64)";
    format.element = "points";
    format.shared = 2;
    format.prepare = fitted_table;
    format.write = twincat_text;
    format.read = twincat_pieces;
    return format;
}

}  // namespace camopt

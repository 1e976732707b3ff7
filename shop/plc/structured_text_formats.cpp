// SPDX-License-Identifier: MIT
// Beckhoff TwinCAT 3 (TF5050): an array of MC_MotionFunctionPoint behind a MC_CAM_REF of type motion
// function.
//
// FunctionType rules the stretch that begins at a point; POLYNOM5_MM takes s, s', s'' of both ends.
#include "shop/plc/plc_format.hpp"
#include "shop/plc/structured_text.hpp"

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

// CODESYS SoftMotion: an array of SMC_CAMXYVA behind a MC_CAM_REF, and the same points as an ASCII table.
//
// dX, dY: master, slave; dV = dY/dX, dA = d²Y/dX² at master speed 1; a quintic between two points.
std::string codesys_text(const PlcTable& table) {
    const std::vector<EndState> knots = knots_of(table.pieces);
    std::string text = comment_lines(table.header);
    text += fmt::format(
        "PROGRAM CamTable\nVAR\n    Points : ARRAY[0..{}] OF SMC_CAMXYVA;\n    Cam : "
        "MC_CAM_REF;\nEND_VAR\n\n",
        knots.size() - 1);
    for (std::size_t i = 0; i < knots.size(); ++i)
        text += fmt::format(
            "Points[{0}].dX := {1}; Points[{0}].dY := {2}; Points[{0}].dV := {3}; Points[{0}].dA := {4};\n",
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
    knots.reserve(static_cast<std::size_t>(std::max(0, count)));
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

// Rockwell Logix: an array of CAM_PROFILE_EXTENDED as MCCP would leave it. LREAL, cubics.
//
//     slave = C0 + C1 t + C2 t² + C3 t³,  t = master − Master of the element
//
// The last element is the end point alone.
constexpr std::array<const char*, 4> rockwell_fields = {"C0", "C1", "C2", "C3"};

void append_rockwell_element(std::string& text, std::size_t index, const CamPiece& piece) {
    text += fmt::format(
        "Profile[{0}].Status := 2; Profile[{0}].SegmentType := 1; Profile[{0}].Master := {1}; "
        "Profile[{0}].Slave := {2};\n   ",
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

// B&R ACP10: MC_CAMPROFILE_TYP. Polynomials of degree 6 with REAL coefficients, periods as whole units.
//
//     y = a + b t + c t² + d t³ + e t⁴ + f t⁵ + g t⁶,  t = master − end of the polynomial before
//
// x: where a polynomial ends. The drive checks that the first a is 0, that x ascends to MasterPeriod, and
// that y there is SlavePeriod: a warning above a tenth of a unit, refused from one unit on.
constexpr double br_master_unit = 1e-3;  // deg
constexpr std::array<const char*, 7> br_fields = {"a", "b", "c", "d", "e", "f", "g"};

/// The next master position that a REAL of thousandths of a degree holds.
double br_master(double theta) {
    return static_cast<double>(static_cast<float>(theta / br_master_unit)) * br_master_unit;
}

/// A thousandth of the slave's unit, or less where the travel of a turn is whole in it.
double br_slave_unit(double travel) {
    constexpr double whole = 1e-6;  // units
    for (const double unit : {1e-3, 1e-4, 1e-5}) {
        const double units = travel / unit;
        if (std::abs(units - std::round(units)) <= whole) return unit;
    }
    return 1e-3;
}

PlcTable br_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat& format) {
    PlcTable table;
    table.pieces = fitted_pieces(
        curve, {.degree = 5, .points = options.points, .most = format.most_pieces(), .master = br_master});
    table.units = {br_master_unit, br_slave_unit(curve.travel())};
    count_from_start(table);
    return table;
}

long whole_units(double value, double unit) {
    constexpr double most = 2147483647.0;  // DINT
    const double units = std::round(value / unit);
    if (std::abs(units) > most)
        throw InputError(fmt::format("br: a period of {} units; allowed: a DINT, up to 2147483647", units));
    return std::lround(units);
}

std::string br_text(const PlcTable& table) {
    std::string text = comment_lines(table.header);
    text += "// Declaration: Cam : MC_CAMPROFILE_TYP\n\n";
    const CamPiece& last = table.pieces.back();
    text += fmt::format("Cam.MasterPeriod := {};\nCam.SlavePeriod := {};\nCam.PolynomialNumber := {};\n",
                        whole_units(last.end, table.units.master),
                        whole_units(value_of(last, last.end), table.units.slave), table.pieces.size());
    int number = 0;
    for (const CamPiece& piece : table.pieces) {
        double scale = 1.0 / table.units.slave;
        for (std::size_t k = 0; k < br_fields.size(); ++k, scale *= table.units.master) {
            const double value = k < piece.coefficients.size() ? scale * piece.coefficients[k] : 0.0;
            text += fmt::format("Cam.PolynomialData[{}].{} := {}; ", number, br_fields[k],
                                real_text(static_cast<float>(value)));
        }
        text += fmt::format("Cam.PolynomialData[{0}].x := {1}; Cam.PolynomialData[{0}].Reserve := 0;\n",
                            number, real_text(static_cast<float>(piece.end / table.units.master)));
        ++number;
    }
    return text;
}

std::vector<CamPiece> br_pieces(std::string_view text, const PlcUnits& units) {
    const StElements read = read_assignments(text);
    const int count = static_cast<int>(read.number("Cam.PolynomialNumber"));
    std::vector<CamPiece> pieces;
    double begin = 0.0;
    for (int i = 0; i < count; ++i) {
        CamPiece piece;
        piece.begin = begin;
        piece.end = static_cast<double>(read.real(i, "x")) * units.master;
        double scale = units.slave;
        for (const char* const field : br_fields) {
            piece.coefficients.push_back(scale * static_cast<double>(read.real(i, field)));
            scale /= units.master;
        }
        begin = piece.end;
        pieces.push_back(piece);
    }
    if (pieces.empty()) throw InputError("br: found no polynomial");
    const double off =
        std::abs(value_of(pieces.back(), begin) / units.slave - read.number("Cam.SlavePeriod"));
    if (pieces.front().coefficients.front() != 0.0 || off >= 1.0)
        throw InputError(
            fmt::format("br: the first coefficient a is {} and the end is {} units off SlavePeriod; "
                        "the drive allows 0, and less than 1",
                        pieces.front().coefficients.front(), off));
    return pieces;
}

}  // namespace

PlcFormat twincat_format() {
    return {.key = "twincat",
            .file = "twincat.st",
            .controller = "Beckhoff TwinCAT 3 NC Camming, MC_MotionFunctionPoint",
            .rule = "POLYNOM5_MM, a quintic between two points",
            .numbers = "LREAL (float64)",
            .element = "points",
            .shared = 2,
            .prepare = fitted_table,
            .write = twincat_text,
            .read = twincat_pieces};
}

PlcFormat codesys_format() {
    return {.key = "codesys",
            .file = "codesys.st",
            .controller = "CODESYS SoftMotion, MC_CAM_REF of type XYVA",
            .rule = "a quintic between two points",
            .numbers = "LREAL (float64)",
            .element = "points",
            .limit = 128,
            .limit_words = "a cam read from a file",
            .limit_note = "library parameter gc_SMC_FILE_MAXCAMEL",
            .shared = 2,
            .text_file = "codesys.txt",
            .prepare = fitted_table,
            .write = codesys_text,
            .read = codesys_pieces,
            .write_text = codesys_ascii,
            .read_text = codesys_ascii_pieces};
}

PlcFormat rockwell_format() {
    return {.key = "rockwell",
            .file = "rockwell.st",
            .controller = "Rockwell Logix, CAM_PROFILE_EXTENDED",
            .rule = "a cubic from each element to the next",
            .numbers = "LREAL (float64)",
            .degree = 3,
            .element = "elements",
            .prepare = fitted_table,
            .write = rockwell_text,
            .read = rockwell_pieces};
}

PlcFormat br_format() {
    return {.key = "br",
            .file = "br.st",
            .controller = "B&R ACP10, MC_CAMPROFILE_TYP",
            .rule = "each a polynomial of degree 6 with its own begin as zero",
            .numbers = "REAL (float32) coefficients, DINT (int32) periods",
            .degree = 6,
            .counted = PlcCount::pieces,
            .element = "polynomials",
            .limit = 128,
            .limit_words = "an MC_CAMPROFILE_TYP",
            .limit_note = "64 in older libraries",
            .relative = true,
            .whole_periods = true,
            .prepare = br_table,
            .write = br_text,
            .read = br_pieces};
}

}  // namespace camopt

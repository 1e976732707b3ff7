// SPDX-License-Identifier: MIT
// B&R ACP10: MC_CAMPROFILE_TYP. Polynomials of degree 6 with REAL coefficients, periods as whole units.
//
//     y = a + b t + c t² + d t³ + e t⁴ + f t⁵ + g t⁶,  t = master − end of the polynomial before
//
// x: where a polynomial ends. The drive checks that the first a is 0, that x ascends to MasterPeriod, and
// that y there is SlavePeriod: a warning above a tenth of a unit, refused from one unit on.
#include "core/errors.hpp"
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace camopt {

namespace {

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

PlcFormat br_format() {
    PlcFormat format;
    format.key = "br";
    format.file = "br.st";
    format.controller = "B&R ACP10, MC_CAMPROFILE_TYP";
    format.rule = "each a polynomial of degree 6 with its own begin as zero";
    format.numbers = "REAL (float32) coefficients, DINT (int32) periods";
    format.degree = 6;
    format.counted = PlcCount::pieces;
    format.element = "polynomials";
    format.limit = 128;
    format.limit_words = "an MC_CAMPROFILE_TYP";
    format.limit_note = "64 in older libraries";
    format.relative = true;
    format.whole_periods = true;
    format.prepare = br_table;
    format.write = br_text;
    format.read = br_pieces;
    return format;
}

}  // namespace camopt

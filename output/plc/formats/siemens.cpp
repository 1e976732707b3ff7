// SPDX-License-Identifier: MIT
// Siemens SIMATIC S7-1500T, library LCamHdl: an array of LCamHdl_typeAdvancedElement for
// LCamHdl_CreateCamAdvanced.
//
// Each element has its own s, s', s'' at both ends. camProfileType 5: a polynomial of degree 5; 2: a dwell.
// The block refuses an element whose following value does not change (status 16#820A), so a rest is a dwell,
// and a piece that comes back to where it began is cut in two.
#include "core/errors.hpp"
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

constexpr int profile_dwell = 2, profile_poly5 = 5;

bool rests_throughout(const CamPiece& piece) {
    for (int k = 1; k <= piece.degree(); ++k)
        if (piece.coefficients[static_cast<std::size_t>(k)] != 0.0) return false;
    return true;
}

/// Pieces that end where they began, cut in two.
std::vector<CamPiece> siemens_elements(const MasterCurve& curve, const std::vector<CamPiece>& fitted) {
    constexpr double no_change = 1e-6;      // of the lift
    constexpr double off_the_middle = 0.4;  // a turning point may lie in the middle
    std::vector<CamPiece> pieces;
    for (const CamPiece& piece : fitted) {
        const bool returns =
            std::abs(state_at_end(piece).s - state_at_begin(piece).s) <= no_change * curve.lift();
        if (returns && !rests_throughout(piece))
            for (const CamPiece& half : split_at(piece, off_the_middle)) pieces.push_back(half);
        else
            pieces.push_back(piece);
    }
    return pieces;
}

PlcTable siemens_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat& format) {
    FitOptions fit{.points = options.points, .most = format.most_pieces()};
    PlcTable table;
    constexpr int trials = 3;  // cuts leave fewer for the fit, which may move them
    for (int trial = 0; trial < trials; ++trial) {
        table.pieces = siemens_elements(curve, fitted_pieces(curve, fit));
        const int over = static_cast<int>(table.pieces.size()) - format.most_pieces();
        if (over <= 0) break;
        fit.most -= over;
    }
    return table;
}

std::string siemens_text(const PlcTable& table) {
    std::string text = comment_lines(table.header);
    text += fmt::format(
        "// Declaration: camProfile : Array[1..{0}] of LCamHdl_typeAdvancedElement\n"
        "// Then LCamHdl_CreateCamAdvanced(numberOfElements := {0}, camProfile := camProfile, cam := "
        "...)\n\n",
        table.pieces.size());
    int number = 0;
    for (const CamPiece& piece : table.pieces) {
        ++number;
        const EndState from = state_at_begin(piece), to = state_at_end(piece);
        const auto field = [&](const char* name, const std::string& value) {
            text += fmt::format("camProfile[{}].{} := {};\n", number, name, value);
        };
        field("leadingValueStart", lreal_text(from.theta));
        field("leadingValueEnd", lreal_text(to.theta));
        field("followingValueStart", lreal_text(from.s));
        field("followingValueEnd", lreal_text(to.s));
        field("geoVeloStart", lreal_text(from.v));
        field("geoVeloEnd", lreal_text(to.v));
        field("geoAccelStart", lreal_text(from.a));
        field("geoAccelEnd", lreal_text(to.a));
        field("geoJerkStart", lreal_text(value_of(piece, piece.begin, 3)));
        field("geoJerkEnd", lreal_text(value_of(piece, piece.end, 3)));
        field("camProfileType", std::to_string(rests_throughout(piece) ? profile_dwell : profile_poly5));
    }
    return text;
}

std::vector<CamPiece> siemens_pieces(std::string_view text, const PlcUnits&) {
    const StElements read = read_assignments(text);
    std::vector<CamPiece> pieces;
    for (const auto& [i, ignored] : read.elements) {
        const EndState from{read.number(i, "leadingValueStart"), read.number(i, "followingValueStart"),
                            read.number(i, "geoVeloStart"), read.number(i, "geoAccelStart")};
        const EndState to{read.number(i, "leadingValueEnd"), read.number(i, "followingValueEnd"),
                          read.number(i, "geoVeloEnd"), read.number(i, "geoAccelEnd")};
        const double type = read.number(i, "camProfileType");
        const bool rests = from.s == to.s && from.v == 0.0 && to.v == 0.0;
        if (type == profile_dwell && rests)
            pieces.push_back({from.theta, to.theta, {from.s}});
        else if (type == profile_poly5 && from.s != to.s)
            pieces.push_back(quintic_between(from, to));
        else
            throw InputError(fmt::format(
                "siemens: element {} is of type {} from {} to {}; allowed: 2 without a change, or 5 with one",
                i, type, from.s, to.s));
    }
    if (pieces.empty()) throw InputError("siemens: found no element");
    return pieces;
}

}  // namespace

PlcFormat siemens_format() {
    PlcFormat format;
    format.key = "siemens";
    format.file = "siemens.scl";
    format.controller = "Siemens S7-1500T, LCamHdl_CreateCamAdvanced";
    format.rule = "each element a polynomial of degree 5 or a dwell";
    format.numbers = "LREAL (float64)";
    format.counted = PlcCount::pieces;
    format.element = "segments";
    format.limit = 50;
    format.limit_words = "a technology object TO_Cam";
    format.prepare = siemens_table;
    format.write = siemens_text;
    format.read = siemens_pieces;
    return format;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// Omron NJ, NX, NY: nodes for MC_GenerateCamTable, which makes a cam table of points from them.
//
// Between two nodes the curve "polynomic 3" with the connecting velocities v (slave units per second, where a
// turn takes CycleTime); with T = CycleTime · (phase of the node − phase before) / (phase of the last):
//
//     d = d₀ + v₀ T t + (3 (d₁ − d₀) − (2 v₀ + v₁) T) t² + ((v₀ + v₁) T − 2 (d₁ − d₀)) t³,  0 <= t <= 1
//
// A point stands every PhasePitch from the node before and at the node. Between points the table is straight,
// so it has no acceleration. Phase 0, displacement 0 is its first point.
#include "shop/plc/plc_format.hpp"
#include "shop/plc/structured_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr float omron_pitch = 0.1F;  // deg

double omron_cycle(const PlcTable& table) {
    constexpr double one_second = 1.0;
    return table.speed ? table.pieces.back().end / *table.speed : one_second;
}

double omron_phase(double theta) {
    return static_cast<double>(static_cast<float>(theta));
}

PlcTable omron_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat& format) {
    PlcTable table;
    table.pieces = fitted_pieces(
        curve, {.degree = 3, .points = options.points, .most = format.most_pieces(), .master = omron_phase});
    count_from_start(table);
    return table;
}

std::string omron_text(const PlcTable& table) {
    const std::vector<EndState> knots = knots_of(table.pieces);
    const double cycle = omron_cycle(table), per_second = knots.back().theta / cycle;
    std::string text = comment_lines(table.header);
    text += fmt::format(
        "// Declaration: CamProperty : _sMC_CAM_PROPERTY; CamNodes : ARRAY[0..{}] OF _sMC_CAM_NODE\n\n"
        "CamProperty.InitVel := {};\nCamProperty.CycleTime := {};\n",
        knots.size() - 2, real_text(static_cast<float>(knots.front().v * per_second)),
        real_text(static_cast<float>(cycle)));
    for (std::size_t i = 1; i < knots.size(); ++i)
        text += fmt::format(
            "CamNodes[{0}].Phase := {1}; CamNodes[{0}].Distance := {2}; CamNodes[{0}].Curve := "
            "_mcPolynomic3; CamNodes[{0}].ConnectingVelEnable := TRUE; CamNodes[{0}].ConnectingVel := {3}; "
            "CamNodes[{0}].PhasePitch := {4};\n",
            i - 1, real_text(static_cast<float>(knots[i].theta)), real_text(static_cast<float>(knots[i].s)),
            real_text(static_cast<float>(knots[i].v * per_second)), real_text(omron_pitch));
    return text;
}

/// The points the instruction makes of one node, without that of the node before.
void append_omron_points(std::vector<EndState>& points, const EndState& from, const EndState& to,
                         double duration, double pitch) {
    const double rise = to.s - from.s, v0 = from.v * duration, v1 = to.v * duration;
    constexpr double same_phase = 1e-3;  // of the pitch
    for (int k = 1; from.theta + k * pitch < to.theta - same_phase * pitch; ++k) {
        const double phase = from.theta + k * pitch, t = (phase - from.theta) / (to.theta - from.theta);
        const double s = from.s + t * (v0 + t * (3.0 * rise - 2.0 * v0 - v1 + t * (v0 + v1 - 2.0 * rise)));
        points.push_back({omron_phase(phase), static_cast<double>(static_cast<float>(s)), 0.0, 0.0});
    }
    points.push_back(to);
}

std::vector<CamPiece> omron_pieces(std::string_view text, const PlcUnits&) {
    const StElements read = read_assignments(text);
    const int count = static_cast<int>(read.elements.size());
    if (count == 0) throw InputError("omron: found no node");
    const double cycle = read.number("CamProperty.CycleTime");
    const double whole = static_cast<double>(read.real(count - 1, "Phase"));
    EndState from{0.0, 0.0, read.number("CamProperty.InitVel"), 0.0};
    std::vector<EndState> points = {from};
    for (int i = 0; i < count; ++i) {
        const EndState to{static_cast<double>(read.real(i, "Phase")),
                          static_cast<double>(read.real(i, "Distance")),
                          static_cast<double>(read.real(i, "ConnectingVel")), 0.0};
        append_omron_points(points, from, to, cycle * (to.theta - from.theta) / whole,
                            static_cast<double>(read.real(i, "PhasePitch")));
        from = to;
    }
    return lines_between(points);
}

// Siemens SIMATIC S7-1500T, library LCamHdl: an array of LCamHdl_typeAdvancedElement for
// LCamHdl_CreateCamAdvanced.
//
// Each element has its own s, s', s'' at both ends. camProfileType 5: a polynomial of degree 5; 2: a dwell.
// The block refuses an element whose following value does not change (status 16#820A), so a rest is a dwell,
// and a piece that comes back to where it began is cut in two.
constexpr int profile_dwell = 2, profile_poly5 = 5;

bool rests_throughout(const CamPiece& piece) {
    for (int k = 1; k <= piece.degree(); ++k)
        if (piece.coefficients[k] != 0.0) return false;
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

PlcFormat omron_format() {
    return {.key = "omron",
            .file = "omron.st",
            .controller = "Omron NJ/NX/NY, MC_GenerateCamTable",
            .rule = "cubics between the nodes, made into a table of points with straight lines between them",
            .numbers = "REAL (float32)",
            .degree = 3,
            .counted = PlcCount::pieces,
            .element = "nodes",
            .limit = 360,
            .limit_words = "CamNodes",
            .shared = 1,
            .straight_lines = true,
            .relative = true,
            .prepare = omron_table,
            .write = omron_text,
            .read = omron_pieces};
}

PlcFormat siemens_format() {
    return {.key = "siemens",
            .file = "siemens.scl",
            .controller = "Siemens S7-1500T, LCamHdl_CreateCamAdvanced",
            .rule = "each element a polynomial of degree 5 or a dwell",
            .numbers = "LREAL (float64)",
            .counted = PlcCount::pieces,
            .element = "segments",
            .limit = 50,
            .limit_words = "a technology object TO_Cam",
            .prepare = siemens_table,
            .write = siemens_text,
            .read = siemens_pieces};
}

}  // namespace camopt

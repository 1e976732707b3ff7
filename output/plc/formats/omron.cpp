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
#include "core/errors.hpp"
#include "output/plc/formats/formats.hpp"
#include "output/plc/formats/knots.hpp"
#include "output/plc/structured_text.hpp"

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
            "_mcPolynomic3; "
            "CamNodes[{0}].ConnectingVelEnable := TRUE; CamNodes[{0}].ConnectingVel := {3}; "
            "CamNodes[{0}].PhasePitch "
            ":= {4};\n",
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

}  // namespace

PlcFormat omron_format() {
    PlcFormat format;
    format.key = "omron";
    format.file = "omron.st";
    format.controller = "Omron NJ/NX/NY, MC_GenerateCamTable";
    format.rule = "cubics between the nodes, made into a table of points with straight lines between them";
    format.numbers = "REAL (float32)";
    format.degree = 3;
    format.counted = PlcCount::pieces;
    format.element = "nodes";
    format.limit = 360;
    format.limit_words = "CamNodes";
    format.straight_lines = true;
    format.relative = true;
    format.shared = 1;
    format.prepare = omron_table;
    format.write = omron_text;
    format.read = omron_pieces;
    return format;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "shop/plc/controller_rules.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

void check_elements(std::size_t found, std::size_t least) {
    if (found < least)
        throw InputError(
            fmt::format("an electronic cam: found {} elements; allowed: {} or more", found, least));
}

template <class Piece>
std::vector<PolynomialPiece> pieces_between(const std::vector<EndState>& points, const Piece& piece_between) {
    check_elements(points.size(), 2);
    std::vector<PolynomialPiece> pieces;
    for (std::size_t i = 1; i < points.size(); ++i) pieces.push_back(piece_between(points[i - 1], points[i]));
    return pieces;
}

EndState state_of(const PlcNumbers& numbers, const std::string& place = "") {
    return {numbers.at(place + "x"), numbers.at(place + "s"), numbers.at(place + "v"),
            numbers.at(place + "a")};
}

bool rests_throughout(const PolynomialPiece& piece) {
    for (int k = 1; k <= piece.degree(); ++k)
        if (piece.coefficients[k] != 0.0) return false;
    return true;
}

}  // namespace

std::vector<PolynomialPiece> quintics_between_points(const PlcReading& reading) {
    std::vector<EndState> points;
    for (const PlcNumbers& point : reading.elements) points.push_back(state_of(point));
    return pieces_between(points, quintic_between);
}

std::vector<PolynomialPiece> septics_between_points(const PlcReading& reading) {
    std::vector<EndState> points;
    for (const PlcNumbers& point : reading.elements) {
        points.push_back(state_of(point));
        points.back().j = point.at("j");
    }
    return pieces_between(points, septic_between);
}

std::vector<PolynomialPiece> lines_between_points(const PlcReading& reading) {
    std::vector<EndState> points;
    for (const PlcNumbers& point : reading.elements) points.push_back({point.at("x"), point.at("s")});
    return pieces_between(points, line_between);
}

std::vector<PolynomialPiece> polynomials(const PlcReading& reading) {
    check_elements(reading.elements.size(), 1);
    std::vector<PolynomialPiece> pieces;
    const std::vector<PlcNumbers>& elements = reading.elements;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        PolynomialPiece piece{elements[i].find("x").value_or(i == 0 ? 0.0 : pieces.back().end), 0.0, {}};
        if (const auto end = elements[i].find("to.x"))
            piece.end = *end;
        else
            piece.end = i + 1 < elements.size() ? elements[i + 1].at("x") : reading.rest.at("end.x");
        for (int k = 0; const auto coefficient = elements[i].find(fmt::format("c{}", k)); ++k)
            piece.coefficients.push_back(*coefficient);
        pieces.push_back(piece);
    }
    return pieces;
}

namespace {

constexpr double profile_dwell = 2, profile_poly5 = 5;

/// True where no more than rounding moves: what a solver leaves of a stretch at rest.
bool rests_but_for_rounding(const PolynomialPiece& piece, double lift) {
    constexpr double rounding = 1e-12;  // of the lift
    double most = 0.0, power = 1.0;
    for (int k = 1; k <= piece.degree(); ++k)
        most += std::abs(piece.coefficients[k]) * (power *= piece.end - piece.begin);
    return most <= rounding * lift;
}

/// Pieces that end where they began: dwells, or cut in two, the same polynomial twice.
std::vector<PolynomialPiece> cut_where_they_return(const MasterCurve& curve,
                                                   const std::vector<PolynomialPiece>& fitted) {
    constexpr double no_change = 1e-6;      // of the lift
    constexpr double off_the_middle = 0.4;  // a turning point may lie in the middle
    std::vector<PolynomialPiece> pieces;
    for (const PolynomialPiece& piece : fitted) {
        const double change = value_of(piece, piece.end) - value_of(piece, piece.begin);
        if (rests_but_for_rounding(piece, curve.lift())) {
            pieces.push_back({piece.begin, piece.end, {piece.coefficients[0]}});
            continue;
        }
        if (std::abs(change) > no_change * curve.lift()) {
            pieces.push_back(piece);
            continue;
        }
        const double cut = piece.begin + off_the_middle * (piece.end - piece.begin);
        pieces.push_back({piece.begin, cut, piece.coefficients});
        pieces.push_back({cut, piece.end, polynomial_about(piece, cut)});
    }
    return pieces;
}

}  // namespace

PlcTable siemens_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat& format) {
    FitOptions fit{.points = options.points, .most = format.most_pieces()};
    PlcTable table;
    constexpr int trials = 3;  // cuts leave fewer for the fit, which may move them
    for (int trial = 0; trial < trials; ++trial) {
        table.pieces = cut_where_they_return(curve, fitted_pieces(curve, fit));
        const int over = static_cast<int>(table.pieces.size()) - format.most_pieces();
        if (over <= 0) break;
        fit.most -= over;
    }
    return table;
}

std::vector<PolynomialPiece> siemens_elements(const PlcReading& reading) {
    check_elements(reading.elements.size(), 1);
    std::vector<PolynomialPiece> pieces;
    for (const PlcNumbers& one : reading.elements) {
        const EndState from = state_of(one), to = state_of(one, "to.");
        const double type = one.at("profile");
        if (type == profile_dwell && from.s == to.s && from.v == 0.0 && to.v == 0.0)
            pieces.push_back({from.theta, to.theta, {from.s}});
        else if (type == profile_poly5 && from.s != to.s)
            pieces.push_back(quintic_between(from, to));
        else
            throw InputError(
                fmt::format("siemens: element {} is of type {} from {} to {}; allowed: 2 without "
                            "a change, or 5 with one",
                            pieces.size() + 1, type, from.s, to.s));
    }
    return pieces;
}

double siemens_number(const PlcTable&, const PolynomialPiece& piece, double, std::string_view) {
    return rests_throughout(piece) ? profile_dwell : profile_poly5;
}

double omron_number(const PlcTable& table, const PolynomialPiece& piece, double theta,
                    std::string_view name) {
    constexpr double pitch = 0.1, one_second = 1.0;
    if (name == "pitch") return pitch;
    const double whole = table.pieces.back().end, cycle = table.speed ? whole / *table.speed : one_second;
    return name == "cycle" ? cycle : value_of(piece, theta, 1) * (whole / cycle);
}

namespace {

/// The points the instruction makes of one node, without that of the node before.
void append_omron_points(std::vector<EndState>& points, const EndState& from, const EndState& to,
                         double duration, double pitch) {
    const double rise = to.s - from.s, v0 = from.v * duration, v1 = to.v * duration;
    constexpr double same_phase = 1e-3;  // of the pitch
    for (int k = 1; from.theta + k * pitch < to.theta - same_phase * pitch; ++k) {
        const double phase = from.theta + k * pitch, t = (phase - from.theta) / (to.theta - from.theta);
        const double s = from.s + t * (v0 + t * (3.0 * rise - 2.0 * v0 - v1 + t * (v0 + v1 - 2.0 * rise)));
        points.push_back({as_real(phase), as_real(s), 0.0, 0.0});
    }
    points.push_back(to);
}

}  // namespace

std::vector<PolynomialPiece> omron_points(const PlcReading& reading) {
    check_elements(reading.elements.size(), 1);
    const double cycle = reading.rest.at("cycle"), whole = reading.elements.back().at("next.x");
    EndState from{0.0, 0.0, reading.rest.at("first.velocity"), 0.0};
    std::vector<EndState> points = {from};
    for (const PlcNumbers& node : reading.elements) {
        const EndState to{node.at("next.x"), node.at("next.s"), node.at("next.velocity"), 0.0};
        append_omron_points(points, from, to, cycle * (to.theta - from.theta) / whole, node.at("pitch"));
        from = to;
    }
    return pieces_between(points, line_between);
}

namespace {

constexpr double br_master_unit = 1e-3;  // deg

}  // namespace

double br_master(double theta) {
    return as_real(theta / br_master_unit) * br_master_unit;
}

PlcUnits br_units(const MasterCurve& curve) {
    constexpr double whole = 1e-6, thousandth = 1e-3;  // units; or less, where the travel of a turn is whole
    for (const double unit : {thousandth, 1e-4, 1e-5}) {
        const double units = curve.travel() / unit;
        if (std::abs(units - std::round(units)) <= whole) return {br_master_unit, unit};
    }
    return {br_master_unit, thousandth};
}

}  // namespace camopt

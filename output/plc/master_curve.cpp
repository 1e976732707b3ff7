// SPDX-License-Identifier: MIT
#include "output/plc/master_curve.hpp"

#include "core/units.hpp"
#include "core/whole_turn.hpp"
#include "splines/curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

constexpr double same_degree = 1e-10;       // far above the rounding of 360, far below any stretch
constexpr double rounding_of_turn = 4e-13;  // some units in the last place of 360

/// 10.000000000000002 is 10: what a change of unit has rounded.
double clean_degrees(double theta) {
    constexpr double grain = 1e9;
    const double rounded = std::round(theta * grain) / grain;
    return std::abs(rounded - theta) <= rounding_of_turn ? rounded : theta;
}

std::size_t nearest_index(const std::vector<double>& ascending, double value) {
    const auto above = std::ranges::lower_bound(ascending, value);
    if (above == ascending.begin()) return 0;
    if (above == ascending.end()) return ascending.size() - 1;
    const bool below_is_nearer = value - *(above - 1) < *above - value;
    return static_cast<std::size_t>(above - ascending.begin()) - (below_is_nearer ? 1 : 0);
}

double shape_place(const SplineCurve& curve, double own) {
    constexpr double same_place = 1e-12;
    const std::vector<double> breakpoints = curve.breakpoints();
    const double nearest = breakpoints[nearest_index(breakpoints, own)];
    if (std::abs(nearest - own) <= same_place * std::max(1.0, std::abs(own))) return nearest;
    return std::clamp(own, breakpoints.front(), breakpoints.back());
}

}  // namespace

MasterCurve::MasterCurve(MotionChain turn, const MotionSpec& motion)
    : turn_(std::move(turn)),
      lift_(motion.lift / (motion.lift_is_angle ? units::degree : units::millimetre)),
      degrees_per_x_(motion.unit_angle() / units::degree),
      swings_(motion.lift_is_angle),
      places_(turn_.breakpoints()) {
    for (const double x : places_) breakpoints_.push_back(clean_degrees(degrees_per_x_ * x));
    constexpr double whole = 360.0;
    if (is_whole_turn(breakpoints_.back() * units::degree)) breakpoints_.back() = whole;
}

double MasterCurve::place(double theta) const {
    const std::size_t nearest = nearest_index(breakpoints_, theta);
    if (std::abs(breakpoints_[nearest] - theta) <= same_degree) return places_[nearest];
    return std::clamp(theta / degrees_per_x_, places_.front(), places_.back());
}

std::array<double, 4> MasterCurve::at(double theta, Side side) const {
    std::array<double, 4> state = turn_.at(place(theta), side).derivative;
    double scale = lift_;
    for (double& value : state) {
        value *= scale;
        scale /= degrees_per_x_;
    }
    return state;
}

std::vector<double> MasterCurve::polynomial(double theta, Side side) const {
    const double x = place(theta);
    const std::vector<ChainPart>& parts = turn_.parts();
    std::size_t index = 0;
    while (index + 1 < parts.size() &&
           (side == Side::right ? x >= parts[index + 1].begin : x > parts[index + 1].begin))
        ++index;
    const ChainPart& part = parts[index];
    if (!part.shape) return {lift_ * part.y0};
    const auto* const curve = dynamic_cast<const SplineCurve*>(part.shape.get());
    if (!curve) return {};
    const double own = shape_place(*curve, (x - part.x0) / part.x_scale);
    const bool mirrored = part.x_scale < 0.0;
    const Side own_side = mirrored == (side == Side::right) ? Side::left : Side::right;
    std::vector<double> coefficients;
    double scale = lift_ * part.y_scale;
    for (int order = 0; order <= curve->degree(); ++order) {
        if (order > 0) scale /= part.x_scale * degrees_per_x_ * order;
        coefficients.push_back(scale * curve->derivative(own, order, own_side));
    }
    coefficients[0] += lift_ * part.y0;
    return coefficients;
}

double MasterCurve::travel() const {
    return at(end(), Side::left)[0] - at(0.0, Side::right)[0];
}

bool MasterCurve::closes() const {
    constexpr double same_displacement = 1e-9;  // of the lift: above the tolerance of a solve
    return std::abs(travel()) <= same_displacement * lift_;
}

}  // namespace camopt

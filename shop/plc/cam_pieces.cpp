// SPDX-License-Identifier: MIT
#include "shop/plc/cam_pieces.hpp"

#include "core/numbers/polynomial.hpp"
#include "report/view/shown_units.hpp"
#include "splines/curve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double close_enough = 1e-8;  // of the lift: a hundred times below what a drive's encoder resolves
constexpr double same_place_degree = 1e-9;

struct Stretch {
    double from = 0.0, to = 0.0;
    PolynomialPiece piece;
    double error = 0.0;
};

/// The state at the master position the controller holds instead of `theta`, on the curve that `side` sees.
EndState held_state(const MasterCurve& curve, double theta, Side side, const FitOptions& options) {
    const std::array<double, 4> at = curve.at(theta, side);
    EndState state{theta, at[0], at[1], at[2], at[3]};
    if (!options.master) return state;
    state.theta = options.master(theta);
    const double step = state.theta - theta;
    state.s += step * (at[1] + step * (at[2] / 2.0 + step * at[3] / 6.0));
    state.v += step * (at[2] + step * at[3] / 2.0);
    state.a += step * at[3];
    return state;
}

/// The motion itself from joint to joint, where it is a polynomial of no higher degree there; else empty.
std::vector<double> own_polynomial(const MasterCurve& curve, double from, double to, int degree) {
    const auto inside = std::ranges::upper_bound(curve.breakpoints(), from + same_place_degree);
    if (inside != curve.breakpoints().end() && *inside < to - same_place_degree) return {};
    std::vector<double> own = curve.polynomial(from, Side::right);
    if (static_cast<int>(own.size()) > degree + 1) own.clear();
    return own;
}

Stretch stretch_between(const MasterCurve& curve, double from, double to, const FitOptions& options) {
    Stretch stretch{from, to, {}, 0.0};
    const EndState begin = held_state(curve, from, Side::right, options);
    const EndState end = held_state(curve, to, Side::left, options);
    const std::vector<double> own = own_polynomial(curve, from, to, options.degree);
    const bool has_jerk = std::isfinite(begin.j) && std::isfinite(end.j);  // not every law's end has one
    if (options.degree == 1)
        stretch.piece = line_between(begin, end);
    else if (!own.empty())
        stretch.piece = {begin.theta, end.theta, polynomial_about({from, to, own}, begin.theta)};
    else
        stretch.piece = options.degree == 3               ? cubic_between(begin, end)
                        : options.degree == 7 && has_jerk ? septic_between(begin, end)
                                                          : quintic_between(begin, end);
    if (!options.points) stretch.error = largest_difference(curve, stretch.piece, {from, to}, 0).value;
    return stretch;
}

std::vector<double> joints_of(const MasterCurve& curve, const FitOptions& options) {
    if (!options.points) return curve.breakpoints();
    std::vector<double> joints;
    const int last = *options.points - 1;
    for (int i = 0; i <= last; ++i) joints.push_back(curve.end() * i / last);
    joints.back() = curve.end();
    return joints;
}

constexpr double same_degree = 1e-10;       // far above the rounding of 360, far below any stretch
constexpr double rounding_of_turn = 4e-13;  // some units in the last place of 360

/// 10.000000000000002 is 10: what a change of unit has rounded.
double clean_degrees(double theta) {
    constexpr double grain = 1e9;
    const double rounded = std::round(theta * grain) / grain;
    return std::abs(rounded - theta) <= rounding_of_turn ? rounded : theta;
}

double shape_place(const SplineCurve& curve, double own) {
    constexpr double same_place = 1e-12;
    const std::vector<double> breakpoints = curve.breakpoints();
    const double nearest = breakpoints[nearest_index(breakpoints, own)];
    if (std::abs(nearest - own) <= same_place * std::max(1.0, std::abs(own))) return nearest;
    return std::clamp(own, breakpoints.front(), breakpoints.back());
}

constexpr double same_joint_degree = 1e-9;  // joints of motion and table that are one but for rounding
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();  // of the numbers that are added

void keep_larger(CamDifference& largest, const CamDifference& found) {
    if (found.value > largest.value) largest = found;
}

/// d(t) = Σ d_k (t / h)^k of the difference of two polynomials about the same place.
Eigen::VectorXd scaled_difference(const std::vector<double>& a, const std::vector<double>& b, double h) {
    const std::size_t size = std::max(a.size(), b.size());
    Eigen::VectorXd difference = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
    double scale = 1.0;
    for (std::size_t k = 0; k < size; ++k, scale *= h)
        difference[static_cast<Eigen::Index>(k)] =
            scale * ((k < a.size() ? a[k] : 0.0) - (k < b.size() ? b[k] : 0.0));
    return difference;
}

std::vector<double> magnitudes(std::vector<double> numbers, double sign = 1.0) {
    for (double& number : numbers) number = sign * std::abs(number);
    return numbers;
}

double magnitude(const Interval& range) {
    return std::max(-range.lower, range.upper);
}

CamDifference polynomial_difference(const std::vector<double>& exact, const PolynomialPiece& piece,
                                    const MasterStretch& stretch, int order) {
    const double h = stretch.to - stretch.from;
    const std::vector<double> about = polynomial_about(piece, stretch.from);
    Eigen::VectorXd d = scaled_difference(exact, about, h);
    Eigen::VectorXd sizes = rounding * scaled_difference(magnitudes(exact), magnitudes(about, -1.0), h);
    double scale = 1.0;
    for (int r = 0; r < order; ++r, scale /= h) {
        d = differentiated(d);
        sizes = differentiated(sizes);
    }
    std::vector<double> places = sign_changes(differentiated(d), 0.0, 1.0);
    places.insert(places.end(), {0.0, 1.0});
    CamDifference largest{0.0, stretch.from};
    for (const double u : places)
        keep_larger(largest, {scale * std::abs(evaluate_polynomial(d, u)), stretch.from + u * h});
    largest.value += scale * sizes.sum();
    return largest;
}

/// |d|, d = motion − piece of that order, over a part of the stretch, from its middle m and half its width w:
/// Σ |d^(k)(m)| w^(k−r) / (k−r)! to k = 3, and the largest |d''''| for the rest.
struct LawPart {
    double from = 0.0, to = 0.0, bound = 0.0, in_the_middle = 0.0;

    LawPart(const MasterCurve& curve, const PolynomialPiece& piece, const MasterStretch& part, int order)
        : from(part.from), to(part.to) {
        const double middle = 0.5 * (from + to), w = 0.5 * (to - from);
        const std::array<Interval, 5> over = curve.ranges(part);
        const std::array<double, 4> own = curve.at(middle, Side::left);
        const PolynomialPiece sizes{piece.begin, piece.end, magnitudes(piece.coefficients)};
        double weight = 1.0;
        for (int k = order; k < 4; ++k) {
            const double lost =
                rounding * (magnitude(over[k]) + value_of(sizes, middle, k) + (k == 0 ? curve.lift() : 0.0));
            const double here = std::abs(own[k] - value_of(piece, middle, k)) + lost;
            if (k == order) in_the_middle = here;
            bound += weight * here;
            weight *= w / (k - order + 1);
        }
        Interval fourth(0.0);
        for (int k = piece.degree(); k >= 4; --k)
            fourth = fourth * Interval(from - piece.begin, to - piece.begin) +
                     Interval(piece.coefficients[k] * k * (k - 1) * (k - 2) * (k - 3));
        bound += weight * magnitude(over[4] - fourth);
    }
};

/// A proved bound, above the largest value found by at most `close`. The part with the largest bound is
/// halved, as long as it is above what is known.
CamDifference enclosed_difference(const MasterCurve& curve, const PolynomialPiece& piece,
                                  const MasterStretch& stretch, int order, double known) {
    constexpr double close = 0.02;
    constexpr std::size_t most_parts = 4000;
    std::vector<LawPart> parts = {{curve, piece, stretch, order}};
    double found = 0.0;
    while (true) {
        const LawPart worst = parts.front();
        found = std::max(found, worst.in_the_middle);
        if (worst.bound <= std::max(known, (1.0 + close) * found) || parts.size() == most_parts)
            return {worst.bound, 0.5 * (worst.from + worst.to)};
        std::ranges::pop_heap(parts, {}, &LawPart::bound);
        parts.pop_back();
        const double middle = 0.5 * (worst.from + worst.to);
        for (const MasterStretch& half :
             {MasterStretch{worst.from, middle}, MasterStretch{middle, worst.to}}) {
            parts.emplace_back(curve, piece, half, order);
            std::ranges::push_heap(parts, {}, &LawPart::bound);
        }
    }
}

CamDifference difference_without_joint(const MasterCurve& curve, const PolynomialPiece& piece,
                                       const MasterStretch& stretch, int order, double known) {
    const std::vector<double> exact = curve.polynomial(stretch.from, Side::right);
    return exact.empty() ? enclosed_difference(curve, piece, stretch, order, known)
                         : polynomial_difference(exact, piece, stretch, order);
}

void check_cover(const MasterCurve& curve, const std::vector<PolynomialPiece>& pieces) {
    if (pieces.empty()) throw InputError("an electronic cam: found no piece");
    double reached = 0.0;
    for (const PolynomialPiece& piece : pieces) {
        if (std::abs(piece.begin - reached) > same_joint_degree || !(piece.end > piece.begin))
            throw InputError(fmt::format("an electronic cam: a piece from {} to {} deg after {} deg",
                                         piece.begin, piece.end, reached));
        reached = piece.end;
    }
    if (std::abs(reached - curve.end()) > same_joint_degree)
        throw InputError(
            fmt::format("an electronic cam: ends at {} deg, the motion at {} deg", reached, curve.end()));
}

}  // namespace

double value_of(const PolynomialPiece& piece, double theta, int order) {
    const double t = theta - piece.begin;
    double value = 0.0;
    for (int k = piece.degree(); k >= order; --k) {
        double factor = piece.coefficients[k];
        for (int i = 0; i < order; ++i) factor *= k - i;
        value = value * t + factor;
    }
    return value;
}

std::vector<double> polynomial_about(const PolynomialPiece& piece, double theta) {
    std::vector<double> coefficients;
    double factorial = 1.0;
    for (int k = 0; k <= piece.degree(); ++k) {
        if (k > 0) factorial *= k;
        coefficients.push_back(value_of(piece, theta, k) / factorial);
    }
    return coefficients;
}

// What the controller would make of the numbers without rounding: differences of near ones lose digits.
using Wide = long double;

PolynomialPiece line_between(const EndState& from, const EndState& to) {
    return {from.theta, to.theta, {from.s, (to.s - from.s) / (to.theta - from.theta)}};
}

PolynomialPiece cubic_between(const EndState& from, const EndState& to) {
    const Wide h = Wide(to.theta) - from.theta, rise = Wide(to.s) - from.s;
    const Wide v0 = from.v, v1 = to.v;
    return {from.theta,
            to.theta,
            {from.s, from.v, static_cast<double>((3 * rise / h - 2 * v0 - v1) / h),
             static_cast<double>((v0 + v1 - 2 * rise / h) / (h * h))}};
}

PolynomialPiece quintic_between(const EndState& from, const EndState& to) {
    const Wide h = Wide(to.theta) - from.theta;
    // What the parabola of the begin leaves open at the end, each by its own power of h.
    const Wide s = to.s - (from.s + h * (from.v + h * from.a / 2));
    const Wide v = h * (to.v - (from.v + h * from.a));
    const Wide a = h * h * (Wide(to.a) - from.a);
    const Wide cube = h * h * h;
    return {from.theta,
            to.theta,
            {from.s, from.v, from.a / 2.0, static_cast<double>((10 * s - 4 * v + a / 2) / cube),
             static_cast<double>((-15 * s + 7 * v - a) / (cube * h)),
             static_cast<double>((6 * s - 3 * v + a / 2) / (cube * h * h))}};
}

PolynomialPiece septic_between(const EndState& from, const EndState& to) {
    const Wide h = Wide(to.theta) - from.theta;
    // What the cubic of the begin leaves open at the end, each by its own power of h.
    const Wide s = to.s - (from.s + h * (from.v + h * (from.a / 2 + h * from.j / 6)));
    const Wide v = h * (to.v - (from.v + h * (from.a + h * from.j / 2)));
    const Wide a = h * h * (to.a - (from.a + h * from.j));
    const Wide j = h * h * h * (Wide(to.j) - from.j);
    const std::array<Wide, 4> upper = {35 * s - 15 * v + 5 * a / 2 - j / 6, -84 * s + 39 * v - 7 * a + j / 2,
                                       70 * s - 34 * v + 13 * a / 2 - j / 2,
                                       -20 * s + 10 * v - 2 * a + j / 6};
    PolynomialPiece piece{from.theta, to.theta, {from.s, from.v, from.a / 2.0, from.j / 6.0}};
    Wide power = h * h * h * h;
    for (const Wide coefficient : upper) {
        piece.coefficients.push_back(static_cast<double>(coefficient / power));
        power *= h;
    }
    return piece;
}

std::vector<PolynomialPiece> fitted_pieces(const MasterCurve& curve, const FitOptions& options) {
    const std::vector<double> joints = joints_of(curve, options);
    std::vector<Stretch> stretches;
    for (std::size_t i = 1; i < joints.size(); ++i)
        stretches.push_back(stretch_between(curve, joints[i - 1], joints[i], options));
    const auto most = static_cast<std::size_t>(options.most);
    const auto worse = [](const Stretch& a, const Stretch& b) { return a.error < b.error; };
    std::ranges::make_heap(stretches, worse);
    while (!options.points && stretches.size() < most &&
           stretches.front().error > close_enough * curve.lift()) {
        std::ranges::pop_heap(stretches, worse);
        const Stretch halved = stretches.back();
        stretches.pop_back();
        const double middle = 0.5 * (halved.from + halved.to);
        for (const auto& [from, to] : {std::pair{halved.from, middle}, std::pair{middle, halved.to}}) {
            stretches.push_back(stretch_between(curve, from, to, options));
            std::ranges::push_heap(stretches, worse);
        }
    }
    std::ranges::sort(stretches, {}, &Stretch::from);
    std::vector<PolynomialPiece> pieces(stretches.size());
    std::ranges::transform(stretches, pieces.begin(), &Stretch::piece);
    return pieces;
}

MasterCurve::MasterCurve(MotionChain turn, const MotionSpec& motion)
    : turn_(std::move(turn)),
      lift_((motion.lift_is_angle ? degrees_shown : millimetres_shown).of(motion.lift)),
      degrees_per_x_(degrees_shown.of(motion.unit_angle())),
      phase_(degrees_shown.of(motion.phase)),
      swings_(motion.lift_is_angle),
      places_(turn_.breakpoints()) {
    const auto [low, high] = motion.displacements();
    displacements_ = {lift_ * (low / motion.lift), lift_ * (high / motion.lift)};
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

std::array<Interval, 5> MasterCurve::ranges(const MasterStretch& stretch) const {
    const double from = place(stretch.from), to = place(stretch.to);
    const auto part = std::ranges::find_if(
        turn_.parts(), [middle = 0.5 * (from + to)](const ChainPart& one) { return middle < one.end; });
    const auto own = ranges_of(*part, {from, to});
    if (!own) throw InputError("an electronic cam: a law without enclosures");
    std::array<Interval, 5> found;
    double scale = lift_;
    for (std::size_t r = 0; r < found.size(); ++r, scale /= degrees_per_x_)
        found[r] = Interval(scale) * (*own)[r];
    return found;
}

bool MasterCurve::closes() const {
    constexpr double same_displacement = 1e-9;  // of the lift: above the tolerance of a solve
    return std::abs(travel()) <= same_displacement * lift_;
}

CamDifference largest_difference(const MasterCurve& curve, const PolynomialPiece& piece,
                                 const MasterStretch& stretch, int order, double known) {
    CamDifference largest{0.0, stretch.from};
    const auto add = [&](const MasterStretch& part) {
        keep_larger(largest,
                    difference_without_joint(curve, piece, part, order, std::max(known, largest.value)));
    };
    double from = stretch.from;
    for (const double joint : curve.breakpoints()) {
        if (joint <= from + same_joint_degree || joint >= stretch.to - same_joint_degree) continue;
        add({from, joint});
        from = joint;
    }
    add({from, stretch.to});
    return largest;
}

std::array<CamDifference, 4> cam_loss(const MasterCurve& curve, const std::vector<PolynomialPiece>& pieces,
                                      int orders) {
    check_cover(curve, pieces);
    const auto joint_at = [&](double theta) {  // the motion's own where the table means it
        for (const double joint : curve.breakpoints())
            if (std::abs(joint - theta) <= same_joint_degree) return joint;
        return theta;
    };
    std::array<CamDifference, 4> largest;
    for (const PolynomialPiece& piece : pieces) {
        const MasterStretch stretch{joint_at(piece.begin), joint_at(piece.end)};
        for (int order = 0; order < orders; ++order)
            keep_larger(largest[order],
                        largest_difference(curve, piece, stretch, order, largest[order].value));
    }
    return largest;
}

std::array<CamDifference, 4> cam_peaks(const MasterCurve& curve) {
    return cam_loss(curve, {{0.0, curve.end(), {0.0}}});
}

}  // namespace camopt

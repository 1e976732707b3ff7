// SPDX-License-Identifier: MIT
#include "motions/laws/law.hpp"

#include "core/errors.hpp"
#include "core/numbers/polynomial.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// Tolerance of x outside [0, 1]: some roundings of a cam angle divided by a rise angle.
constexpr double end_rounding = 1e-12;

/// The fastest wave in the catalogue is the torque of Freudenstein 1-3-5: 20 half waves in its one piece.
constexpr int kCells = 256;
constexpr int most_bisections = 200;  // more than enough to reach neighbouring doubles
/// Peaks of equal height differ only by rounding; the first of them is reported.
constexpr double kSameHeight = 1e-13;
/// A jump of y'' below this part of its peak is round-off, not an impulse.
constexpr double kSmallestJump = 1e-9;

enum class Quantity { velocity, acceleration, jerk, torque };

struct ValueAndSlope {
    double value, slope;
};

ValueAndSlope pick(const LawDerivatives& d, Quantity quantity) {
    switch (quantity) {
        case Quantity::velocity:
            return {d[1], d[2]};
        case Quantity::acceleration:
            return {d[2], d[3]};
        case Quantity::jerk:
            return {d[3], d[4]};
        case Quantity::torque:
            break;
    }
    return {d[1] * d[2], d[2] * d[2] + d[1] * d[3]};
}

/// Largest and smallest value so far; the first location wins among equals.
struct Range {
    Extremum highest{-std::numeric_limits<double>::infinity(), 0.0, Side::right};
    Extremum lowest{std::numeric_limits<double>::infinity(), 0.0, Side::right};

    void take(const Extremum& found) {
        const double same = kSameHeight * std::abs(found.value);
        const bool first = std::isinf(highest.value);
        if (first || found.value > highest.value + same) highest = found;
        if (first || found.value < lowest.value - same) lowest = found;
    }
};

/// The cells of one piece with the law's derivatives at their ends, taken from inside the piece.
class Piece {
 public:
    Piece(const Law& law, double begin, double end) : law_(law), begin_(begin), end_(end) {
        for (int i = 0; i <= kCells; ++i) nodes_[i] = law.derivatives(place(i), side(i));
    }

    void extend(Range& range, Quantity quantity) const {
        for (int i = 0; i <= kCells; ++i) {
            const ValueAndSlope left = pick(nodes_[i], quantity);
            const bool at_end = i == 0 || i == kCells;
            if (at_end || left.slope == 0.0) range.take({left.value, place(i), side(i)});
            if (i == kCells) break;
            const double right_slope = pick(nodes_[i + 1], quantity).slope;
            if ((left.slope < 0.0 && right_slope > 0.0) || (left.slope > 0.0 && right_slope < 0.0))
                range.take(bisect(i, quantity, left.slope > 0.0));
        }
    }

    /// ∫ of the squares of y', y'', y''' over the piece.
    [[nodiscard]] std::array<double, 3> squares() const {
        std::array<double, 3> sum{};
        for (int i = 0; i < kCells; ++i) {
            const double half = 0.5 * (place(i + 1) - place(i));
            const double middle = place(i) + half;
            for (const QuadraturePoint& point : gauss_legendre) {
                const LawDerivatives d = law_.derivatives(middle + half * point.place);
                for (std::size_t r = 0; r < 3; ++r) sum[r] += point.weight * half * d[r + 1] * d[r + 1];
            }
        }
        return sum;
    }

 private:
    [[nodiscard]] double place(int i) const {
        return i == kCells ? end_ : begin_ + (end_ - begin_) * i / kCells;
    }
    [[nodiscard]] static Side side(int i) { return i == kCells ? Side::left : Side::right; }

    [[nodiscard]] Extremum bisect(int cell, Quantity quantity, bool rising) const {
        const auto before = [&](double x) {
            return (pick(law_.derivatives(x), quantity).slope > 0.0) == rising;
        };
        const double top =
            bisected(before, {place(cell), place(cell + 1)}, most_bisections, [](const Border& now) {
                const double middle = 0.5 * (now.with + now.without);
                return !(now.with < middle && middle < now.without);
            }).without;
        return {pick(law_.derivatives(top, Side::left), quantity).value, top, Side::left};
    }

    const Law& law_;
    double begin_, end_;
    std::array<LawDerivatives, kCells + 1> nodes_{};
};

std::vector<Piece> pieces_of(const Law& law) {
    const std::vector<double> breakpoints = law.breakpoints();
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i)
        pieces.emplace_back(law, breakpoints[i], breakpoints[i + 1]);
    return pieces;
}

Range range_of(const std::vector<Piece>& pieces, Quantity quantity) {
    Range range;
    for (const Piece& piece : pieces) piece.extend(range, quantity);
    return range;
}

Extremum magnitude(const Range& range) {
    const double up = std::abs(range.highest.value), down = std::abs(range.lowest.value);
    const bool same = up == down || std::abs(up - down) <= kSameHeight * std::max(up, down);
    const bool take_up = same ? range.highest.at <= range.lowest.at : up > down;
    Extremum peak = take_up ? range.highest : range.lowest;
    peak.value = std::abs(peak.value);
    return peak;
}

/// Replaces the extremes of the jerk by the first impulses where y'' jumps, the joints at the ends included.
void add_impulses(Range& jerk, const Law& law, double acceleration_peak) {
    const std::vector<double> breakpoints = law.breakpoints();
    for (const double x : breakpoints) {
        double before = x > 0.0 ? law.derivatives(x, Side::left)[2] : 0.0;
        double after = x < 1.0 ? law.derivatives(x, Side::right)[2] : 0.0;
        if (x == 1.0 && law.info().top == TopEnd::turning_point) after = before;
        const double jump = after - before;
        if (std::abs(jump) <= kSmallestJump * acceleration_peak) continue;
        Extremum& extreme = jump > 0.0 ? jerk.highest : jerk.lowest;
        if (std::isinf(extreme.value)) continue;
        extreme = {std::copysign(std::numeric_limits<double>::infinity(), jump), x,
                   x < 1.0 ? Side::right : Side::left};
    }
}

Range jerk_range(const std::vector<Piece>& pieces, const Law& law) {
    Range jerk = range_of(pieces, Quantity::jerk);
    add_impulses(jerk, law, magnitude(range_of(pieces, Quantity::acceleration)).value);
    return jerk;
}

}  // namespace

Law::Law(LawInfo info) : info_(std::move(info)) {}

LawDerivatives Law::derivatives(double x, Side side) const {
    if (!(x >= -end_rounding && x <= 1.0 + end_rounding))
        throw InputError(fmt::format("{}: x = {} found, allowed 0 <= x <= 1", info_.key, x));
    return evaluate(std::clamp(x, 0.0, 1.0), side);
}

MotionPoint Law::at(double x, Side side) const {
    const LawDerivatives value = derivatives(x, side);
    return {x, {value[0], value[1], value[2], value[3]}};
}

Peaks find_peaks_without_impulses(const Law& law) {
    const std::vector<Piece> pieces = pieces_of(law);
    Peaks peaks;
    peaks.velocity = magnitude(range_of(pieces, Quantity::velocity));
    peaks.acceleration = magnitude(range_of(pieces, Quantity::acceleration));
    peaks.jerk = magnitude(range_of(pieces, Quantity::jerk));
    peaks.torque = magnitude(range_of(pieces, Quantity::torque));
    std::array<double, 3> sum{};
    for (const Piece& piece : pieces) {
        const std::array<double, 3> part = piece.squares();
        for (std::size_t r = 0; r < sum.size(); ++r) sum[r] += part[r];
    }
    for (int order = 1; order <= 3; ++order)
        derivative_mean(peaks, order) = std::sqrt(sum[static_cast<std::size_t>(order) - 1]);
    return peaks;
}

Peaks Law::peaks() const {
    Peaks peaks = find_peaks_without_impulses(*this);
    peaks.jerk = magnitude(jerk_range(pieces_of(*this), *this));
    if (std::isinf(peaks.jerk.value)) derivative_mean(peaks, 3) = peaks.jerk.value;
    return peaks;
}

}  // namespace camopt

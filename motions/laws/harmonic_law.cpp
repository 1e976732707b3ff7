// SPDX-License-Identifier: MIT
#include "motions/laws/harmonic_law.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using std::numbers::pi;

/// Residual velocity at x = 1, as a part of the mean velocity, that counts as round-off.
constexpr double kRestTolerance = 1e-12;

void require_cover(const LawInfo& info, const std::vector<AccelerationPiece>& shape) {
    double reached = 0.0;
    for (const AccelerationPiece& piece : shape) {
        if (piece.begin != reached || !(piece.end > piece.begin))
            throw ModelError(fmt::format("{}: a piece [{}, {}] follows x = {}", info.key, piece.begin,
                                         piece.end, reached));
        reached = piece.end;
    }
    if (reached != 1.0)
        throw ModelError(fmt::format("{}: the pieces end at x = {}, not 1", info.key, reached));
}

/// Tolerance on the difference of the two expansions at x = 1/2, as a part of the sum of the coefficients'
/// magnitudes times the derivative's growth with the degree: Horner's rule has a round-off of some 1e-15 of
/// that.
constexpr double kMeeting = 1e-13;

std::vector<double> mirrored(std::vector<double> coefficients) {
    for (double& coefficient : coefficients) coefficient = -coefficient;
    if (!coefficients.empty()) coefficients[0] += 1.0;
    return coefficients;
}

/// Horner's rule for a polynomial and its derivatives over r!, all at once.
template <class T>
std::array<T, 5> horner(const std::vector<double>& coefficients, const T& t) {
    std::array<T, 5> y{};
    for (std::size_t m = coefficients.size(); m-- > 0;) {
        for (std::size_t r = y.size() - 1; r > 0; --r) y[r] = y[r] * t + y[r - 1];
        y[0] = y[0] * t + T(coefficients[m]);
    }
    double factorial = 1.0;
    for (std::size_t r = 2; r < y.size(); ++r) y[r] = T(factorial *= static_cast<double>(r)) * y[r];
    return y;
}

template <class T>
std::array<T, 5> horner_from_top(const std::vector<double>& coefficients, const T& x) {
    std::array<T, 5> y = horner(coefficients, T(1.0) - x);
    y[1] = -y[1];
    y[3] = -y[3];
    return y;
}

}  // namespace

AccelerationPiece zero_piece(double begin, double end) {
    return {begin, end};
}

AccelerationPiece constant_piece(double begin, double end, double height) {
    return {begin, end, height};
}

AccelerationPiece ramp_piece(double begin, double end, double from, double to) {
    return {begin, end, from, {}, (to - from) / (end - begin)};
}

AccelerationPiece quarter_sine_up(double begin, double end, double height) {
    return {begin, end, 0.0, {{0.5 * pi / (end - begin), height, 0.0}}};
}

AccelerationPiece quarter_cosine_down(double begin, double end, double height) {
    return {begin, end, 0.0, {{0.5 * pi / (end - begin), 0.0, height}}};
}

AccelerationPiece half_cosine(double begin, double end, double height) {
    return {begin, end, 0.0, {{pi / (end - begin), 0.0, height}}};
}

AccelerationPiece half_sine(double begin, double end, double height) {
    return {begin, end, 0.0, {{pi / (end - begin), height, 0.0}}};
}

HarmonicLaw::HarmonicLaw(LawInfo info, std::vector<AccelerationPiece> shape) : Law(std::move(info)) {
    require_cover(this->info(), shape);
    double velocity = 0.0, displacement = 0.0;
    for (AccelerationPiece& part : shape) {
        Piece piece{std::move(part), velocity, displacement};
        for (const HarmonicTerm& term : piece.acceleration.terms) {
            piece.velocity += term.sine / term.frequency;
            piece.displacement += term.cosine / (term.frequency * term.frequency);
        }
        const LawDerivatives last = evaluate(piece, piece.acceleration.end);
        displacement = last[0];
        velocity = last[1];
        pieces_.push_back(std::move(piece));
    }
    if (!(displacement > 0.0) || !(std::abs(velocity) <= kRestTolerance * displacement))
        throw ModelError(fmt::format("{}: the shape ends at y = {}, y' = {}, not at rest above 0", key(),
                                     displacement, velocity));
    for (Piece& piece : pieces_) {
        piece.velocity /= displacement;
        piece.displacement /= displacement;
        piece.acceleration.constant /= displacement;
        piece.acceleration.slope /= displacement;
        for (HarmonicTerm& term : piece.acceleration.terms) {
            term.sine /= displacement;
            term.cosine /= displacement;
        }
    }
}

std::vector<double> HarmonicLaw::breakpoints() const {
    std::vector<double> result{0.0};
    for (const Piece& piece : pieces_) result.push_back(piece.acceleration.end);
    return result;
}

LawDerivatives HarmonicLaw::evaluate(double x, Side side) const {
    const auto holds = [x, side](const Piece& piece) {
        return side == Side::right ? x < piece.acceleration.end : x <= piece.acceleration.end;
    };
    const auto found = std::find_if(pieces_.begin(), pieces_.end(), holds);
    return evaluate(found == pieces_.end() ? pieces_.back() : *found, x);
}

std::optional<std::array<Interval, 5>> HarmonicLaw::ranges(const Interval& x) const {
    const double middle = 0.5 * (x.lower + x.upper);
    const auto found = std::ranges::find_if(
        pieces_, [middle](const Piece& piece) { return middle < piece.acceleration.end; });
    return evaluate(found == pieces_.end() ? pieces_.back() : *found, x);
}

template <class T>
std::array<T, 5> HarmonicLaw::evaluate(const Piece& piece, const T& x) {
    using std::cos, std::sin;
    const T t = x - T(piece.acceleration.begin);
    const T constant = piece.acceleration.constant, slope = piece.acceleration.slope;
    const T bend = slope * t;
    std::array<T, 5> y{
        T(piece.displacement) + t * (T(piece.velocity) + t * (T(0.5) * constant + T(1.0 / 6.0) * bend)),
        T(piece.velocity) + t * (constant + T(0.5) * bend), constant + bend, slope, T(0.0)};
    for (const HarmonicTerm& term : piece.acceleration.terms) {
        const T w = term.frequency, along = term.sine, across = term.cosine;
        const T sine = sin(w * t), cosine = cos(w * t);
        const T wave = along * sine + across * cosine;
        const T shifted = along * cosine - across * sine;
        y[0] = y[0] - wave / (w * w);
        y[1] = y[1] - shifted / w;
        y[2] = y[2] + wave;
        y[3] = y[3] + w * shifted;
        y[4] = y[4] - w * w * wave;
    }
    return y;
}

PolynomialLaw::PolynomialLaw(LawInfo info, const std::vector<double>& from_below)
    : PolynomialLaw(std::move(info), from_below, mirrored(from_below)) {}

PolynomialLaw::PolynomialLaw(LawInfo info, std::vector<double> from_below, std::vector<double> from_top)
    : Law(std::move(info)), from_below_(std::move(from_below)), from_top_(std::move(from_top)) {
    const LawDerivatives below = horner(from_below_, 0.5), top = horner_from_top(from_top_, 0.5);
    double scale = 1.0;
    for (const double coefficient : from_below_) scale += std::abs(coefficient);
    for (std::size_t r = 0; r < below.size(); ++r) {
        if (!(std::abs(below[r] - top[r]) <= kMeeting * scale))
            throw ModelError(fmt::format("{}: derivative {} at x = 1/2 is {} from below and {} from the top",
                                         key(), r, below[r], top[r]));
        scale *= static_cast<double>(from_below_.size());
    }
}

LawDerivatives PolynomialLaw::evaluate(double x, Side /*side*/) const {
    return x > 0.5 ? horner_from_top(from_top_, x) : horner(from_below_, x);
}

std::optional<std::array<Interval, 5>> PolynomialLaw::ranges(const Interval& x) const {
    return 0.5 * (x.lower + x.upper) > 0.5 ? horner_from_top(from_top_, x) : horner(from_below_, x);
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "motions/laws/law_families.hpp"

#include <cmath>

namespace camopt {

namespace {

/// y''(1 − x) = −y''(x) of a shape that is even about the middle of its piece or a quarter wave.
AccelerationPiece mirrored(double begin, double end, const AccelerationPiece& from) {
    AccelerationPiece piece{begin, end, -from.constant};
    for (const HarmonicTerm& term : from.terms) {
        // sin w(length − t) and cos w(length − t) by the addition theorems; the shapes used here end where
        // w·length is a quarter or a half turn, whose sine and cosine are exact integers.
        const double quarters =
            std::round(term.frequency * (from.end - from.begin) / (0.5 * std::numbers::pi));
        const double sine = quarters == 1.0 ? 1.0 : 0.0, cosine = quarters == 1.0 ? 0.0 : -1.0;
        const double frequency = quarters * 0.5 * std::numbers::pi / (end - begin);
        piece.terms.push_back(
            {frequency, term.sine * cosine - term.cosine * sine, -term.sine * sine - term.cosine * cosine});
    }
    return piece;
}

/// Coefficients of the quintic with y(0) = 0, y(1) = 1 and these derivatives there.
std::vector<double> quintic(double v0, double a0, double v1, double a1) {
    return {0.0,
            v0,
            0.5 * a0,
            10.0 - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
            -15.0 + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
            6.0 - 3.0 * v0 - 3.0 * v1 - 0.5 * a0 + 0.5 * a1};
}

}  // namespace

std::vector<AccelerationPiece> scca_pieces(const SccaParts& parts) {
    const double to_constant = parts.sine, to_cosine = parts.sine + parts.constant;
    const bool one_wave = parts.constant == 0.0 && parts.sine == parts.cosine && parts.sine > 0.0;
    if (one_wave && parts.coast == 0.0) return {{0.0, 1.0, 0.0, {{2.0 * std::numbers::pi, 1.0, 0.0}}}};
    const double to_coast = parts.coast > 0.0 ? 0.5 - parts.coast : 0.5;
    std::vector<AccelerationPiece> pieces;
    if (one_wave) {
        pieces.push_back(half_sine(0.0, to_coast, 1.0));
    } else {
        if (parts.sine > 0.0) pieces.push_back(quarter_sine_up(0.0, to_constant, 1.0));
        if (parts.constant > 0.0)
            pieces.push_back(constant_piece(to_constant, parts.cosine > 0.0 ? to_cosine : to_coast, 1.0));
        if (parts.cosine > 0.0 && parts.coast > 0.0)
            pieces.push_back(quarter_cosine_down(to_cosine, to_coast, 1.0));
    }
    const std::size_t own = pieces.size();
    if (parts.coast > 0.0)
        pieces.push_back(zero_piece(to_coast, 1.0 - to_coast));
    else if (parts.cosine > 0.0)
        pieces.push_back(half_cosine(to_cosine, 1.0 - to_cosine, 1.0));
    for (std::size_t i = own; i-- > 0;) {
        const double begin = pieces.back().end, end = i == 0 ? 1.0 : 1.0 - pieces[i].begin;
        pieces.push_back(mirrored(begin, end, pieces[i]));
    }
    return pieces;
}

int scca_continuity(const SccaParts& parts) {
    return parts.sine > 0.0 && parts.cosine > 0.0 ? 2 : 1;
}

std::vector<AccelerationPiece> ramped_pieces(const RampedParts& parts) {
    std::vector<AccelerationPiece> pieces;
    const auto add = [&](double begin, double end, double height) {
        const double ramp = parts.ramp * (end - begin);
        const double middle = 0.5 * (begin + end);
        const double up = parts.ramp < 0.5 ? begin + ramp : middle,
                     down = parts.ramp < 0.5 ? end - ramp : middle;
        if (parts.ramp > 0.0) pieces.push_back(ramp_piece(begin, up, 0.0, height));
        if (parts.ramp < 0.5) pieces.push_back(constant_piece(up, down, height));
        if (parts.ramp > 0.0) pieces.push_back(ramp_piece(down, end, height, 0.0));
    };
    const double fast = parts.acceleration;  // from there to `slowing` the velocity is constant
    const double slowing = parts.coast > 0.0 ? fast + parts.coast : fast;
    add(0.0, fast, 1.0);
    if (parts.coast > 0.0) pieces.push_back(zero_piece(fast, slowing));
    add(slowing, 1.0, -fast / (1.0 - slowing));
    return pieces;
}

std::vector<AccelerationPiece> one_dwell_sine_pieces(double ta) {
    if (ta == widest_one_dwell_sine) {
        const double zero = 2.0 - std::numbers::sqrt2;
        return {half_sine(0.0, zero, 1.0), quarter_sine_up(zero, 1.0, -std::numbers::sqrt2)};
    }
    const double zero = 1.0 / (2.0 - ta), deceleration = 1.0 / (1.0 - ta);
    return {quarter_sine_up(0.0, ta, 1.0), quarter_cosine_down(ta, zero, 1.0),
            quarter_sine_up(zero, 1.0, -deceleration)};
}

std::vector<AccelerationPiece> one_dwell_trapezoid_pieces(double ta) {
    // A width within the narrowest piece of the maximum is set to the maximum.
    const bool flat = widest_one_dwell_trapezoid - ta >= kNarrowestPiece;
    if (!flat) ta = widest_one_dwell_trapezoid;
    const double zero = flat ? 0.5 + ta * (0.5 - 1.0 / std::numbers::pi) : 2.0 * ta;
    const double ramp = flat ? zero - ta : ta;
    std::vector<AccelerationPiece> pieces{quarter_sine_up(0.0, ta, 1.0)};
    if (flat) pieces.push_back(constant_piece(ta, ramp, 1.0));
    pieces.push_back(half_cosine(ramp, zero + ta, 1.0));
    pieces.push_back(constant_piece(zero + ta, 1.0, -1.0));
    return pieces;
}

EndPolynomial polynomial_between(const EndStates& ends) {
    const double v0 = ends.start_velocity, v1 = ends.end_velocity;
    // A free acceleration is the one that makes the highest coefficient vanish.
    double a0 = 0.0, a1 = 0.0;
    if (ends.start_acceleration && ends.end_acceleration) {
        a0 = *ends.start_acceleration;
        a1 = *ends.end_acceleration;
    } else if (ends.start_acceleration) {
        a0 = *ends.start_acceleration;
        a1 = -12.0 + 6.0 * v0 + 6.0 * v1 + a0;
    } else if (ends.end_acceleration) {
        a1 = *ends.end_acceleration;
        a0 = 12.0 - 6.0 * v0 - 6.0 * v1 + a1;
    } else {
        a0 = 6.0 - 4.0 * v0 - 2.0 * v1;
        a1 = -6.0 + 2.0 * v0 + 4.0 * v1;
    }
    EndPolynomial found{quintic(v0, a0, v1, a1), quintic(v1, -a1, v0, -a0)};
    for (double& coefficient : found.from_top) coefficient = -coefficient;
    found.from_top[0] += 1.0;
    return found;
}

}  // namespace camopt

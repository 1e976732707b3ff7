// SPDX-License-Identifier: MIT
#include "motions/laws/law.hpp"

#include "core/errors.hpp"
#include "motions/laws/law_peaks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace camopt {

namespace {

/// Tolerance of x outside [0, 1]: some roundings of a cam angle divided by a rise angle.
constexpr double end_rounding = 1e-12;

}  // namespace

Law::Law(LawInfo info) : info_(std::move(info)) {}

LawDerivatives Law::derivatives(double x, Side side) const {
    if (!(x >= -end_rounding && x <= 1.0 + end_rounding)) {
        throw InputError(fmt::format("{}: x = {} found, allowed 0 <= x <= 1", info_.key, x));
    }
    return evaluate(std::clamp(x, 0.0, 1.0), side);
}

MotionPoint Law::at(double x, Side side) const {
    const LawDerivatives value = derivatives(x, side);
    return {x, {value[0], value[1], value[2], value[3]}};
}

Peaks Law::peaks() const {
    return find_peaks(*this);
}

JerkExtrema Law::jerk_extrema() const {
    return find_jerk_extrema(*this);
}

}  // namespace camopt

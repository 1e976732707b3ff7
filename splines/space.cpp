// SPDX-License-Identifier: MIT
#include "splines/space.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {
// Points computed from angles may exceed the ends by a few units in the last place.
constexpr double overshoot = 1e-12;
}  // namespace

SplineSpace::SplineSpace(int degree, int continuity, std::vector<double> breakpoints)
    : degree_(degree), continuity_(continuity), breakpoints_(std::move(breakpoints)) {
    if (degree < 1) throw InputError(fmt::format("degree: found {}; allowed: 1 or more", degree));
    if (continuity < 0 || continuity >= degree) {
        throw InputError(fmt::format("continuity: found {}; allowed: 0 … {}", continuity, degree - 1));
    }
    if (breakpoints_.size() < 2) {
        throw InputError(fmt::format("breakpoints: found {}; allowed: at least 2", breakpoints_.size()));
    }
    for (std::size_t i = 1; i < breakpoints_.size(); ++i) {
        if (!(breakpoints_[i] > breakpoints_[i - 1]) || !std::isfinite(breakpoints_[i])) {
            throw InputError(fmt::format("breakpoints[{}]: found {} after {}; allowed: ascending", i,
                                         breakpoints_[i], breakpoints_[i - 1]));
        }
    }
}

SplineSpace SplineSpace::uniform(int degree, int continuity, int segments, double length) {
    if (segments < 1) throw InputError(fmt::format("segments: found {}; allowed: 1 or more", segments));
    std::vector<double> breakpoints(segments + 1);
    for (int i = 0; i <= segments; ++i) breakpoints[i] = length * i / segments;
    return {degree, continuity, std::move(breakpoints)};
}

double SplineSpace::knot(int index) const {
    if (index <= degree_) return begin();
    const int breakpoint = (index - degree_ - 1) / (degree_ - continuity_) + 1;
    return breakpoint < segments() ? breakpoints_[breakpoint] : end();
}

std::vector<double> SplineSpace::knots() const {
    std::vector<double> knots(dimension() + degree_ + 1);
    for (std::size_t k = 0; k < knots.size(); ++k) knots[k] = knot(static_cast<int>(k));
    return knots;
}

int SplineSpace::segment_of(double x, Side side) const {
    const double slack = overshoot * std::max(1.0, end() - begin());
    if (!(x >= begin() - slack && x <= end() + slack)) {
        throw InputError(fmt::format("x: found {}; allowed: {} … {}", x, begin(), end()));
    }
    const auto after = side == Side::right ? std::upper_bound(breakpoints_.begin(), breakpoints_.end(), x)
                                           : std::lower_bound(breakpoints_.begin(), breakpoints_.end(), x);
    return std::clamp(static_cast<int>(after - breakpoints_.begin()) - 1, 0, segments() - 1);
}

bool SplineSpace::is_symmetric() const {
    const int n = segments();
    for (int i = 0; i <= n / 2; ++i) {
        const double defect = (breakpoints_[i] - begin()) - (end() - breakpoints_[n - i]);
        if (std::abs(defect) > overshoot * (end() - begin())) return false;
    }
    return true;
}

}  // namespace camopt

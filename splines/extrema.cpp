// SPDX-License-Identifier: MIT
#include "splines/extrema.hpp"

#include "core/numbers/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// An optimum reaches its peaks at many locations, each to the tolerance of a solve, some 1e-9 of the peak;
// values this close are the same peak, and their order in the last digits is meaningless.
constexpr double same_peak = 1e-8;

double mean_square(const SplineCurve& curve, int order) {
    double integral = 0.0;
    for (int i = 0; i < curve.segments(); ++i) {
        const Eigen::VectorXd part = curve.derivative_polynomial(i, order);
        const Eigen::VectorXd square = product(part, part);
        double power = 1.0;
        for (Eigen::Index m = 0; m < square.size(); ++m) {
            power *= curve.space().width(i);
            integral += square[m] * power / static_cast<double>(m + 1);
        }
    }
    return integral / (curve.end() - curve.begin());
}

}  // namespace

void add_candidates_on_segment(const SplineSpace& space, int segment, const Eigen::VectorXd& polynomial,
                               std::vector<Extremum>& all) {
    const double origin = space.breakpoints()[segment];
    const double width = space.width(segment);
    all.push_back({polynomial[0], origin, Side::right});
    const auto add = [&](double t) {
        all.push_back({evaluate_polynomial(polynomial, t), origin + t, Side::right});
    };
    if (polynomial.size() == 3) {  // a parabola, as most are: the sign change of its slope
        const double at_begin = polynomial[1], bend = 2.0 * polynomial[2];
        if (at_begin * (bend * width + at_begin) < 0.0) add(std::clamp(-at_begin / bend, 0.0, width));
    } else if (polynomial.size() > 3) {
        for (const double t : sign_changes(differentiated(polynomial), 0.0, width)) add(t);
    }
    all.push_back({evaluate_polynomial(polynomial, width), space.breakpoints()[segment + 1], Side::left});
}

namespace {

/// Of functions one by one, in the order of their segments.
class LargestMagnitude {
 public:
    explicit LargestMagnitude(const SplineSpace& space) : space_(space) {}

    void add(int segment, const Eigen::VectorXd& polynomial) {
        candidates_.clear();
        add_candidates_on_segment(space_, segment, polynomial, candidates_);
        for (const Extremum& candidate : candidates_)
            add({std::abs(candidate.value), candidate.at, candidate.side});
    }

    /// The largest value, at the first location within `same_peak` of it.
    [[nodiscard]] Extremum largest() const {
        Extremum largest = records_.back();
        const auto first = std::ranges::find_if(records_, [&](const Extremum& record) {
            return record.value >= largest.value - same_peak * largest.value;
        });
        if (first != records_.end()) largest = {largest.value, first->at, first->side};  // else: NaN
        return largest;
    }

 private:
    void add(const Extremum& place) {
        if (records_.empty()) {
            records_.push_back(place);
        } else if (place.value > records_.back().value) {
            if (!climbing_) records_.push_back(place);
            records_.back() = place;
            climbing_ = true;
        } else {
            climbing_ = climbing_ && place.at == records_.back().at;  // the other side of the same breakpoint
        }
    }

    const SplineSpace& space_;
    std::vector<Extremum> records_;  ///< local maxima, each above all before it
    bool climbing_ = true;           ///< whether the ascent to the last of them may continue
    std::vector<Extremum> candidates_;
};

}  // namespace

Extremum largest_magnitude(const SplineSpace& space, const SegmentFunction& function) {
    LargestMagnitude largest(space);
    for (int i = 0; i < space.segments(); ++i) largest.add(i, function(i));
    return largest.largest();
}

Extremum peak_of(const SplineCurve& curve, int order) {
    LargestMagnitude largest(curve.space());
    Eigen::VectorXd polynomial(std::max(1, curve.degree() + 1 - order));
    for (int i = 0; i < curve.segments(); ++i) {
        curve.derivative_polynomial(i, order, polynomial);
        largest.add(i, polynomial);
    }
    return largest.largest();
}

double mean_of(const SplineCurve& curve, int order) {
    return std::sqrt(mean_square(curve, order));
}

Extremum torque_peak_of(const SplineCurve& curve) {
    return largest_magnitude(curve.space(), [&](int segment) {
        return product(curve.derivative_polynomial(segment, 1), curve.derivative_polynomial(segment, 2));
    });
}

Peaks peaks_of(const SplineCurve& curve) {
    Peaks peaks;
    for (int order = 1; order <= 3; ++order) {
        derivative_peak(peaks, order) = peak_of(curve, order);
        derivative_mean(peaks, order) = mean_of(curve, order);
    }
    peaks.torque = torque_peak_of(curve);
    return peaks;
}

}  // namespace camopt

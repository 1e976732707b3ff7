// SPDX-License-Identifier: MIT
#include "splines/curve.hpp"

#include "core/errors.hpp"
#include "core/numbers/polynomial.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {
// Points computed from angles may exceed the ends by a few units in the last place.
constexpr double overshoot = 1e-12;

/// Local knots u_{1} … u_{2p} around a segment, measured from its left end: the B-splines on the segment
/// depend on no others.
Eigen::VectorXd local_knots(const SplineSpace& space, int segment) {
    const int p = space.degree();
    const int first = space.first_basis_function(segment);
    const double origin = space.breakpoints()[segment];
    Eigen::VectorXd local(2 * p);
    for (int k = 0; k < 2 * p; ++k) local[k] = space.knot(first + 1 + k) - origin;
    return local;
}

/// Amplification of a piece's round-off in a control point: coefficients of t^m are accurate to 1/h^m of
/// their last digit.
double growth(const Eigen::RowVectorXd& weights, double width) {
    double sum = 0.0, power = 1.0;
    for (Eigen::Index m = 0; m < weights.size(); ++m, power /= width) sum += std::abs(weights[m]) * power;
    return sum;
}

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

/// Of functions one by one, in the order of their segments.
class LargestMagnitude {
 public:
    explicit LargestMagnitude(const SplineSpace& space) : space_(space) {}

    void add(int segment, const Eigen::VectorXd& polynomial) {
        candidates_.clear();
        const std::vector<double>& breakpoints = space_.breakpoints();
        add_candidates(breakpoints[segment], breakpoints[segment + 1], polynomial, candidates_);
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

SplineSpace::SplineSpace(int degree, int continuity, std::vector<double> breakpoints)
    : degree_(degree), continuity_(continuity), breakpoints_(std::move(breakpoints)) {
    if (degree < 1) throw InputError(fmt::format("degree: found {}; allowed: 1 or more", degree));
    if (continuity < 0 || continuity >= degree)
        throw InputError(fmt::format("continuity: found {}; allowed: 0 … {}", continuity, degree - 1));
    if (breakpoints_.size() < 2)
        throw InputError(fmt::format("breakpoints: found {}; allowed: at least 2", breakpoints_.size()));
    for (std::size_t i = 1; i < breakpoints_.size(); ++i) {
        if (!(breakpoints_[i] > breakpoints_[i - 1]) || !std::isfinite(breakpoints_[i]))
            throw InputError(fmt::format("breakpoints[{}]: found {} after {}; allowed: ascending", i,
                                         breakpoints_[i], breakpoints_[i - 1]));
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

std::size_t nearest_index(const std::vector<double>& ascending, double value) {
    const auto above = std::ranges::lower_bound(ascending, value);
    if (above == ascending.begin()) return 0;
    if (above == ascending.end()) return ascending.size() - 1;
    const bool below_is_nearer = value - *(above - 1) < *above - value;
    return static_cast<std::size_t>(above - ascending.begin()) - (below_is_nearer ? 1 : 0);
}

int SplineSpace::breakpoint_at(double x) const {
    return static_cast<int>(nearest_index(breakpoints_, x));
}

int SplineSpace::segment_of(double x, Side side) const {
    const double slack = overshoot * std::max(1.0, end() - begin());
    if (!(x >= begin() - slack && x <= end() + slack))
        throw InputError(fmt::format("x: found {}; allowed: {} … {}", x, begin(), end()));
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

Eigen::MatrixXd monomials_of_basis(const SplineSpace& space, int segment) {
    const int p = space.degree();
    const Eigen::VectorXd u = local_knots(space, segment);
    // Cox–de Boor on polynomials in t: row m of column j is the coefficient of t^m.
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(p + 1, p + 1);
    basis(0, 0) = 1.0;
    for (int d = 1; d <= p; ++d) {
        Eigen::MatrixXd raised = Eigen::MatrixXd::Zero(p + 1, p + 1);
        for (int j = 0; j < d; ++j) {
            // basis.col(j) of degree d − 1 spans from u_left to u_right in the next recurrence.
            const double left = u[p - d + j];
            const double right = u[p + j];
            const double span = right - left;
            for (int m = 0; m < d; ++m) {
                const double value = basis(m, j) / span;
                raised(m, j) += right * value;
                raised(m + 1, j) -= value;
                raised(m, j + 1) -= left * value;
                raised(m + 1, j + 1) += value;
            }
        }
        basis = raised;
    }
    return basis;
}

Eigen::RowVectorXd blossom_weights(const SplineSpace& space, int function, int segment) {
    const int p = space.degree();
    const Eigen::VectorXd u = local_knots(space, segment);
    const int offset = function - space.first_basis_function(segment);
    // Elementary symmetric sums of the p knots inside the support of the function.
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(p + 1);
    sums[0] = 1.0;
    for (int k = 0; k < p; ++k) {
        for (int m = std::min(k + 1, p); m >= 1; --m) sums[m] += u[offset + k] * sums[m - 1];
    }
    Eigen::RowVectorXd weights(p + 1);
    double binomial = 1.0;
    for (int m = 0; m <= p; ++m) {
        weights[m] = sums[m] / binomial;
        binomial = binomial * (p - m) / (m + 1);
    }
    return weights;
}

SplineCurve::SplineCurve(SplineSpace space, Eigen::MatrixXd pieces)
    : space_(std::move(space)), pieces_(std::move(pieces)) {
    if (pieces_.rows() != degree() + 1 || pieces_.cols() != space_.segments())
        throw InputError(fmt::format("pieces: found {} x {}; allowed: {} x {}", pieces_.rows(),
                                     pieces_.cols(), degree() + 1, space_.segments()));
    if (!pieces_.allFinite()) throw InputError("pieces: found a value that is not finite");
}

SplineCurve SplineCurve::from_coefficients(const SplineSpace& space, const Eigen::VectorXd& coefficients) {
    if (coefficients.size() != space.dimension())
        throw InputError(
            fmt::format("coefficients: found {}; allowed: {}", coefficients.size(), space.dimension()));
    const int p = space.degree();
    Eigen::MatrixXd pieces(p + 1, space.segments());
    for (int i = 0; i < space.segments(); ++i)
        pieces.col(i) =
            monomials_of_basis(space, i) * coefficients.segment(space.first_basis_function(i), p + 1);
    return {space, std::move(pieces)};
}

MotionPoint SplineCurve::at(double x, Side side) const {
    const int segment = space_.segment_of(x, side);
    const double t = x - space_.breakpoints()[segment];
    MotionPoint point{x, {}};
    const Eigen::Index size = pieces_.rows();
    const double* const piece = pieces_.col(segment).data();
    for (Eigen::Index order = 0; order < 4; ++order) {
        double value = 0.0;
        for (Eigen::Index m = size - 1; m >= order; --m) {
            double coefficient = piece[m];
            for (Eigen::Index r = 0; r < order; ++r) coefficient *= static_cast<double>(m - r);
            value = value * t + coefficient;
        }
        point.derivative[static_cast<std::size_t>(order)] = value;
    }
    return point;
}

double SplineCurve::derivative(double x, int order, Side side) const {
    const int segment = space_.segment_of(x, side);
    return evaluate_polynomial(derivative_polynomial(segment, order), x - space_.breakpoints()[segment]);
}

Eigen::VectorXd SplineCurve::derivative_polynomial(int segment, int order) const {
    return differentiated(pieces_.col(segment), order);
}

Eigen::VectorXd SplineCurve::coefficients() const {
    const int p = degree();
    const int step = p - continuity();
    Eigen::VectorXd result(space_.dimension());
    for (int j = 0; j < result.size(); ++j) {
        // Any segment of the support gives the same number, but not the same round-off: seen from a narrow
        // one the knots of the others are distant.
        const int last = std::min(j / step, space_.segments() - 1);
        const int first = j <= p ? 0 : (j - p + step - 1) / step;
        double least = std::numeric_limits<double>::infinity();
        for (int i = first; i <= last; ++i) {
            const Eigen::RowVectorXd weights = blossom_weights(space_, j, i);
            const double grown = growth(weights, space_.width(i));
            if (!(grown < least)) continue;
            least = grown;
            result[j] = weights * pieces_.col(i);
        }
    }
    return result;
}

namespace {

/// T_d^(r)(1) (2 / h)^r = Π_{k < r} (d² − k²) / (2 k + 1) · 2 / h.
double markov_factor(int degree, int order, double width) {
    double factor = 1.0;
    for (int k = 0; k < order; ++k) factor *= (degree * degree - k * k) / (2.0 * k + 1.0) * 2.0 / width;
    return factor;
}

}  // namespace

Eigen::MatrixXd derivative_bounds(const SplineSpace& space, const KnownBounds& known) {
    const int p = space.degree();
    const double length = space.end() - space.begin();
    std::array<double, 4> sup = known.sup;
    for (int r = 3; r >= 1; --r) {
        // Integrating from both ends, the worst point is where the two estimates are equal.
        const double ends = 0.5 * (std::abs(known.begin_state[r - 1]) + std::abs(known.end_state[r - 1]));
        const double farther = std::max(std::abs(known.begin_state[r - 1]), std::abs(known.end_state[r - 1]));
        sup[r - 1] = std::min({sup[r - 1], ends + 0.5 * length * sup[r], farther + length * known.rms[r]});
    }
    Eigen::MatrixXd bounds(p + 1, space.segments());
    for (int i = 0; i < space.segments(); ++i)
        for (int m = 0; m <= p; ++m) {
            double least = m <= 3 ? sup[m] : infinity;
            for (int r = 0; r < m; ++r)
                least = std::min(least, bounds(r, i) * markov_factor(p - r, m - r, space.width(i)));
            bounds(m, i) = least;
        }
    return bounds;
}

void add_candidates(double begin, double end, const Eigen::VectorXd& polynomial, std::vector<Extremum>& all) {
    const double width = end - begin;
    all.push_back({polynomial[0], begin, Side::right});
    const auto add = [&](double t) {
        all.push_back({evaluate_polynomial(polynomial, t), begin + t, Side::right});
    };
    if (polynomial.size() == 3) {  // a parabola, as most are: the sign change of its slope
        const double at_begin = polynomial[1], bend = 2.0 * polynomial[2];
        if (at_begin * (bend * width + at_begin) < 0.0) add(std::clamp(-at_begin / bend, 0.0, width));
    } else if (polynomial.size() > 3) {
        for (const double t : sign_changes(differentiated(polynomial), 0.0, width)) add(t);
    }
    all.push_back({evaluate_polynomial(polynomial, width), end, Side::left});
}

Extremum largest_magnitude(const SplineSpace& space, const SegmentFunction& function) {
    LargestMagnitude largest(space);
    for (int i = 0; i < space.segments(); ++i) largest.add(i, function(i));
    return largest.largest();
}

Extremum peak_of(const SplineCurve& curve, int order) {
    LargestMagnitude largest(curve.space());
    Eigen::VectorXd polynomial(std::max(1, curve.degree() + 1 - order));
    for (int i = 0; i < curve.segments(); ++i) {
        differentiate(curve.pieces().col(i), order, polynomial);
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

// SPDX-License-Identifier: MIT
#include "splines/fitted_curve.hpp"

#include "core/errors.hpp"

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int degree = 5, continuity = 4;
constexpr std::size_t least_rows = 12;  // on a stretch: twice the numbers of one segment
constexpr double first_segments = 2.0, more_segments = 1.5, rows_of_one = 2.5;
constexpr int most_segments = 4096, most_between_breaks = 24;  // rows between breaks are exact
constexpr int around =
    40;  // mean segments beyond either end of a periodic curve: what lies there fades by 2 each
constexpr int refinements = 2, error_samples = 120;

/// A stretch without breaks: its rows, and breakpoints that it must have.
struct Stretch {
    std::vector<double> x, y, joints;
    double begin = 0.0, end = 0.0;  ///< of the curve: rows beyond are those of its neighbouring turns
    [[nodiscard]] std::size_t own_rows() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(x, [&](double at) { return at >= begin && at < end; }));
    }
};

/// Between the joints segments that hold as many rows each, about `wanted`.
std::vector<double> breakpoints_of(const std::vector<double>& joints, const std::vector<double>& x,
                                   double wanted) {
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const auto first = std::ranges::lower_bound(x, joints[i]) - x.begin(),
                   last = std::ranges::lower_bound(x, joints[i + 1]) - x.begin();
        const auto rows = static_cast<double>(last - first);
        const int count = std::max(1, static_cast<int>(std::floor(rows / wanted)));
        all.push_back(joints[i]);
        for (int k = 1; k < count; ++k) {
            const auto row =
                static_cast<std::size_t>(first) + static_cast<std::size_t>(std::lround(rows * k / count));
            all.push_back(0.5 * (x[row - 1] + x[row]));
        }
    }
    all.push_back(joints.back());
    return all;
}

/// The spline of one set of breakpoints.
class LeastSquares {
 public:
    LeastSquares(const Stretch& stretch, std::vector<double> breakpoints)
        : stretch_(stretch), space_(degree, continuity, std::move(breakpoints)) {
        for (int i = 0; i < space_.segments(); ++i) bases_.push_back(monomials_of_basis(space_, i));
        std::vector<Eigen::Triplet<double>> entries;
        for (const double x : stretch.x) {
            const Values row = values_at(x, 0);
            for (int a = 0; a <= degree; ++a)
                for (int b = 0; b <= degree; ++b)
                    entries.emplace_back(row.first + a, row.first + b, row.weights[a] * row.weights[b]);
        }
        Eigen::SparseMatrix<double> normal(space_.dimension(), space_.dimension());
        normal.setFromTriplets(entries.begin(), entries.end());
        factor_.compute(normal);
        if (factor_.info() != Eigen::Success) return;
        coefficients_ = Eigen::VectorXd::Zero(space_.dimension());
        for (int i = 0; i <= refinements; ++i) coefficients_ += factor_.solve(back_projected());
    }

    [[nodiscard]] bool solved() const { return coefficients_.size() > 0 && coefficients_.allFinite(); }
    [[nodiscard]] double squares() const {
        double sum = 0.0;
        for (std::size_t k = 0; k < stretch_.x.size(); ++k)
            if (stretch_.x[k] >= stretch_.begin && stretch_.x[k] < stretch_.end)
                sum += std::pow(residual(k), 2);
        return sum;
    }
    [[nodiscard]] SplineCurve curve() const { return SplineCurve::from_coefficients(space_, coefficients_); }
    /// Mean of the variances of a derivative along the curve where that of a row is 1.
    [[nodiscard]] double mean_variance(int order) const {
        double sum = 0.0;
        for (int k = 0; k < error_samples; ++k) {
            const double x = stretch_.begin + (stretch_.end - stretch_.begin) * (k + 0.5) / error_samples;
            const Values row = values_at(x, order);
            Eigen::VectorXd unit = Eigen::VectorXd::Zero(space_.dimension());
            for (int a = 0; a <= degree; ++a) unit[row.first + a] = row.weights[a];
            sum += unit.dot(factor_.solve(unit));
        }
        return sum / error_samples;
    }

 private:
    struct Values {
        int first = 0;
        std::array<double, degree + 1> weights{};
    };

    const Stretch& stretch_;
    SplineSpace space_;
    std::vector<Eigen::MatrixXd> bases_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    Eigen::VectorXd coefficients_;

    /// Of the B-splines that are not 0 at x, a derivative.
    [[nodiscard]] Values values_at(double x, int order) const {
        const int segment = space_.segment_of(x);
        const double t = x - space_.breakpoints()[static_cast<std::size_t>(segment)];
        Eigen::RowVectorXd powers = Eigen::RowVectorXd::Zero(degree + 1);
        double power = 1.0;
        for (int m = order; m <= degree; ++m, power *= t) {
            powers[m] = power;
            for (int r = 0; r < order; ++r) powers[m] *= m - r;
        }
        const Eigen::RowVectorXd weights = powers * bases_[static_cast<std::size_t>(segment)];
        Values values{space_.first_basis_function(segment)};
        std::copy_n(weights.data(), degree + 1, values.weights.begin());
        return values;
    }
    [[nodiscard]] double residual(std::size_t k) const {
        const Values row = values_at(stretch_.x[k], 0);
        double off = stretch_.y[k];
        for (int a = 0; a <= degree; ++a) off -= row.weights[a] * coefficients_[row.first + a];
        return off;
    }
    [[nodiscard]] Eigen::VectorXd back_projected() const {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(space_.dimension());
        for (std::size_t k = 0; k < stretch_.x.size(); ++k) {
            const Values row = values_at(stretch_.x[k], 0);
            const double off = residual(k);
            for (int a = 0; a <= degree; ++a) sum[row.first + a] += row.weights[a] * off;
        }
        return sum;
    }
};

/// With the rows of so many turns before and after.
Stretch repeated(const Stretch& once, int turns, double advance) {
    Stretch all = once;
    const double length = once.end - once.begin;
    all.x.clear();
    all.y.clear();
    for (int turn = -turns; turn <= turns; ++turn)
        for (std::size_t k = 0; k < once.x.size(); ++k) {
            if (once.x[k] >= once.end) continue;  // the first one again
            all.x.push_back(once.x[k] + turn * length);
            all.y.push_back(once.y[k] + turn * advance);
        }
    return all;
}

std::vector<double> repeated(const std::vector<double>& breakpoints, int turns) {
    const double length = breakpoints.back() - breakpoints.front();
    std::vector<double> all;
    for (int turn = -turns; turn <= turns; ++turn)
        for (std::size_t k = 0; k + 1 < breakpoints.size(); ++k)
            all.push_back(breakpoints[k] + turn * length);
    all.push_back(breakpoints.back() + turns * length);
    return all;
}

/// Where no row is for long, no motion is known.
void require_no_gap(const Stretch& once, bool periodic) {
    constexpr double widest_gap = 0.2;  // of the stretch
    const double length = once.end - once.begin;
    double last = periodic ? once.x.back() - length : once.joints.front();
    std::vector<double> places = once.x;
    if (!periodic) places.push_back(once.joints.back());
    for (const double x : places) {
        if (x - last > widest_gap * length)
            throw InputError(
                fmt::format("a given motion: found no row on {:.3g} % of a stretch of it; allowed: rows at "
                            "most {:g} % apart",
                            100.0 * (x - last) / length, 100.0 * widest_gap));
        last = x;
    }
}

struct Found {
    SplineCurve curve;
    double squares = 0.0;
    int freedom = 0;
    std::array<double, 4> variance{};
};

/// Numbers of segments that are tried.
std::vector<double> tried_segments(double most) {
    std::vector<double> tried;
    double segments = first_segments;
    while (segments <= most) {
        tried.push_back(segments);
        segments *= more_segments;
    }
    return tried;
}

Found fitted(const Stretch& once, bool periodic, double advance, double most) {
    const std::size_t count = once.own_rows();
    const auto rows = static_cast<double>(count);
    if (count < least_rows)
        throw InputError(fmt::format("a given motion: found {} rows on a stretch of it; allowed: at least {}",
                                     count, least_rows));
    require_no_gap(once, periodic);
    std::unique_ptr<LeastSquares> best;
    std::unique_ptr<Stretch> best_rows;
    double least = infinity;
    int freedom = 0;
    for (const double segments : tried_segments(most)) {
        const double wanted = rows / segments;
        std::vector<double> breakpoints = breakpoints_of(once.joints, once.x, wanted);
        const int own = static_cast<int>(breakpoints.size()) - 1;
        const int numbers = periodic ? own : own + degree;
        if (wanted < rows_of_one || numbers >= rows) break;
        const int turns = periodic ? (around + own - 1) / own : 0;
        auto tried = std::make_unique<Stretch>(periodic ? repeated(once, turns, advance) : once);
        if (periodic) breakpoints = repeated(breakpoints, turns);
        auto fit = std::make_unique<LeastSquares>(*tried, std::move(breakpoints));
        if (!fit->solved()) continue;
        const double validation = fit->squares() / std::pow(rows - numbers, 2);
        if (!(validation < least)) continue;
        least = validation;
        freedom = numbers;
        best = std::move(fit);
        best_rows = std::move(tried);
    }
    if (!best)
        throw InputError("a given motion: found stretches without rows; allowed: rows all along the motion");
    Found found{best->curve(), best->squares(), freedom};
    for (std::size_t order = 0; order < found.variance.size(); ++order)
        found.variance[order] = best->mean_variance(static_cast<int>(order));
    return found;
}

/// Columns of the segments between two breakpoints.
void add_pieces(const SplineCurve& curve, double begin, double end, std::vector<double>& breakpoints,
                std::vector<Eigen::VectorXd>& pieces) {
    const SplineSpace& space = curve.space();
    const int first = space.breakpoint_at(begin), last = space.breakpoint_at(end);
    if (breakpoints.empty()) breakpoints.push_back(begin);
    for (int i = first; i < last; ++i) {
        pieces.emplace_back(curve.pieces().col(i));
        breakpoints.push_back(i + 1 < last ? space.breakpoints()[static_cast<std::size_t>(i) + 1] : end);
    }
}

/// From one break to the next; of a periodic curve across its ends to those of the neighbouring turns.
Stretch stretch_between(const CurveRows& rows, double begin, double end) {
    const double first = rows.joints.front(), last = rows.joints.back(), length = last - first;
    const bool across = rows.periodic && !rows.breaks.empty();
    const double from = across && begin == first ? rows.breaks.back() - length : begin,
                 to = across && end == last ? rows.breaks.front() + length : end;
    const double same = 1e-9 * length, slack = 1e-12 * length;
    Stretch stretch{{}, {}, {from}, begin, end};
    std::vector<double> joints = rows.joints;
    if (across) joints = {first, last};
    for (const double joint : rows.joints)
        if (joint > std::max(from, first) + same && joint < std::min(to, last) - same && joint != first)
            joints.push_back(joint);
    std::ranges::sort(joints);
    for (const double joint : joints)
        if (joint > stretch.joints.back() + same && joint < to - same) stretch.joints.push_back(joint);
    stretch.joints.push_back(to);
    for (const int turn : {-1, 0, 1}) {
        if (turn != 0 && !across) continue;
        for (std::size_t k = 0; k < rows.x.size(); ++k) {
            const double x = rows.x[k] + turn * length;
            if (x < from - slack || x > to + slack || (across && rows.x[k] >= last)) continue;
            stretch.x.push_back(std::clamp(x, from, to));
            stretch.y.push_back(rows.y[k] + turn * rows.advance);
        }
    }
    return stretch;
}

}  // namespace

FittedCurve fitted_curve(const CurveRows& rows) {
    const double begin = rows.joints.front(), end = rows.joints.back(), length = end - begin;
    std::vector<double> ends = rows.breaks;
    ends.insert(ends.begin(), begin);
    ends.push_back(end);
    const bool around_end = rows.periodic && rows.breaks.empty();
    std::vector<double> breakpoints;
    std::vector<Eigen::VectorXd> pieces;
    double squares = 0.0;
    std::array<double, 4> variance{};
    FittedCurve result{SplineCurve(SplineSpace(1, 0, {0.0, 1.0}), Eigen::MatrixXd::Zero(2, 1))};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Stretch stretch = stretch_between(rows, ends[i], ends[i + 1]);
        const Found found = fitted(stretch, around_end, rows.advance,
                                   rows.breaks.empty() ? most_segments : most_between_breaks);
        add_pieces(found.curve, ends[i], ends[i + 1], breakpoints, pieces);
        squares += found.squares;
        result.freedom += found.freedom;
        result.rows += static_cast<int>(stretch.own_rows());
        const double share = (ends[i + 1] - ends[i]) / length;
        for (std::size_t order = 0; order < variance.size(); ++order)
            variance[order] += share * found.variance[order];
    }
    Eigen::MatrixXd all(degree + 1, static_cast<Eigen::Index>(pieces.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = pieces[i];
    const int joined = rows.breaks.empty() ? continuity : 0;  // what more it is, no coefficient must rely on
    result.curve = SplineCurve(SplineSpace(degree, joined, std::move(breakpoints)), std::move(all));
    const double variance_of_row = squares / std::max(1, result.rows - result.freedom);
    result.noise = std::sqrt(variance_of_row);
    for (std::size_t order = 0; order < variance.size(); ++order)
        result.error[order] = std::sqrt(variance_of_row * variance[order]);
    return result;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "core/numbers/robust_fit.hpp"

#include <Eigen/Cholesky>

namespace camopt {

const double local_width = std::numbers::pi / 30.0;

namespace {

constexpr double normal_mad = 1.4826;  // standard deviation over median of magnitudes, normal errors
constexpr std::ptrdiff_t least_side = 4, most_side = 80;  // rows on either side
constexpr int absolute_steps = 4, reweightings = 8;       // first least |off|, then the biweight

/// The neighbours of one row, in units of their width.
class Neighbours {
 public:
    Neighbours(std::span<const double> at, std::span<const double> values, double period, double width,
               std::size_t row)
        : at_(at), values_(values), period_(period), reach_(width), row_(row) {
        for (const int side : {-1, 1}) add(side);
        for (const double x : x_) width_ = std::max(width_, std::abs(x));
    }

    [[nodiscard]] LocalFit fit() const {
        const LocalFit itself{values_[row_], 0.0, 0.0, 1.0};
        if (x_.size() < 2 * least_side) return itself;
        std::vector<double> weights(x_.size(), 1.0), off(x_.size());
        Eigen::Vector4d cubic;
        Eigen::Matrix4d normal;
        for (int i = 0; i <= reweightings; ++i) {
            normal.setZero();
            Eigen::Vector4d right = Eigen::Vector4d::Zero();
            for (std::size_t k = 0; k < x_.size(); ++k) {
                const Eigen::Vector4d powers = powers_at(k);
                normal += weights[k] * powers * powers.transpose();
                right += weights[k] * y_[k] * powers;
            }
            cubic = normal.ldlt().solve(right);
            for (std::size_t k = 0; k < x_.size(); ++k) off[k] = y_[k] - cubic.dot(powers_at(k));
            const double spread = spread_of(off, std::numeric_limits<double>::min());
            for (std::size_t k = 0; k < x_.size(); ++k) {
                const double u = std::abs(off[k]) / spread,
                             rest = std::max(0.0, 1.0 - std::pow(u / biweight, 2));
                weights[k] = i < absolute_steps ? 1.0 / (0.1 + u) : rest * rest;
            }
        }
        const double variance = normal.ldlt().solve(Eigen::Vector4d::Unit(0))[0];
        LocalFit found{values_[row_] + cubic[0], cubic[1] / width_, -cubic[0],
                       std::sqrt(1.0 + std::max(0.0, variance))};
        return std::isfinite(found.value + found.slope + found.error) ? found : itself;
    }

 private:
    std::span<const double> at_, values_;
    double period_, reach_;
    std::size_t row_;
    double width_ = 0.0;
    std::vector<double> x_, y_;  ///< from the row

    /// Rows before or after it: at an open end more of those on the other side.
    void add(int side) {
        const auto count = static_cast<std::ptrdiff_t>(at_.size()), row = static_cast<std::ptrdiff_t>(row_);
        const bool closed = period_ > 0.0;
        const std::ptrdiff_t beyond =
            closed ? least_side : std::min(least_side, side < 0 ? count - 1 - row : row);
        const std::ptrdiff_t most = std::min(most_side, closed     ? (count - 1) / 2
                                                        : side < 0 ? row
                                                                   : count - 1 - row);
        for (std::ptrdiff_t k = 1; k <= most; ++k) {
            const std::ptrdiff_t i = row + side * k, turns = i < 0 ? -1 : i < count ? 0 : 1;
            const auto from = static_cast<std::size_t>(i - turns * count);
            const double x = at_[from] + static_cast<double>(turns) * period_ - at_[row_];
            if (k > 2 * least_side - beyond && std::abs(x) > reach_) return;
            x_.push_back(x);
            y_.push_back(values_[from] - values_[row_]);
        }
    }
    [[nodiscard]] Eigen::Vector4d powers_at(std::size_t k) const {
        const double t = x_[k] / width_;
        return {1.0, t, t * t, t * t * t};
    }
};

/// Of what could be resolution or a jump of the second derivative, from the rows that are not suspected.
double least_deviation(std::span<const double> values, const std::vector<std::size_t>& suspected) {
    std::vector<double> bends;
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double change = std::abs(values[i] - values[i - 1]);
        if (change > 0.0) step = std::min(step, change);
        const auto near = [&](std::size_t row) { return row + 2 >= i && row <= i; };
        if (i > 1 && std::ranges::none_of(suspected, near))
            bends.push_back(std::abs(values[i] - 2.0 * values[i - 1] + values[i - 2]));
    }
    if (bends.empty()) return 0.0;
    const auto most = bends.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(bends.size()));
    std::ranges::nth_element(bends, most);
    return std::max(*most, std::isfinite(step) ? 1.5 * step : 0.0);
}

}  // namespace

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double spread_of(std::vector<double> values, double least) {
    for (double& value : values) value = std::abs(value);
    return std::max(normal_mad * median_of(std::move(values)), least);
}

std::vector<LocalFit> local_fits(std::span<const double> at, std::span<const double> values, double period,
                                 double width) {
    std::vector<LocalFit> fits;
    for (std::size_t i = 0; i < at.size(); ++i)
        fits.push_back(Neighbours(at, values, period, width, i).fit());
    return fits;
}

std::vector<LocalFit> closest_local_fits(std::span<const double> at, std::span<const double> values,
                                         double period) {
    constexpr int halvings = 6;
    std::vector<LocalFit> best;
    double least = std::numeric_limits<double>::infinity(), width = local_width;
    for (int i = 0; i <= halvings; ++i, width *= 0.5) {
        std::vector<LocalFit> fits = local_fits(at, values, period, width);
        std::vector<double> off;
        off.reserve(fits.size());
        for (const LocalFit& fit : fits) off.push_back(fit.off);
        const double most = outlying * spread_of(off);
        double squares = 0.0;
        for (const double one : off) squares += std::pow(std::min(std::abs(one), most), 2);
        if (!(squares < least)) break;
        least = squares;
        best = std::move(fits);
    }
    return best;
}

std::vector<std::size_t> outliers_of(std::span<const double> values, std::span<const LocalFit> fits) {
    std::vector<double> all;
    for (const LocalFit& fit : fits) all.push_back(fit.off / fit.error);
    const double spread = spread_of(all);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (std::abs(all[i]) <= outlying * spread) continue;
        constexpr std::size_t side = 2 * least_side;
        std::vector<double> around;
        for (std::size_t k = i - std::min(i, side); k < std::min(i + side + 1, all.size()); ++k)
            if (k != i) around.push_back(all[k]);
        if (std::abs(all[i]) > outlying * spread_of(std::move(around))) found.push_back(i);
    }
    const double least = least_deviation(values, found);
    std::erase_if(found, [&](std::size_t i) { return std::abs(all[i]) <= least; });
    return found;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A spline evaluated from its published form alone (knots, coefficients) by de Boor's algorithm, in long
// double and without any code of the library: what a user would write to check a result.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace camopt::testing_support {

class IndependentSpline {
 public:
    IndependentSpline(const std::vector<double>& knots, const Eigen::VectorXd& coefficients, int degree)
        : degree_(degree) {
        knots_[0].assign(knots.begin(), knots.end());
        control_[0].assign(coefficients.begin(), coefficients.end());
        for (int r = 1; r <= 3; ++r) differentiate(r);
    }

    /// The r-th derivative, r = 0 … 3, as seen from the right (from the left at the end).
    [[nodiscard]] long double derivative(long double x, int r) const {
        const auto& t = knots_[r];
        const auto& c = control_[r];
        const int p = degree_ - r;
        int k = p;
        while (k + 1 < static_cast<int>(c.size()) && t[k + 1] <= x) ++k;
        std::vector<long double> d(c.begin() + k - p, c.begin() + k + 1);
        for (int level = 1; level <= p; ++level) {
            for (int j = p; j >= level; --j) {
                const long double left = t[j + k - p];
                const long double width = t[j + 1 + k - level] - left;
                const long double alpha = width > 0 ? (x - left) / width : 0;
                d[j] = (1 - alpha) * d[j - 1] + alpha * d[j];
            }
        }
        return d[p];
    }

    /// Largest |y'|, |y''|, |y'''| on a dense grid that includes both sides of every knot.
    [[nodiscard]] std::array<double, 4> sampled_peaks(int samples) const {
        std::array<double, 4> peaks{};
        const long double begin = knots_[0].front();
        const long double end = knots_[0].back();
        const auto visit = [&](long double x) {
            for (int r = 1; r <= 3; ++r) {
                peaks[r] = std::max(peaks[r], static_cast<double>(std::abs(derivative(x, r))));
            }
        };
        for (int k = 0; k <= samples; ++k) visit(begin + (end - begin) * k / samples);
        for (const long double knot : knots_[0]) {
            visit(knot);
            visit(std::max(begin, knot - (end - begin) * 1e-12L));
        }
        return peaks;
    }

 private:
    void differentiate(int r) {
        const auto& t = knots_[r - 1];
        const auto& c = control_[r - 1];
        const int p = degree_ - r + 1;
        for (std::size_t j = 0; j + 1 < c.size(); ++j) {
            const long double width = t[j + p + 1] - t[j + 1];
            control_[r].push_back(width > 0 ? p * (c[j + 1] - c[j]) / width : 0);
        }
        knots_[r].assign(t.begin() + 1, t.end() - 1);
    }

    int degree_;
    std::array<std::vector<long double>, 4> knots_, control_;
};

}  // namespace camopt::testing_support

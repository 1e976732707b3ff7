// SPDX-License-Identifier: MIT
#include "objectives/grid/curve_bounds.hpp"

#include "core/numbers/extremum.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

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
    for (int i = 0; i < space.segments(); ++i) {
        double below = infinity;
        for (int m = 0; m <= p; ++m) {
            const double markov = 2.0 * (p - m + 1) * (p - m + 1) / space.width(i) * below;
            below = std::min(m <= 3 ? sup[m] : infinity, m > 0 ? markov : infinity);
            bounds(m, i) = below;
        }
    }
    return bounds;
}

}  // namespace camopt

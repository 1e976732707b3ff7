// SPDX-License-Identifier: MIT
// Eight decades of stiffness and damping from none to twice critical, against the closed form in more digits:
// the polynomial that follows y'' for ever, and the vibration that it leaves from rest.
#include "train_case.hpp"

#include <gtest/gtest.h>

#include <array>

namespace camopt {
namespace stiff_train_test {

using Long = long double;

struct EndState {
    Long z, slope;
};

/// The 3-4-5 polynomial: z'' + 2 ζ w z' + w² z = −(60 x − 180 x² + 120 x³).
EndState exact_end(Long w, Long damping) {
    const std::array<Long, 4> right = {0.0L, -60.0L, 180.0L, -120.0L};
    std::array<Long, 6> z{};
    for (int k = 3; k >= 0; --k)
        z[k] = (right[k] - 2 * damping * w * (k + 1) * z[k + 1] - (k + 2) * (k + 1) * z[k + 2]) / (w * w);
    Long end = 0, slope = 0;
    for (int k = 0; k < 4; ++k) end += z[k], slope += k * z[k];
    // What rings: from −z_0, −z_1.
    const Long a = -z[0], b = -z[1], decay = damping * w;
    if (damping < 1) {
        const Long own = w * std::sqrt(1 - damping * damping);
        const Long s = (b + decay * a) / own, e = std::exp(-decay), c = std::cos(own), d = std::sin(own);
        return {end + e * (a * c + s * d), slope + e * (-decay * (a * c + s * d) + own * (s * c - a * d))};
    }
    if (damping == 1) {
        const Long s = b + w * a, e = std::exp(-w);
        return {end + e * (a + s), slope + e * (s - w * (a + s))};
    }
    const Long root = w * std::sqrt(damping * damping - 1), fast = -decay - root, slow = -decay + root;
    const Long p = (b - slow * a) / (fast - slow), q = a - p;
    return {end + p * std::exp(fast) + q * std::exp(slow),
            slope + p * fast * std::exp(fast) + q * slow * std::exp(slow)};
}

TEST(StiffTrain, ClaimsNoWrongDigit) {
    int rows = 0;
    // Stiffness goes with the square of the ratio: 1 to 1e8.
    for (const double ratio : {1.0, 3.3, 10.0, 47.1, 100.0, 331.7, 1000.0, 10000.0})
        for (const double damping : {0.0, 1e-6, 0.02, 0.3, 0.999999, 1.0, 1.000001, 1.5, 2.0}) {
            const double w = 2.0 * std::numbers::pi * ratio;
            const DynamicsSpec spec = one_mass(ratio, damping);
            const RiseFigures found = rise_figures(spec, "polynomial_345");
            const auto train = train_formulas(spec)->at(1.0, 1.0, 1.0);
            // The generator's own stiffness: what is asked for is rounded on its way there.
            const EndState exact = exact_end(static_cast<Long>(w), static_cast<Long>(damping));
            const double z = train->deflection().state.dot(found.end);
            const double slope = found.end[1] / std::sqrt(spec.mass);
            // By the largest that z and z' come to; the phase is known to the rounding of w alone.
            const double size = found.deflection;
            EXPECT_NEAR(z, static_cast<double>(exact.z), 2e-15 * w * size + 1e-14 * size)
                << ratio << ' ' << damping;
            EXPECT_NEAR(slope, static_cast<double>(exact.slope), (2e-15 * w + 1e-14) * w * size)
                << ratio << ' ' << damping;
            ++rows;
        }
    EXPECT_EQ(rows, 72);
}

/// Around critical damping, where eigenvectors meet, the response does not jump.
TEST(StiffTrain, PassesCriticalDampingSmoothly) {
    const double at = rise_figures(one_mass(3.0, 1.0), "cycloidal").deflection;
    for (const double step : {1e-12, 1e-9, 1e-7}) {
        EXPECT_NEAR(rise_figures(one_mass(3.0, 1.0 - step), "cycloidal").deflection, at, 1e-13 + step);
        EXPECT_NEAR(rise_figures(one_mass(3.0, 1.0 + step), "cycloidal").deflection, at, 1e-13 + step);
    }
}

}  // namespace stiff_train_test
}  // namespace camopt

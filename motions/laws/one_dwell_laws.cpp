// SPDX-License-Identifier: MIT
#include "motions/laws/one_dwell_laws.hpp"

#include "core/errors.hpp"
#include "motions/laws/harmonic_law.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

namespace camopt {

namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

constexpr double kWidestSine = 1.0 - 0.5 * sqrt2;
constexpr double kWidestTrapezoid = pi / (3.0 * pi + 2.0);

LawInfo one_dwell(const char* key, std::string title) {
    LawInfo info;
    info.key = key;
    info.title = std::move(title);
    info.source = "standard construction";
    info.continuity = 2;
    info.top = TopEnd::turning_point;
    return info;
}

LawInfo one_dwell(const char* key, const char* title, double ta, double widest) {
    if (!(ta >= kNarrowestPiece && ta <= widest)) {
        throw InputError(
            fmt::format("{}: Ta = {} found, allowed {} <= Ta <= {}", key, ta, kNarrowestPiece, widest));
    }
    LawInfo info = one_dwell(key, fmt::format("{} (one dwell, Ta = {})", title, ta));
    info.parameters = {{"Ta", ta}};
    return info;
}

}  // namespace

std::unique_ptr<Law> make_one_dwell_modified_sine(double ta) {
    LawInfo info = one_dwell("one_dwell_modified_sine", "Modified sine", ta, kWidestSine);
    const double zero = 1.0 / (2.0 - ta), deceleration = 1.0 / (1.0 - ta);
    return std::make_unique<HarmonicLaw>(
        std::move(info),
        std::vector<AccelerationPiece>{quarter_sine_up(0.0, ta, 1.0), quarter_cosine_down(ta, zero, 1.0),
                                       quarter_sine_up(zero, 1.0, -deceleration)});
}

std::unique_ptr<Law> make_one_dwell_cycloidal() {
    const double zero = 2.0 - sqrt2;
    return std::make_unique<HarmonicLaw>(
        one_dwell("one_dwell_cycloidal", "Cycloidal (one dwell)"),
        std::vector<AccelerationPiece>{half_sine(0.0, zero, 1.0), quarter_sine_up(zero, 1.0, -sqrt2)});
}

std::unique_ptr<Law> make_one_dwell_modified_trapezoid(double ta) {
    LawInfo info = one_dwell("one_dwell_modified_trapezoid", "Modified trapezoid", ta, kWidestTrapezoid);
    // A width within the narrowest piece of the maximum is set to the maximum.
    const bool flat = kWidestTrapezoid - ta >= kNarrowestPiece;
    if (!flat) ta = kWidestTrapezoid;
    const double zero = flat ? 0.5 + ta * (0.5 - 1.0 / pi) : 2.0 * ta;
    const double ramp = flat ? zero - ta : ta;
    std::vector<AccelerationPiece> pieces{quarter_sine_up(0.0, ta, 1.0)};
    if (flat) pieces.push_back(constant_piece(ta, ramp, 1.0));
    pieces.push_back(half_cosine(ramp, zero + ta, 1.0));
    pieces.push_back(constant_piece(zero + ta, 1.0, -1.0));
    return std::make_unique<HarmonicLaw>(std::move(info), std::move(pieces));
}

std::unique_ptr<Law> make_one_dwell_polynomial_345() {
    const double third = 1.0 / 3.0;
    return std::make_unique<PolynomialLaw>(
        one_dwell("one_dwell_polynomial_345", "3-4-5 polynomial (one dwell)"),
        std::vector<double>{0, 0, 0, 20 * third, -25 * third, 8 * third},
        std::vector<double>{1, 0, -10 * third, 0, 5, -8 * third});
}

std::unique_ptr<Law> make_one_dwell_polynomial_3456() {
    return std::make_unique<PolynomialLaw>(
        one_dwell("one_dwell_polynomial_3456", "3-4-5-6 polynomial (one dwell)"),
        std::vector<double>{0, 0, 0, 8, -12, 6, -1}, std::vector<double>{1, 0, -3, 0, 3, 0, -1});
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "motions/laws/own_law_check.hpp"

#include "core/errors.hpp"
#include "core/numbers/polynomial.hpp"
#include "core/text/names.hpp"
#include "motions/laws/law.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Of the size of a derivative: the round-off of sums of a few hundred products.
constexpr double law_rounding = 1e-9;
// Intervals between two breakpoints, in each of which the integral is checked.
constexpr int law_stretches = 16;
constexpr std::array<const char*, 4> derivative_words = {"y", "y'", "y''", "y'''"};

[[noreturn]] void refuse_law(const Law& law, const std::string& found, const std::string& allowed) {
    throw InputError(fmt::format("add_law: \"{}\": found {}; allowed: {}", law.key(), found, allowed));
}

void check_key(const Law& law) {
    if (!is_plain_name(law.key())) refuse_law(law, "this key", "lower case letters, digits and _");
}

void check_end(const Law& law, double x, std::size_t order, double wanted) {
    const double found = law.derivatives(x)[order];
    if (std::abs(found - wanted) <= law_rounding) return;
    refuse_law(law, fmt::format("{} = {} at x = {}", derivative_words[order], found, x),
               fmt::to_string(wanted));
}

struct LawStretch {
    double begin, end;
};

/// y^(order) over an interval against the integral of the next derivative.
void check_stretch(const Law& law, std::size_t order, const LawStretch& stretch) {
    const double half = 0.5 * (stretch.end - stretch.begin), middle = stretch.begin + half;
    double size = 1.0, integral = 0.0;
    for (const QuadraturePoint& point : gauss_legendre) {
        const double next = law.derivatives(middle + half * point.place)[order + 1];
        size = std::max(size, std::abs(next));
        integral += half * point.weight * next;
    }
    const double grown =
        law.derivatives(stretch.end, Side::left)[order] - law.derivatives(stretch.begin, Side::right)[order];
    if (std::abs(grown - integral) <= law_rounding * size) return;
    refuse_law(
        law,
        fmt::format("{} that grows by {:.12g} from x = {:.6g} to {:.6g}, where the integral of {} is {:.12g}",
                    derivative_words[order], grown, stretch.begin, stretch.end, derivative_words[order + 1],
                    integral),
        "consistent derivatives, with a breakpoint wherever a formula changes");
}

}  // namespace

void check_own_law(const Law& law) {
    check_key(law);
    check_end(law, 0.0, 0, 0.0);
    check_end(law, 1.0, 0, 1.0);
    check_end(law, 0.0, 1, 0.0);
    check_end(law, 1.0, 1, 0.0);
    const std::vector<double> breakpoints = law.breakpoints();
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        const double width = (breakpoints[i + 1] - breakpoints[i]) / law_stretches;
        for (int k = 0; k < law_stretches; ++k) {
            const LawStretch stretch{breakpoints[i] + k * width, k == law_stretches - 1
                                                                     ? breakpoints[i + 1]
                                                                     : breakpoints[i] + (k + 1) * width};
            for (std::size_t order = 0; order < 3; ++order) check_stretch(law, order, stretch);
        }
    }
}

}  // namespace camopt

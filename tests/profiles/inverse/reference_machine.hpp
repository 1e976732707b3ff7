// SPDX-License-Identifier: MIT
// The reference machine of the tests: round values near those recovered from the paper's Table 1 (chosen, not
// printed in it), and its roller.
#pragma once

#include "benchmarks/papers/guided_feeder.hpp"
#include "benchmarks/papers/paper_guide.hpp"
#include "core/units.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"

namespace camopt::test {

inline constexpr double inch = units::inch;

inline G1GuideDimensions forward_dimensions() {
    return {5.25 * inch, 9.92 * inch, 10.67 * inch, 9.0 * units::degree, 1.5 * inch, 14.0 * inch};
}

inline G1GuideDimensions return_dimensions() {
    return {5.0 * inch, 10.092 * inch, 11.76 * inch, 9.0 * units::degree, 1.5 * inch, 14.0 * inch};
}

inline FeederLinkage reference_linkage() {
    return {15.0 * inch, 9.0 * units::degree, {18.3756 * inch, 0.93306 * inch}, 4.0 * inch};
}

inline RollerStroke forward_stroke() {
    return {0.0, 0.158, 0.0, 1.5 * inch, 0.0, 1000.0 * inch};
}

inline RollerStroke return_stroke() {
    return {0.158, 0.258, 0.258, 1.5 * inch, 0.0, 2496.4 * inch};
}

inline RollerLaw reference_roller() {
    return RollerLaw({forward_stroke(), return_stroke()});
}

}  // namespace camopt::test

// SPDX-License-Identifier: MIT
// The peaks of the optimum beside those of the reference and of the best curve of any kind: one row a peak.
#pragma once

#include "output/chart/reference_motion.hpp"
#include "output/words/motion_extremes.hpp"
#include "output/words/shown_units.hpp"
#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

struct PeakRow {
    std::string name;                 ///< "velocity"
    std::string symbol;               ///< "V"
    Extremum optimum;                 ///< normalised; of a program the largest over its spline segments
    Extremum motion;                  ///< of the whole motion, in lifts and units of x: what `shown` is for
    std::optional<double> reference;  ///< normalised; infinite for a law with impulses
    /// Of the curve of least objective of all curves, where the limit is attained: no bound of this peak by
    /// itself, which another curve may have smaller.
    std::optional<double> any_curve;
    std::optional<ShownDerivative> shown;  ///< the units of `motion`; none: it has but the normalised value
    SignedPeaks sides = {};                ///< `motion` with its sign, and the peak of the other sign

    [[nodiscard]] std::string first_text(int digits = 6) const;   ///< "−512.3 mm/s"
    [[nodiscard]] std::string beside_text(int digits = 6) const;  ///< "−16.3 mm/rad"; empty: nothing beside
    [[nodiscard]] std::string change() const;  ///< against the reference: "−2.6 %"; "–"
    /// "480 mm/s": the peak of the other sign; empty: there is none.
    [[nodiscard]] std::string opposite_text(int digits = 6) const;
};

/// V, A, J, and the inertia torque max |y' y''|. For a solution with a motion.
[[nodiscard]] std::vector<PeakRow> peak_comparison(const Solution& solution,
                                                   const ReferenceMotion& reference);

/// What the scene demands and the limit of any curve does not know: "limits of the cam", "limits of the cam
/// and via points". Empty: it knows all.
[[nodiscard]] std::string left_out_of_any_curve(const Scene& scene);

/// "limit of any curve", and what it leaves out.
[[nodiscard]] std::string any_curve_title(const Scene& scene);

/// "modified sine", or "reference" where it was given as numbers.
[[nodiscard]] std::string reference_title(const ReferenceMotion& reference);

}  // namespace camopt

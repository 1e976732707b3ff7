// SPDX-License-Identifier: MIT
// The peaks of the optimum beside those of the reference and of the best curve of any kind: one row a peak.
#pragma once

#include "report/view/shown_units.hpp"
#include "studies/delivered/solution.hpp"
#include "studies/delivered/solution_parts.hpp"

namespace camopt {

// The reference law, placed into the scene so that it can be compared with the optimum: the law itself on the
// rise, and for RR its mirror image, stretched to its own angle, on the return.
struct ReferenceMotion {
    std::string title;  ///< for people: "modified sine"; empty where the reference is given as numbers
    std::unique_ptr<Motion> motion;
    Peaks peaks;  ///< of the whole motion in this scene, exact; infinite where they are
};

/// motion is empty where the reference is given as numbers, and for a program, whose normalised peaks compare
/// with the law's and whose curve follows from a solution (law_in_place). Throws InputError for an unknown
/// law.
[[nodiscard]] ReferenceMotion reference_motion(const Scene& scene);

// How far the delivered motion goes to either side: the signed extremes of its derivatives, and where it
// leaves the range of a stroke.

/// The peak of a derivative with its sign, and the largest value of the other sign: `value` in lifts and
/// units of x. A peak without value (an impulse) is infinite.
struct SignedPeaks {
    Extremum largest;
    std::optional<Extremum> opposite;  ///< none: the derivative keeps its sign
};

/// order 1 … 3. For a solution with a motion. The peak is exact (Solution::motion_peaks), the opposite one
/// comes from core/numbers/extremum.hpp.
[[nodiscard]] SignedPeaks signed_peaks(const Solution& solution, int order);

/// Of a stroke (rise, rise and return, spline segment of a program) that leaves the range low … high between
/// the displacements at its ends, lifts.
struct Excursion {
    double low = 0.0, high = 1.0;
    int segment = -1;     ///< of a program
    Extremum farthest{};  ///< y there
    double beyond = 0.0;  ///< > 0: how far outside

    [[nodiscard]] bool below() const { return farthest.value < low; }
};
[[nodiscard]] std::vector<Excursion> excursions(const Solution& solution);

/// "The follower goes 3.2 mm below its start at 212 deg." One sentence each.
[[nodiscard]] std::vector<std::string> excursion_sentences(const Solution& solution);

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

    /// Against the reference: "−2.6 %"; "–".
    [[nodiscard]] std::string change() const {
        return reference ? change_text(optimum.value, *reference) : "–";
    }
};

/// V, A, J, and the inertia torque max |y' y''|. For a solution with a motion.
[[nodiscard]] std::vector<PeakRow> peak_comparison(const Solution& solution,
                                                   const ReferenceMotion& reference);

/// What the scene demands and the limit of any curve does not know: " (limits of the cam left out)", "
/// (limits of the cam and via points left out)". Empty: it knows all.
[[nodiscard]] std::string left_out_of_any_curve(const Scene& scene);

/// "modified sine", or "reference" where it was given as numbers.
[[nodiscard]] std::string reference_title(const ReferenceMotion& reference);

}  // namespace camopt

// SPDX-License-Identifier: MIT
// A solution as people see it: rows of the motion and its cam in display units, with limits, marks and
// reference curves, made once. Charts, pages and the studio iterate over it; none of them converts a unit.
//
// A new quantity along the motion is one row in motion_curves.cpp, drive_curves.cpp or cam_curves.cpp of this
// folder.
#pragma once

#include "report/view/shown_units.hpp"
#include "studies/delivered/delivered.hpp"

namespace camopt {

struct ReferenceMotion;  // report/view/peak_comparison.hpp

/// A limit over a stretch of the cam: a horizontal line, in the curve's unit.
struct CurveLimit {
    double from = 0.0, to = 0.0;  ///< deg
    double at = 0.0;
    int outside = 1;  ///< +1: values above violate it, −1: below
    std::string words;
};

/// A value to name: an extreme as the tables have it, or a set point of the scene.
struct CurveMark {
    double at = 0.0;  ///< deg
    double value = 0.0;
    std::string words;              ///< "12.3 mm/s"
    bool given = false;             ///< a set point
    std::optional<double> to = {};  ///< of a region: its end, deg
};

/// Another motion at the same rows.
struct ComparedCurve {
    std::string title;
    std::vector<double> values;  ///< NaN outside of that motion
};

/// Where made cams are, at the same rows.
struct CurveBand {
    std::vector<double> low, high;  ///< NaN: no value there
};

/// One quantity by the rows of View::delivered.
struct Curve {
    std::string key;    ///< "velocity", "pressure_angle"
    std::string group;  ///< "motion", "motor", "cam", "forces"
    std::string title, symbol;
    ShownUnit unit;
    std::vector<double> values = {};        ///< in `unit`; NaN: no value there
    std::optional<MotionUnit> beside = {};  ///< a second unit of the same values
    double beside_factor = 1.0;             ///< value in `beside` = beside_factor · value
    double normalised_factor = 0.0;         ///< normalised value = normalised_factor · value; 0: has none
    std::optional<ComparedCurve> reference = {}, measured = {};
    std::vector<CurveLimit> limits = {};
    std::vector<CurveMark> marks = {};
    std::vector<std::array<double, 2>> points =
        {};                              ///< deg and value: rows of the measured table, some thousand
    std::optional<CurveBand> band = {};  ///< within the tolerances of the scene
    std::string note = {};  ///< how it compares: "V = 1.5 · modified sine V = 1.76 · change −15 %"
};

/// A segment of a program, deg.
struct ViewSegment {
    double from = 0.0, to = 0.0;
    std::string title;
};

/// Curves over one angle, with what is marked along it. Angles in deg.
struct CurveSet {
    std::vector<double> angles = {};  ///< of the rows
    std::vector<Curve> curves = {};
    std::vector<ViewSegment> segments = {};
    std::vector<double> breakpoints = {};  ///< of the motion
};

/// Keeps a reference to the solution. Everything is empty without a motion.
struct View : CurveSet {
    View(const Solution& shown);  // NOLINT(google-explicit-constructor): a solution is shown by its view

    const Solution& solution;
    ShownUnits units;
    Delivered delivered;

    /// The master's angle, from motion.phase on.
    [[nodiscard]] double degrees(double x) const {
        return degrees_shown.of(solution.scene.motion.phase) + units.degrees_per_x * x;
    }
    /// The scene's title, or this.
    [[nodiscard]] std::string title(const char* untitled) const {
        return solution.scene.title.empty() ? untitled : solution.scene.title;
    }
    /// A derivative of another motion at the rows, in that unit; NaN outside of it.
    [[nodiscard]] std::vector<double> along(const Motion& motion, const MotionUnit& unit) const;
};

/// "modified trapezoid", "spline", "dwell"
[[nodiscard]] std::string segment_title(const SegmentReport& segment);

// Private to report/view.

inline constexpr int curve_mark_digits = 6;  ///< of the texts of marks, as in the tables

/// The curve beside the motion; none: the reference is given as numbers, or nothing is optimised.
[[nodiscard]] std::shared_ptr<const Motion> reference_curve(const Solution& solution,
                                                            ReferenceMotion& reference);
/// Displacement, velocity, acceleration and jerk; with a measured motion the residual of its table.
[[nodiscard]] std::vector<Curve> motion_curves(const View& view);
/// Torque and speed of the motor. The solution has one.
[[nodiscard]] std::vector<Curve> drive_curves(const View& view);
/// Pressure angle, curvature or regularity, loads: what this cam has.
[[nodiscard]] std::vector<Curve> cam_curves(const View& view);
/// The bands of those curves. The scene has tolerances.
void add_made_bands(View& view);

// Where the limits of a scene stand in diagrams over the cam angle.

/// A limit that holds from x = begin to end only.
struct LimitSpan {
    double begin = 0.0, end = 0.0, normalised = 0.0;
};

/// A limit on the magnitude of the pressure angle over a stretch of the cam, rad.
struct PressureLimit {
    double begin = 0.0, end = 0.0;  ///< θ
    double limit = 0.0;
};

/// The limit on the peak of derivative `order`, 1 … 3; none.
[[nodiscard]] const std::optional<PeakLimit>& peak_limit_of(const LimitSpec& limits, int order);

/// Where a normalised limit on that derivative stands over each spline segment of a program, in the motion's
/// own units. Empty where it is the same over the whole motion.
[[nodiscard]] std::vector<LimitSpan> segment_limits(const Solution& solution, const PeakLimit& limit,
                                                    int order);

/// Rise and return may have limits of their own; where the follower rests the least of all holds. Pieces
/// between the motion's breakpoints are told apart by what the follower does over them.
[[nodiscard]] std::vector<PressureLimit> pressure_spans(const Scene& scene, const Motion& motion);

}  // namespace camopt

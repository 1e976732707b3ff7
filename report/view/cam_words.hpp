// SPDX-License-Identifier: MIT
// The cam of a solution in words, of any kind: dimensions and figures, in the units of shown_units.hpp.
#pragma once

#include "report/view/shown_units.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// Name and value of a dimension as files show it: mm, or deg; of a spring N, N/mm.
struct DimensionValue {
    std::string name;             ///< "base_radius"
    ShownUnit unit;               ///< of files
    std::optional<double> shown;  ///< none: free, and nothing was delivered
    std::string text = {};        ///< as people read it: "30 mm", "1.2 in", "free"
};

/// The dimensions this cam has, of a disk cam then the prime radius (base + roller), and of its spring the
/// numbers that are ranges. None without a cam.
[[nodiscard]] std::vector<DimensionValue> cam_dimensions(const Solution& solution);

/// "translating roller, the cam turning counterclockwise", "remote cam with lever-coupler-slider, turning
/// clockwise"
[[nodiscard]] std::string cam_text(const CamSpec& cam);

/// Something presses the follower on the cam: forces are given, and not all of them are 0.
[[nodiscard]] bool is_loaded(const CamSummary& summary);

/// The least convex radius of the cam; none where it is nowhere convex, or straight where it is most so.
[[nodiscard]] std::optional<CamExtreme> convex_radius(const CamSummary& summary);

/// One extreme of the cam, of its forces or of one of its sides: what tables and result.json say of it. A new
/// figure is one row of cam_words.cpp.
template <class Summary>
struct FigureRow {
    const char* key = nullptr;   ///< in result.json, with its unit: "pressure_angle_deg"
    const char* name = nullptr;  ///< for people: "largest pressure angle"
    ShownUnit ShownUnits::*unit = nullptr;
    std::optional<CamExtreme> (*of)(const Summary& summary) = nullptr;
    const char *key_of_moment = nullptr, *name_of_moment = nullptr;  ///< where the follower swings
    bool of_direct_cams = false;
    bool only_where_found = false;  ///< result.json has no key without it
};
[[nodiscard]] std::span<const FigureRow<CamSummary>> cam_figure_rows();
[[nodiscard]] std::span<const FigureRow<ForceSummary>> force_figure_rows();
[[nodiscard]] std::span<const FigureRow<SideSummary>> side_figure_rows();

/// One extreme of the cam: "largest pressure angle", "29.99 deg", "23.4".
struct CamFigure {
    std::string name, value;
    std::string degrees;  ///< where, counted from the start of the scene
};

/// Pressure angles, radii, contact, forces: what exists. For a solution with a cam.
[[nodiscard]] std::vector<CamFigure> cam_figures(const Solution& solution);

// A place of the motion as a person reads it.
inline constexpr int angle_digits = 5;

/// The cam angle of x (the master's), degrees, without the unit.
[[nodiscard]] inline std::string degrees_at(const Solution& solution, double x, int digits = angle_digits) {
    return short_text(degrees_shown.of(solution.scene.motion.master_angle(x)), digits);
}

/// Cam angles in degrees: "at 40 deg"; of a stretch "from 40 to 55.5 deg".
[[nodiscard]] std::string angles_words(double begin, double end, int digits = angle_digits);
/// The same of a stretch of the motion, counted as degrees_at does.
[[nodiscard]] std::string stretch_words(const MotionSpec& motion, double begin, double end,
                                        int digits = angle_digits);
/// "stroke 2, from 45 to 120 deg", as a person counts.
[[nodiscard]] std::string stroke_words(const MotionSpec& motion, std::size_t index, double begin, double end);

}  // namespace camopt

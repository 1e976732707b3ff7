// SPDX-License-Identifier: MIT
// Private to benchmarks/papers/: the tables and figures that papers 001 and 002 have in common.
#pragma once

#include "benchmarks/papers/papers.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "scene/cam_flanks.hpp"

namespace camopt::spatial_tables {

/// A cam with its motion over the turn.
struct Example {
    SpatialCam cam;
    FollowerMotion motion;
    double input_speed = 0.0;  ///< rad/s; 0: no speed
};

/// Rest to `from`, then the modified sine by `lift` over `width`, then rest up to `end`; rad.
struct Rise {
    double begin = 0.0, from = 0.0, width = 0.0, lift = 0.0, end = 0.0;
};
[[nodiscard]] FollowerMotion modified_sine_rise(const Rise& rise);

/// Largest |φ| at three heights.
[[nodiscard]] PaperTable pressure_table(const Example& example);
/// Least g, critical roller radius and centre distance at the roller's far end, both flanks; interference.
[[nodiscard]] PaperTable undercut_table(const Example& example);
/// Envelope against relative velocity over the turn: the largest difference, mm.
[[nodiscard]] double method_difference_mm(const Example& example);
/// Points against error and seconds.
[[nodiscard]] PaperTable forward_table(const Example& example, const std::vector<int>& points,
                                       const PaperProgress& finished);

[[nodiscard]] PaperFigure displacement_figure(const Example& example, const std::string& key,
                                              const std::string& title);
[[nodiscard]] PaperFigure pressure_figure(const Example& example);
[[nodiscard]] PaperFigure undercut_figure(const Example& example);
/// Both flanks unrolled: along the cam's axis over the angle around it, at both ends of the roller.
[[nodiscard]] PaperFigure unrolled_figure(const Example& example, const std::string& key,
                                          const std::string& title);

// What the barrel cam of paper 002 gains by an optimised motion: the pressure
// angle at the same distance of the axes, and the smallest distance for a pressure angle.

struct BarrelOptima {
    PaperTable table;
    PaperFigure figure;  ///< pressure angle at the roller's tip, both motions
    std::vector<std::string> faults;
};

/// Two solves, some seconds each; as scenes/barrel_paper_cup.toml and scenes/barrel_smallest.toml.
[[nodiscard]] BarrelOptima barrel_optima(const Example& example, const SolveControl& control,
                                         const PaperProgress& finished);

}  // namespace camopt::spatial_tables

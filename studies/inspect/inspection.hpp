// SPDX-License-Identifier: MIT
// A measured cam compared with its nominal one: deviations d (measured − nominal) before and after alignment.
//
//   displacement m at θ   d = m − s(θ − α) − ρ − x cos(θ − α) − y sin(θ − α)
//   point p of the cam    d = n · (R(−α)(p − (x, y)) − c) − probe radius − ρ
//
// s: nominal displacement; c, n: nearest point of the nominal cam, its outward normal; R: rotation. α: angle
// offset, ρ: radial offset, (x, y): eccentricity, only of a table that covers the revolution.
//
// Gauss–Newton on Σ w d². w: Tukey's biweight (c = 4.685) of the median of the neighbours' deviations, by its
// robust spread on base circle and lobe separately; 0 for outliers: a local error does not pull the
// alignment. Standard errors: the larger one of the usual estimate and that for errors which neighbours share
// (W. K. Newey, K. D. West, Econometrica 55 (1987)). SI units and radians.
#pragma once

#include "input/inspected_table.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

struct InspectedRow {
    int line = 0;
    Eigen::Vector2d given;  ///< in the table: cam angle and displacement, or the point
    double angle = 0.0;  ///< as in the table; of a point the cam angle that touches the nearest nominal point
    /// Displacements; of points distances from the cam's centre. nominal: of the aligned cam.
    double measured = 0.0, nominal = 0.0;
    double raw = 0.0, aligned = 0.0, around = 0.0;  ///< deviations; around: median of the neighbours' aligned
    double follower = 0.0;                          ///< the aligned one as a displacement of the follower
    bool base = false;                              ///< the nominal follower dwells at s = 0
    bool outlier = false;                           ///< more than 5 robust standard deviations from `around`
    double weight = 1.0;                            ///< in the fit
    Eigen::Vector4d slope =
        Eigen::Vector4d::Zero();  ///< of the aligned deviation by the alignment (ρ, α, x, y)
};

struct DeviationFigures {
    double most = 0.0, most_at = 0.0, least = 0.0, least_at = 0.0, rms = 0.0;  ///< at: angle of the row
    int rows = 0;
};

struct Inspection {
    bool points = false, is_angle = false;  ///< of points; displacements of the follower are angles
    int fitted = 2;                         ///< 4: with eccentricity
    Eigen::Vector4d alignment = Eigen::Vector4d::Zero(), error = Eigen::Vector4d::Zero();
    double noise = 0.0;                      ///< robust standard deviation of rows from their neighbours
    std::vector<InspectedRow> rows;          ///< by ascending angle
    DeviationFigures raw, all, base, lobe;   ///< raw, and aligned: all rows, base circle, all others
    std::vector<InspectedRow> worst;         ///< with the largest medians of neighbours, 10° apart
    std::optional<double> tolerance;         ///< aligned deviations within ± it are in tolerance
    std::vector<std::array<double, 3>> out;  ///< stretches out of it: angles from, to, worst deviation
};

/// probe_radius: points are the centres of a ball that touches the cam; 0: they lie on it. Throws InputError
/// where the table does not fit the nominal cam: other units, points of a cam that is open or not a disk.
[[nodiscard]] Inspection inspect_cam(const Solution& nominal, const input::InspectedTable& table,
                                     double probe_radius = 0.0, std::optional<double> tolerance = {});

}  // namespace camopt

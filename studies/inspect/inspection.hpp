// SPDX-License-Identifier: MIT
// A measured cam compared with its nominal one: deviations d (measured − nominal) before and after alignment.
//
//   displacement m at θ   d = m − s(θ − α) − ρ − x cos(θ − α) − y sin(θ − α)
//   point p of the cam    d = n · (R(−α)(p − (x, y)) − c) − probe radius − ρ
//
// s: nominal displacement; c, n: nearest point of the nominal cam, its outward normal; R: rotation. α: angle
// offset, ρ: radial offset, (x, y): eccentricity, only of a table that covers the revolution.
//
// Aligned as input/table_alignment.hpp describes. SI units and radians.
#pragma once

#include "input/inspected_table.hpp"
#include "input/table_alignment.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

using InspectedRow = input::AlignedRow;

struct DeviationFigures {
    double most = 0.0, most_at = 0.0, least = 0.0, least_at = 0.0, rms = 0.0;  ///< at: angle of the row
    int rows = 0;
};

/// What is held against a table: ± of the aligned deviations, or of what they move the follower by, and of
/// the first two derivatives of that by the cam angle.
struct InspectionTolerance {
    std::optional<double> deviation = {};
    bool of_follower = false;                               ///< of InspectedRow::follower
    std::array<std::optional<double>, 2> derivatives = {};  ///< δ', δ'', by rad
};

/// A derivative of the follower's error δ at each row, by a parabola through the rows of its neighbourhood
/// (least squares, without outliers); out of tolerance where it passes it by more than twice its standard
/// error.
struct ErrorDerivative {
    int order = 1;
    double tolerance = 0.0;
    std::vector<double> values = {}, errors = {};  ///< by row, with standard errors; NaN: too few rows there
    double worst = 0.0, worst_at = 0.0, worst_error = 0.0;
    std::vector<std::array<double, 3>> out = {};  ///< as Inspection::out
};

struct Inspection : input::TableAlignment {
    bool points = false, is_angle = false;   ///< of points; displacements of the follower are angles
    DeviationFigures raw, all, base, lobe;   ///< raw, and aligned: all rows, base circle, all others
    std::vector<InspectedRow> worst;         ///< with the largest medians of neighbours, 10° apart
    std::optional<double> tolerance;         ///< deviations within ± it are in tolerance
    bool of_follower = false;                ///< it is one of the follower's displacement, not of the surface
    std::vector<std::array<double, 3>> out;  ///< stretches out of it: angles from, to, worst deviation
    std::vector<ErrorDerivative> derivatives;  ///< those that have a tolerance

    [[nodiscard]] double judged(const InspectedRow& row) const {
        return of_follower ? row.follower : row.aligned;
    }
    [[nodiscard]] bool in_tolerance() const {
        return out.empty() &&
               std::ranges::all_of(derivatives, [](const auto& one) { return one.out.empty(); });
    }
};

/// The bands of a scene with tolerances (scene/tolerance_spec.hpp); none: it has none.
[[nodiscard]] InspectionTolerance inspection_tolerance(const Scene& scene);

/// probe_radius: points are the centres of a ball that touches the cam; 0: they lie on it. Throws InputError
/// where the table does not fit the nominal cam: other units, points of a cam that is open or not a disk.
[[nodiscard]] Inspection inspect_cam(const Solution& nominal, const input::InspectedTable& table,
                                     double probe_radius = 0.0, const InspectionTolerance& tolerance = {});

}  // namespace camopt

// SPDX-License-Identifier: MIT
// The alignment of a measured table with a motion or a cam: deviations d of its rows, corrected by a radial
// offset ρ, an angle offset α and an eccentricity (x, y).
//
// Gauss–Newton on Σ w d². w: Tukey's biweight (c = 4.685) of the median of the neighbours' deviations, by its
// robust spread on base circle and lobe separately; 0 for outliers: a local error does not pull the
// alignment. Standard errors: the larger one of the usual estimate and that for errors which neighbours share
// (W. K. Newey, K. D. West, Econometrica 55 (1987)). SI units and radians.
#pragma once

#include "core/units.hpp"

#include <Eigen/Core>

namespace camopt::input {

inline constexpr double neighbourhood =
    2.5 * units::degree;  // to either side: below the width of a form error
inline constexpr double shared_errors = 10.0 * units::degree;  // rows this far apart share form errors
inline constexpr double resting =
    1e-9;  // lifts: a smaller displacement, and slope by x, is that of the dwell

struct AlignedRow {
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

struct TableAlignment {
    int fitted = 2;  ///< 4: with eccentricity
    Eigen::Vector4d alignment = Eigen::Vector4d::Zero(), error = Eigen::Vector4d::Zero();
    double noise = 0.0;            ///< robust standard deviation of rows from their neighbours
    std::vector<AlignedRow> rows;  ///< by ascending angle
};

/// Fills in a row under an alignment. A slope of 0 keeps its parameter.
using CompareRow = std::function<void(AlignedRow& row, const Eigen::Vector4d& alignment)>;

/// The angle offset nearest to 0 at which the rows agree best up to a constant.
[[nodiscard]] double searched_offset(std::vector<AlignedRow> rows, const CompareRow& compare);

/// In each twelfth of the revolution there is a row.
[[nodiscard]] bool covers_revolution(const std::vector<AlignedRow>& rows);

/// From the alignment that is given. Not robust: the first steps of plain least squares alone.
void align(TableAlignment& found, const CompareRow& compare, bool robust = true);

}  // namespace camopt::input

// SPDX-License-Identifier: MIT
// Statistics that outliers do not pull: medians, spreads, and the cubic through the neighbours of each row.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

inline constexpr double biweight = 4.685;  // 95 % efficiency with normal errors (J. W. Tukey)
inline constexpr double outlying = 5.0;    // robust standard deviations

/// 0 without values.
[[nodiscard]] double median_of(std::vector<double> values);

/// 1.4826 · median of magnitudes: the standard deviation of normal errors. At least `least`.
[[nodiscard]] double spread_of(std::vector<double> values, double least = 0.0);

/// A row and its neighbours. The cubic is fitted without the row, by least magnitudes, then with Tukey's
/// biweight.
struct LocalFit {
    double value = 0.0, slope = 0.0;  ///< of the cubic at the row
    double off = 0.0;                 ///< the row less the cubic
    double error = 1.0;  ///< standard deviation of `off` where that of the rows is 1; at ends it is larger
};

/// 6°, rad: within it a cubic follows every law.
extern const double local_width;

/// `at`: ascending, rad. Neighbours are the rows within `width` on either side, at least 4 and at most 80 on
/// either side. period > 0: after the last row the first one follows. Fewer than 8 other rows: value = the
/// row.
[[nodiscard]] std::vector<LocalFit> local_fits(std::span<const double> at, std::span<const double> values,
                                               double period = 0.0, double width = local_width);
/// With the width, 6° or a half, a quarter … of it, that leaves the least errors of rows from the cubic of
/// their neighbours (cross-validation): rows without noise need fewer neighbours.
[[nodiscard]] std::vector<LocalFit> closest_local_fits(std::span<const double> at,
                                                       std::span<const double> values, double period = 0.0);

/// Rows more than 5 standard deviations of all rows, and of their neighbourhood, from the cubic of their
/// neighbours. Deviations are none below 1.5 steps of the values' resolution, nor below the second
/// differences of the other rows: at their spacing a jump of the second derivative looks the same.
[[nodiscard]] std::vector<std::size_t> outliers_of(std::span<const double> values,
                                                   std::span<const LocalFit> fits);

}  // namespace camopt

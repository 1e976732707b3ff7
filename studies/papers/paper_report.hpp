// SPDX-License-Identifier: MIT
// What a paper reports, beside what is true: tables and figures as values, in display units.
//
// A study per paper makes one (paper_004_report; benchmarks/papers); report/ writes it as text, JSON, CSV and
// SVG. A table's cells are numbers in the column's unit, words, or nothing; NaN and infinity count as nothing
// in files.
#pragma once

#include "core/base/standard.hpp"

#include <variant>

namespace camopt {

/// Nothing, a number in the column's unit, or words.
using PaperCell = std::variant<std::monostate, double, std::string>;

/// The number; nothing where there is none.
[[nodiscard]] PaperCell cell_of(const std::optional<double>& value);

struct PaperColumn {
    std::string key;    ///< for CSV and JSON, snake_case, ends in its unit: "theta_printed_deg"
    std::string title;  ///< for people, without the unit
    std::string unit;   ///< "deg"; empty: none
    int digits = 6;     ///< significant digits shown to people; files hold all
};

struct PaperTable {
    std::string key;    ///< name of its file, snake_case
    std::string title;  ///< "Table 1: kinematic properties of cam and feeder"
    std::string introduction;
    std::vector<PaperColumn> columns;
    std::vector<std::vector<PaperCell>> rows;
};

struct PaperSeries {
    std::string title;
    std::vector<double> x, y;  ///< of the same size; a NaN breaks the line
    bool markers = false;      ///< points instead of a line
};

struct PaperFigure {
    std::string key;    ///< name of its files, snake_case
    std::string title;  ///< "Fig. 9: motion of the cam"
    std::string x_title, y_title;
    std::vector<PaperSeries> series;
    bool equal_scales = false;  ///< one unit as long on both axes: for shapes
    bool logarithmic = false;   ///< both axes; values <= 0 are left out
};

struct PaperReport {
    std::string id;  ///< "000" … "004"
    std::string title;
    std::string source;  ///< authors, title, year
    std::string introduction;
    std::vector<std::string> assumptions;  ///< dimensions that the paper does not give and we chose
    std::vector<PaperTable> tables;
    std::vector<PaperFigure> figures;
    std::vector<std::string> notes;   ///< errata and what else must be known
    std::vector<std::string> faults;  ///< what could not be computed or proved; empty: the report is whole
};

}  // namespace camopt

// The printed tables of T.-Y. Shon and M.-Y. Yang, "Synthesis of Optimum CAM Curve by Cubic Spline", 1994:
// DRD motion, C2 cubic on n uniform segments, objective 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69. Facts as printed,
// misprints included; reference_table.hpp says what is wrong with which.

namespace camopt::paper {

/// The modified sine's peaks as the paper rounds them.
inline constexpr double velocity_reference = 1.76, acceleration_reference = 5.53, jerk_reference = 69.0;
inline constexpr std::array<double, 3> weights = {0.4, 0.4, 0.2};

/// Table 1: y_0 … y_n.
struct OptimumPoints {
    int segments;
    std::vector<double> ordinates;
};
[[nodiscard]] std::span<const OptimumPoints> optimum_points();

/// Table 2.
struct Convergence {
    int segments;
    double velocity, acceleration, jerk, objective;
};
[[nodiscard]] std::span<const Convergence> convergence();

/// Table 3. jerk: none where the paper prints infinity; key: empty where the catalogue has no such law.
struct LawPeaks {
    std::string_view name, key;
    double velocity, acceleration;
    std::optional<double> jerk;
};
[[nodiscard]] std::span<const LawPeaks> law_peaks();

/// Table 4: the optimum's fourth ordinate for n = 10 under other weights.
struct WeightEffect {
    double velocity, acceleration, jerk, fourth_ordinate;
};
[[nodiscard]] std::span<const WeightEffect> weight_effects();

}  // namespace camopt::paper

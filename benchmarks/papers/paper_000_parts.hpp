// SPDX-License-Identifier: MIT
// Private to benchmarks/papers/: the parts of the report on paper 000, one source each.
#pragma once

#include "benchmarks/papers/feeder_strokes.hpp"
#include "benchmarks/papers/papers.hpp"

namespace camopt::feeding_paper {

// What the paper on the curvilinear inverse cam prints, beside the machine of the scene files
// (feeder_strokes.hpp). Display units: inch, s, deg, rad/s.
//
// Table 1 is given as printed, misprints included. The paper gives neither the guide's dimensions nor the
// rocker's: the guides of the scenes are fits to Table 1's theta, theta', theta'' (8 parameters against 20
// numbers, 4 of the 24 left out after their residuals were seen), and of the one-parameter family of rockers
// that fit equally one member was chosen.

/// Columns of Table 1 after the time.
enum Column {
    distance,
    theta,
    theta_velocity,
    theta_acceleration,
    feeder,
    feeder_velocity,
    feeder_acceleration
};
inline constexpr int columns = 7;

struct ColumnInfo {
    std::string_view symbol, unit;
    double unit_value;  ///< SI of one unit
};
[[nodiscard]] const ColumnInfo& column_info(int column);

/// One row as printed; the words keep the digits.
struct PrintedRow {
    std::string_view time;
    std::array<std::string_view, columns> cells;
    bool moving;  ///< one of the eight rows in which the body moves
};
[[nodiscard]] std::span<const PrintedRow> printed_rows();

/// A printed digit that contradicts the others.
struct Misprint {
    std::string_view time;
    Column column;
    double least, most;  ///< the consistent value lies between; display units
    std::string_view evidence;
};
[[nodiscard]] std::span<const Misprint> misprints();

/// The instant that a printed time stands for: forward rows are samples i · 0.00158 s.
[[nodiscard]] double instant_of(std::string_view time);

/// All columns of Table 1 at a row, display units.
[[nodiscard]] std::array<double, columns> computed_row(const PrintedRow& row);

/// Half a unit of the last printed digit.
[[nodiscard]] double half_digit(std::string_view printed);

/// Over theta … feeder_acceleration of the moving rows.
struct Agreement {
    int entries = 0;
    int rounded = 0;  ///< within the printed rounding
    int close = 0;    ///< within 0.3 % or 5 half digits
};
[[nodiscard]] Agreement agreement();

/// Table 1 beside ours, its misprints, the counts, the recovered dimensions (paper_000_tables.cpp).
[[nodiscard]] std::vector<PaperTable> printed_tables();

/// Figs. 7, 9 and 10, the machine (paper_000_figures.cpp).
[[nodiscard]] std::vector<PaperFigure> printed_figures();

/// The approximate method against the number of nodes, forward simulations (paper_000_tables.cpp).
void add_checks(PaperReport& report);

/// The best guide beside lines and arcs (paper_000_guides.cpp). Adds a fault where an optimum is not proved.
void add_guides(PaperReport& report, const SolveControl& control, const PaperProgress& finished);

}  // namespace camopt::feeding_paper

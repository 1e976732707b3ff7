// SPDX-License-Identifier: MIT
// What a paper reports, beside what is true: tables and figures as values, in display units.
//
// A study per paper (papers.hpp) makes one; output/ writes it as text, JSON, CSV and SVG. A table's
// cells are numbers in the column's unit, words, or nothing; NaN and infinity count as nothing in files.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

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

/// One quantity: printed | ours | difference | remark.
struct PaperComparison {
    std::string quantity, unit;
    std::optional<double> printed, ours;
    std::string remark;  ///< "misprint: …", "chosen", …
};

/// difference = ours − printed; none where one of them is.
[[nodiscard]] PaperTable comparison_table(const std::string& key, const std::string& title,
                                          const std::vector<PaperComparison>& rows);

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

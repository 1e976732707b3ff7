// SPDX-License-Identifier: MIT
#include "output/csv/paper_report_csv.hpp"

#include "output/csv/csv_line.hpp"

#include <cstddef>

namespace camopt {

namespace {

void add_cell(CsvLine& line, const PaperCell& cell) {
    if (const double* number = std::get_if<double>(&cell))
        line.number(*number);
    else if (const std::string* words = std::get_if<std::string>(&cell))
        line.words(*words);
    else
        line.blank();
}

}  // namespace

std::string paper_table_csv(const PaperTable& table) {
    CsvLine header;
    for (const PaperColumn& column : table.columns) header.words(column.key);
    std::string text = header.finish();
    for (const auto& row : table.rows) {
        CsvLine line;
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            add_cell(line, i < row.size() ? row[i] : PaperCell{});
        text += line.finish();
    }
    return text;
}

std::string paper_figure_csv(const PaperFigure& figure) {
    std::string text = "series,x,y\n";
    for (const PaperSeries& series : figure.series)
        for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i)
            text += CsvLine{}.words(series.title).number(series.x[i]).number(series.y[i]).finish();
    return text;
}

}  // namespace camopt

// SPDX-License-Identifier: MIT
#include "studies/papers/paper_report.hpp"

namespace camopt {

PaperCell cell_of(const std::optional<double>& value) {
    if (!value) return {};
    return *value;
}

PaperTable comparison_table(const std::string& key, const std::string& title,
                            const std::vector<PaperComparison>& rows) {
    constexpr int difference_digits = 2;
    PaperTable table{key, title, "", {}, {}};
    table.columns = {{"quantity", "quantity", ""},
                     {"unit", "unit", ""},
                     {"printed", "printed", ""},
                     {"ours", "ours", "", 8},
                     {"difference", "difference", "", difference_digits},
                     {"remark", "remark", ""}};
    for (const PaperComparison& row : rows) {
        std::optional<double> difference;
        if (row.printed && row.ours) difference = *row.ours - *row.printed;
        table.rows.push_back({row.quantity, row.unit, cell_of(row.printed), cell_of(row.ours),
                              cell_of(difference), row.remark});
    }
    return table;
}

}  // namespace camopt

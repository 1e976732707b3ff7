// SPDX-License-Identifier: MIT
#include "benchmarks/papers/papers.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

PaperReport paper_004(const SolveControl& control, const PaperProgress& finished) {
    return paper_004_report(spline_versus_modified_sine(control, finished));
}

std::span<const PaperInfo> paper_catalogue() {
    static constexpr std::array papers = {
        PaperInfo{"000", "curvilinear inverse cam and feeder", paper_000},
        PaperInfo{"001", "open cylindrical cam with a rotating follower (OCRF)", paper_001},
        PaperInfo{"002", "barrel cam of a machine that makes paper cups, 2011", paper_002},
        PaperInfo{"003", "disk cam with a remote follower, tappet shedding, 2003", paper_003},
        PaperInfo{"004", "optimum cam curves by cubic splines, 1994", paper_004},
    };
    return papers;
}

const PaperInfo& find_paper(std::string_view id) {
    const auto papers = paper_catalogue();
    const auto found = std::ranges::find(papers, id, &PaperInfo::id);
    if (found != papers.end()) return *found;
    std::string known;
    for (const PaperInfo& paper : papers) {
        if (!known.empty()) known += ", ";
        known += paper.id;
    }
    throw InputError(fmt::format("paper '{}' is not known; known are {}", id, known));
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

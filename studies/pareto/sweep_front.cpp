// SPDX-License-Identifier: MIT
#include "studies/pareto/sweep_front.hpp"

#include "studies/sweep/sweep_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

namespace camopt {

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();  // no comparison with it is true

double criterion_of(const SweepRow& row, std::string_view name) {
    for (int i = 0; i < sweep_figure_count; ++i)
        if (name == name_of(static_cast<SweepFigure>(i)))
            return row.figures[static_cast<std::size_t>(i)].value_or(absent);
    for (int i = 0; i < dimension_count; ++i)
        if (name == name_of(static_cast<DimensionIndex>(i)))
            return std::abs(row.dimensions[static_cast<std::size_t>(i)].value_or(absent));
    return absent;
}

/// The settings that are no weights.
std::vector<double> question_of(const SweepColumns& columns, const SweepRow& row) {
    std::vector<double> question;
    for (std::size_t i = 0; i < columns.keys.size(); ++i)
        if (!is_weight_key(columns.keys[i])) question.push_back(row.settings[i]);
    return question;
}

struct Contender {
    SweepRow* row = nullptr;
    std::vector<double> criteria;
};

bool dominates(const Contender& winner, const Contender& loser) {
    bool better = false;
    for (std::size_t i = 0; i < winner.criteria.size(); ++i) {
        const double width = front_tolerance * std::abs(loser.criteria[i]);
        if (winner.criteria[i] > loser.criteria[i] + width) return false;
        if (winner.criteria[i] < loser.criteria[i] - width) better = true;
    }
    return better;
}

}  // namespace

void mark_front(SweepTable& table) {
    std::map<std::vector<double>, std::vector<Contender>> questions;
    for (SweepRow& row : table.rows) {
        row.on_front = false;
        if (!row.is_feasible()) continue;
        Contender contender{&row, {}};
        for (const std::string& name : table.columns.criteria)
            contender.criteria.push_back(criterion_of(row, name));
        questions[question_of(table.columns, row)].push_back(std::move(contender));
    }
    for (const auto& [question, contenders] : questions)
        for (const Contender& one : contenders)
            one.row->on_front = std::ranges::none_of(
                contenders, [&](const Contender& rival) { return dominates(rival, one); });
}

}  // namespace camopt

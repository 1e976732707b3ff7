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
    for (const ResponseTerm& term : response_terms())
        if (name == term.name)
            return (term.figure == ResponseFigure::residual ? row.train.residual
                                                            : row.train.dynamic_acceleration)
                .value_or(absent);
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

double front_width(double criterion) {
    return front_tolerance * std::abs(criterion);
}

bool dominates(const Contender& winner, const Contender& loser) {
    bool better = false;
    for (std::size_t i = 0; i < winner.criteria.size(); ++i) {
        const double width = front_width(loser.criteria[i]);
        if (winner.criteria[i] > loser.criteria[i] + width) return false;
        if (winner.criteria[i] < loser.criteria[i] - width) better = true;
    }
    return better;
}

/// Contenders in boxes within boxes, halved by one criterion after another: most boxes hold nobody who could
/// dominate, so a million rows are compared in seconds and not in the square of their number.
class FrontTree {
 public:
    explicit FrontTree(std::vector<Contender>& contenders) : contenders_(contenders) {
        if (!contenders.empty()) build(0, contenders.size(), 0);
    }

    [[nodiscard]] bool has_winner_over(const Contender& loser) const {
        return !boxes_.empty() && holds_winner(0, loser);
    }

 private:
    static constexpr std::size_t most_in_leaf = 8;

    struct Box {
        std::size_t begin = 0, end = 0;    ///< of the contenders
        std::size_t lower = 0, upper = 0;  ///< boxes of its halves; 0: none
        std::vector<double> least;         ///< by criterion
    };

    /// What is absent is never worse: it bounds nothing.
    static double bound(double criterion) {
        return std::isnan(criterion) ? -std::numeric_limits<double>::infinity() : criterion;
    }

    std::size_t build(std::size_t begin, std::size_t end, std::size_t criterion) {
        const std::size_t number = boxes_.size();
        Box box{begin, end, 0, 0, {}};
        for (const double value : contenders_[begin].criteria) box.least.push_back(bound(value));
        for (std::size_t k = begin + 1; k < end; ++k)
            for (std::size_t i = 0; i < box.least.size(); ++i)
                box.least[i] = std::min(box.least[i], bound(contenders_[k].criteria[i]));
        const std::size_t criteria = box.least.size();
        boxes_.push_back(std::move(box));
        if (end - begin <= most_in_leaf || criteria == 0) return number;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t k) { return contenders_.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(begin), at(middle), at(end), [&](const Contender& one, const Contender& other) {
            return bound(one.criteria[criterion]) < bound(other.criteria[criterion]);
        });
        const std::size_t next = (criterion + 1) % criteria;
        const std::size_t lower = build(begin, middle, next), upper = build(middle, end, next);
        boxes_[number].lower = lower;
        boxes_[number].upper = upper;
        return number;
    }

    /// False: whoever is in the box is worse in something, or nobody in it is better in anything.
    static bool may_hold_winner(const Box& box, const Contender& loser) {
        bool better = false;
        for (std::size_t i = 0; i < box.least.size(); ++i) {
            const double width = front_width(loser.criteria[i]);
            if (box.least[i] > loser.criteria[i] + width) return false;
            if (box.least[i] < loser.criteria[i] - width) better = true;
        }
        return better;
    }

    [[nodiscard]] bool holds_winner(std::size_t number, const Contender& loser) const {
        const Box& box = boxes_[number];
        if (!may_hold_winner(box, loser)) return false;
        if (box.upper != 0) return holds_winner(box.lower, loser) || holds_winner(box.upper, loser);
        for (std::size_t k = box.begin; k < box.end; ++k)
            if (dominates(contenders_[k], loser)) return true;
        return false;
    }

    std::vector<Contender>& contenders_;
    std::vector<Box> boxes_;
};

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
    for (auto& [question, contenders] : questions) {
        const FrontTree tree(contenders);
        for (const Contender& one : contenders) one.row->on_front = !tree.has_winner_over(one);
    }
}

}  // namespace camopt
